// SPDX-License-Identifier: Apache-2.0
// What a visitor of out/play.html does, for the checks of the page.
import { join } from 'node:path';
import { Browser, command_line, root } from '../web/browser.mjs';

const { screenshots } = command_line();
export const browser = new Browser('out/play.html', ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'], /GPU stall|GL Driver Message/);
export const page_file = join(root, 'out/play.html');
export const desk = { width: 1280, height: 860, scheme: 'light' };
/** A desk whose browser draws no picture, which takes a third less time: for what looks at none. */
export const plain_desk = { ...desk, missing: 'WebGL', harmless: /WebGL/ };
export const phone = { width: 390, height: 844, scheme: 'dark' };

export const keep = async (page, name) => {
  if (screenshots !== null) await page.screenshot({ path: join(screenshots, `play-${name}.png`), timeout: 120_000 });
};
/** The playback inside, of the run or of the one beside it, once it has a film. */
export async function playback(page, index = 0) {
  for (;;) {
    await page.waitForFunction((i) => document.querySelectorAll('iframe')[i] !== undefined, index);
    const frame = await (await page.locator('iframe').nth(index).elementHandle()).contentFrame();
    try {
      await frame.waitForFunction(() => window.fairway?.film.count > 0);
      return frame;
    } catch (error) {
      // A newer run may have taken its place.
      if (frame !== null && !frame.isDetached()) throw error;
    }
  }
}
export const is_at = (frame, time) => frame.waitForFunction((at) => Math.abs(window.fairway.state().time - at) < 0.06, time);
/** Stands at this time, once so much of the run is there. */
export async function stand_at(frame, time) {
  await frame.evaluate((at) => { window.fairway.pause(); window.fairway.seek(at); }, time);
  await is_at(frame, time);
}
export const choose = (page, label, value) => page.getByLabel(label, { exact: true }).first().selectOption(value);
export const ended = (page) => page.waitForSelector('.measures');
export const measure = (page, name, column = 1) => page.locator('.measures tr', { hasText: name }).locator('td').nth(column).textContent();
/** When the page shows the run of this command. */
export const commanded = (page, text) => page.waitForFunction((part) => document.querySelector('.command')?.textContent.includes(part), text);
export const complaint = async (page) => {
  await page.waitForSelector('.note.problem:not([hidden])');
  return page.locator('.note.problem p').textContent();
};
export const packed = async (state) => Buffer.from(await new Response(new Blob([JSON.stringify(state)]).stream()
  .pipeThrough(new CompressionStream('deflate-raw'))).arrayBuffer()).toString('base64url');

/** Does each check [what, options] of a browser of its own; CHECKS in the environment names some of them. */
export async function look_at(checks) {
  for (const [check, options] of checks) {
    if (process.env.CHECKS !== undefined && !check.name.includes(process.env.CHECKS)) continue;
    await browser.open(page_file, check.name, options, check);
  }
  browser.finish();
}
