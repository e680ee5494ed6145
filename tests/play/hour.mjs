// SPDX-License-Identifier: Apache-2.0
// An hour of play in out/play.html: runs of swap_8 under one seed after another, each simulated to its end and its last minute played quickly, until
// their simulated times add up to an hour. Prints what the renderer holds after each tenth of it. A measurement, no test:
// node tests/play/hour.mjs [SECONDS].
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../', import.meta.url));
const { chromium } = createRequire(`${root}viewer/package.json`)('playwright-core');
const whole_s = Number(process.argv[2] ?? 3600);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--js-flags=--expose-gc'],
});
const page = await browser.newPage();
page.setDefaultTimeout(120_000);
await page.goto(`file://${root}out/play.html`);
const session = await page.context().newCDPSession(page);
const processes = await browser.newBrowserCDPSession();

async function held() {
  await session.send('HeapProfiler.collectGarbage');
  await session.send('Memory.simulatePressureNotification', { level: 'critical' });
  await new Promise((resume) => setTimeout(resume, 500));
  const { metrics } = await session.send('Performance.getMetrics');
  const of = (name) => metrics.find((metric) => metric.name === name).value;
  const { processInfo } = await processes.send('SystemInfo.getProcessInfo');
  const resident_kb = processInfo.filter(({ type }) => type === 'renderer')
    .map(({ id }) => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`, 'utf8'))[1])).reduce((sum, kb) => sum + kb, 0);
  return { heap_mb: of('JSHeapUsedSize') / 1e6, nodes: of('Nodes'), frames: of('Frames'), resident_mb: resident_kb / 1e3 };
}
await session.send('Performance.enable');

let simulated_s = 0;
let said = 0;
const begun = performance.now();
for (let seed = 1; simulated_s < whole_s; ++seed) {
  await page.getByLabel('Seed', { exact: true }).fill(String(seed));
  await page.getByLabel('Seed', { exact: true }).blur();
  await page.waitForFunction((text) => document.querySelector('.command')?.textContent.endsWith(text), `--seed ${seed}`);
  // Whoever holds an element keeps it in memory.
  const handle = await page.locator('iframe').elementHandle();
  const frame = await handle.contentFrame();
  await handle.dispose();
  await (await page.waitForSelector('.measures')).dispose();
  simulated_s += await frame.evaluate(async () => {
    window.fairway.seek(window.fairway.film.end - 60);
    window.fairway.play();
    await new Promise((resume) => setTimeout(resume, 1000));
    return window.fairway.film.end;
  });
  if (simulated_s < said * whole_s / 10) continue;
  const { heap_mb, nodes, frames, resident_mb } = await held();
  console.log(`${simulated_s.toFixed(0)} s simulated in ${seed} runs, ${((performance.now() - begun) / 1000).toFixed(0)} s of clock: heap of the page ${heap_mb.toFixed(1)} MB, `
    + `${nodes} nodes, ${frames} frames; renderer, Worker and module with it, ${resident_mb.toFixed(0)} MB`);
  said = Math.floor(simulated_s / (whole_s / 10)) + 1;
}
await browser.close();
