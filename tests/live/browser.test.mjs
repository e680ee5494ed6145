// SPDX-License-Identifier: Apache-2.0
// The page that a run serves, in a real browser: the one thing that the browser's own rules are needed for.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { interrupt, start, state, until } from './client.mjs';

const { chromium } = createRequire(fileURLToPath(new URL('../../viewer/package.json', import.meta.url)))('playwright-core');
let browser;
let run;
before(async () => {
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true,
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  run = await start('--speed', '4');
});
after(async () => {
  await browser.close();
  run.child.kill('SIGKILL');
});

test('the page follows the run, pauses it, steps it and lets it go on', { timeout: 40_000 }, async () => {
  const page = await browser.newPage();
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (line) => line.type() === 'error' && complaints.push(line.text()));
  await page.goto(`http://127.0.0.1:${run.port}/`);
  await page.waitForFunction(() => window.fairway?.film.count > 20);
  await page.getByRole('button', { name: 'Pause run' }).click();
  await until(async () => (await state(run)).paused, 'the run to pause');
  await page.getByRole('button', { name: 'Resume run' }).waitFor();

  const { time_s } = await state(run);
  await page.waitForFunction((time) => window.fairway.film.end === time, time_s);
  await page.getByRole('button', { name: 'Step run' }).click();
  await page.waitForFunction((time) => window.fairway.film.end > time, time_s);
  assert.ok((await state(run)).time_s - time_s < 0.06, 'one step');
  await page.getByRole('button', { name: 'Resume run' }).click();
  await until(async () => (await state(run)).time_s > time_s + 1, 'the run to go on');
  assert.deepEqual(complaints, []);
  await page.close();
});

test('a page of another origin neither reads the run nor changes it', { timeout: 40_000 }, async () => {
  const foreign = createServer((_, answer) => answer.end('<!doctype html><title>foreign</title>'));
  await new Promise((ready) => foreign.listen(0, '127.0.0.1', ready));
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${foreign.address().port}/`);
  const outcomes = await page.evaluate(async (port) => {
    const tried = async (path, how) => {
      try {
        const answer = await fetch(`http://127.0.0.1:${port}${path}`, how);
        return answer.type === 'opaque' ? 'opaque' : `read ${answer.status}`;
      } catch {
        return 'refused';
      }
    };
    return [
      await tried('/part?from=0&generation=0', {}),
      await tried('/part?from=0&generation=0', { mode: 'no-cors' }),
      await tried('/pause', { method: 'POST', headers: { 'X-Fairway': '1' } }),
      await tried('/pause', { method: 'POST', mode: 'no-cors' }),
    ];
  }, run.port);
  assert.deepEqual(outcomes, ['refused', 'refused', 'refused', 'refused']);
  assert.equal((await state(run)).paused, false);
  foreign.close();
  assert.equal(await interrupt(run), 130);
});
