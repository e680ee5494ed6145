// SPDX-License-Identifier: Apache-2.0
// The module in headless Chromium, without the page that plays.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../', import.meta.url));
const { chromium } = createRequire(`${root}viewer/package.json`)('playwright-core');

/** Of fairway.wasm in `bytes`: `ask(work, given)` answers with what `work(simulator, given)` comes to there. */
export async function chromium_simulator(bytes) {
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true, args: ['--no-sandbox'] });
  const page = await browser.newPage();
  page.setDefaultTimeout(0);
  const source = readFileSync(`${root}bindings/web/module.mjs`, 'utf8').replace('export class', 'class');
  await page.addScriptTag({ content: `${source}\nwindow.Simulator = Simulator;` });
  await page.evaluate(async (packed) => {
    const module = await WebAssembly.compile(Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0)));
    window.simulator = new window.Simulator(module);
  }, bytes.toString('base64'));
  return {
    ask: (work, given) => page.evaluate(`(${work})(window.simulator, ${JSON.stringify(given)})`),
    end: () => browser.close(),
  };
}
