// SPDX-License-Identifier: Apache-2.0
// A recording as an independent viewer of MCAP shows it, photographed:
//   node picture.mjs RECORDING SECONDS END PICTURE.png
// SECONDS is the moment that is shown, END when the run ends. The viewer and the recording are served on the loopback
// address to a browser that shows nobody anything.
import { readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = fileURLToPath(new URL('.', import.meta.url));
const { chromium } = createRequire(join(here, '../../viewer/package.json'))('playwright-core');
const [recording, seconds, end, picture] = process.argv.slice(2);
if (picture === undefined) {
  console.error('node picture.mjs RECORDING SECONDS END PICTURE.png');
  process.exit(2);
}

const page_text = `<!doctype html><meta charset="utf-8"><title>recording</title>
<style>html, body { margin: 0; height: 100%; overflow: hidden } canvas { display: block; width: 100% !important; height: 100vh !important }</style>
<script type="module">
import { WebViewer } from './viewer/index.js';
const viewer = new WebViewer();
window.opened = new Promise((resolve) => viewer.on('recording_open', resolve));
window.viewer = viewer;
await viewer.start(new URL('run.mcap', location.href).href, document.body,
  { hide_welcome_screen: true, theme: 'light', render_backend: 'webgl', width: '100%', height: '100%' });
</script>`;
const types = { '.js': 'text/javascript', '.wasm': 'application/wasm', '.mcap': 'application/octet-stream' };
const server = createServer((request, answer) => {
  const path = new URL(request.url, 'http://127.0.0.1').pathname;
  try {
    const part = path.match(/^\/viewer\/([\w.-]+)$/);
    const body = path === '/' ? page_text
      : path === '/run.mcap' ? readFileSync(recording)
      : readFileSync(join(here, 'node_modules/@rerun-io/web-viewer', extname(part[1]) === '' ? `${part[1]}.js` : part[1]));
    answer.writeHead(200, { 'content-type': path === '/' ? 'text/html' : types[extname(path)] ?? 'text/javascript' }).end(body);
  } catch {
    answer.writeHead(404).end();
  }
});
await new Promise((ready) => server.listen(0, '127.0.0.1', ready));

/** The processor draws it: that may take long. */
const picture_of = (page) => page.screenshot({ type: 'png', timeout: 300_000, clip: { x: 0, y: 28, width: 1440, height: 872 } });

/** It draws when something happens, and else sleeps. */
let pointer = [700, 400];
async function wake(page) {
  for (let i = 0; i < 3; ++i) {
    await page.mouse.move(pointer[0] + i % 2, pointer[1]);
    await page.waitForTimeout(100);
  }
}

/** Waits until the picture stands still, and gives it; without the bar on top, which shows how late it is. */
async function settle(page) {
  let last = await picture_of(page);
  for (let tries = 0; tries < 6; ++tries) {
    await wake(page);
    const now = await picture_of(page);
    if (now.equals(last)) break;
    last = now;
  }
  return last;
}

/** A click as slow as the pictures come, repeated where it was lost between two of them. */
async function press(page, x, y) {
  pointer = [x, y];
  const before = await settle(page);
  for (let tries = 0; tries < 3; ++tries) {
    await page.mouse.down();
    await page.waitForTimeout(500);
    await page.mouse.up();
    await page.waitForTimeout(500);
    const after = await settle(page);
    if (!after.equals(before)) return;
  }
  throw new Error(`nothing happens at ${x}, ${y}: is it another version of the viewer?`);
}

/** By hand, for it has no other way: a view in space of the frame of the recording, with axes for each pose of /tf. */
async function show_vehicles(page) {
  await settle(page);
  await press(page, 181, 200);  // the blueprint's menu
  await press(page, 272, 227);  // add a view,
  await press(page, 565, 384);  // in space
  await press(page, 52, 248);  // its properties:
  await press(page, 1358, 447);  // the frame
  await page.keyboard.press('Control+A');
  await page.waitForTimeout(1000);
  await page.keyboard.type('world_ned', { delay: 200 });
  await page.waitForTimeout(1000);
  await page.keyboard.press('Enter');
  await settle(page);
  await press(page, 19, 248);  // what is in it
  await press(page, 37, 272);
  pointer = [104, 518];
  await wake(page);
  await page.mouse.wheel(0, 2000);
  await settle(page);
  await press(page, 88, 616);  // tf
  await press(page, 1419, 548);  // shown as
  await press(page, 1343, 806);  // axes
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true,
  args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
try {
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  page.on('pageerror', (error) => console.error(error.message));
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  const { recording_id: id } = await page.evaluate(() => window.opened);
  // it reads on in the background, a piece for each picture that it draws
  const read_until = () => page.evaluate(
    (of) => window.viewer.get_time_range(of, window.viewer.get_active_timeline(of))?.max ?? 0, id);
  while (await read_until() < Number(end) * 1e9) await wake(page);
  await page.evaluate(([of, time]) => {
    window.viewer.set_playing(of, false);
    window.viewer.set_current_time(of, window.viewer.get_active_timeline(of), time * 1e9);
  }, [id, Number(seconds)]);
  await show_vehicles(page);
  await page.evaluate(() => window.viewer.override_panel_state('selection', 'hidden'));
  await settle(page);
  writeFileSync(picture, await page.screenshot({ type: 'png', timeout: 300_000 }));
} finally {
  await browser.close();
  server.close();
}
