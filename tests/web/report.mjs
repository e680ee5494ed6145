// SPDX-License-Identifier: Apache-2.0
// Opens a report in a real browser from file:// and looks at it as a reader would.
//
//   node tests/web/report.mjs [REPORT.html] [--screenshots DIR]
//
// Without a file, the committed template is filled with viewer/sample/report.json; rasters of known pixels and a few broken
// documents are opened as well. Needs `npm ci` in viewer/ and a Chromium (CHROMIUM names another one than
// /usr/bin/chromium). Ends with 0 when every check held, else with 1 and a list of those that did not.
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { look_at_rasters, raster_report } from './raster_checks.mjs';
import { checks } from './report_checks.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const { chromium } = createRequire(join(root, 'viewer/package.json'))('playwright-core');

const words = process.argv.slice(2);
const flag = words.indexOf('--screenshots');
const screenshots = flag < 0 ? null : resolve(words.splice(flag, 2)[1] ?? '.');
if (screenshots !== null) mkdirSync(screenshots, { recursive: true });

const folder = mkdtempSync(join(tmpdir(), 'fairway-web-'));
const failures = [];
let held = 0;

function render(json) {
  const safe = json.replaceAll('</', '<\\/').replaceAll('<!', '\\u003c!');
  return readFileSync(join(root, 'fairway/report/template.html'), 'utf8').replace('__FAIRWAY_DATA__', () => safe);
}

function write(name, json) {
  const path = join(folder, name);
  writeFileSync(path, render(json));
  return path;
}

/** Opens the page in a fresh profile and hands it, with whatever it complained about, to `look`. */
async function open(path, name, { width, height = 900, scheme }, look) {
  const profile = mkdtempSync(join(folder, 'profile-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true,
    viewport: { width, height }, colorScheme: scheme, acceptDownloads: true,
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--disable-gpu', '--disable-background-networking',
      '--disable-component-update', '--disable-sync', '--no-first-run'],
  });
  const complaints = [];
  try {
    const page = context.pages()[0] ?? await context.newPage();
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) complaints.push(`console ${message.type()}: ${message.text()}`);
    });
    page.on('pageerror', (error) => complaints.push(`page error: ${error.message}`));
    page.on('request', (request) => {
      if (!/^(file|data|blob):/.test(request.url())) complaints.push(`network request: ${request.url()}`);
    });
    const expect = (condition, what) => {
      if (condition) ++held;
      else failures.push(`${name}: ${what}`);
    };
    await page.goto(pathToFileURL(path).href);
    await page.waitForSelector('main');
    await page.evaluate(() => document.fonts.ready);
    await page.waitForTimeout(150);
    await look(page, expect, context);
    expect(complaints.length === 0, complaints.join('; '));
  } finally {
    await context.close();
  }
}

async function look_at_report(path) {
  for (const width of [1280, 400]) {
    for (const scheme of ['light', 'dark']) {
      const name = `${width} px, ${scheme}`;
      await open(path, name, { width, scheme }, async (page, expect, context) => {
        if (screenshots !== null) {
          await page.screenshot({ path: join(screenshots, `report-${width}-${scheme}.png`), fullPage: true });
        }
        for (const check of checks) await check(page, expect, { width, scheme, context });
      });
    }
  }
}

const broken = {
  'not JSON': ['{"title": ', 'not JSON'],
  'a list': ['[]', 'expected an object'],
  'no sections': ['{"title":"x"}', 'sections'],
  'an unfilled template': ['__NOTHING__', 'empty template'],
  'an unknown block': ['{"title":"x","sections":[{"id":"a","title":"A","blocks":[{"kind":"pie"}]}]}', 'blocks[0].kind'],
  'a box without quartiles': [
    '{"title":"x","sections":[{"title":"A","blocks":[{"kind":"boxes","title":"t","categories":["1"],"series":' +
    '[{"label":"m","boxes":[{"median":1}]}]}]}]}', 'series[0].boxes[0].min'],
  'markup in texts': [
    JSON.stringify({
      title: '</script><img src=x onerror=alert(1)>', subtitle: '<!-- <script>',
      sections: [{ title: '<b>bold</b>', blocks: [{ kind: 'note', text: '<i>not slanted</i>' }] }],
    }), '<b>bold</b>'],
  'charts without data': [
    JSON.stringify({
      title: 'empty', sections: [{
        title: 'nothing here', blocks: [
          { kind: 'boxes', title: 'b', categories: [], series: [] }, { kind: 'boxes', title: 'b', categories: ['1'], series: [{ label: 'm', boxes: [null] }] },
          { kind: 'intervals', title: 'i', categories: ['1'], series: [{ label: 'm', points: [null] }] },
          { kind: 'lines', title: 'l', series: [{ label: 'm', x: [], y: [] }, { label: 'one', x: [1], y: [0] }, { label: 'none', x: [1, 2], y: [null, null] }] },
          { kind: 'trajectories', title: 't', vehicles: [] }, { kind: 'trajectories', title: 't', vehicles: [{ label: 'still', n: [0], e: [0], d: [0], t: [0] }] },
          { kind: 'table', title: 'T', columns: [{ key: 'a' }], rows: [] }, { kind: 'grid', columns: 3, blocks: [] },
        ],
      }],
    }), 'nothing here'],
};

async function look_at_known_rasters() {
  const path = write('raster.html', raster_report);
  for (const [width, scheme] of [[1280, 'light'], [400, 'dark']]) {
    await open(path, `raster, ${width} px, ${scheme}`, { width, scheme }, look_at_rasters);
  }
}

async function look_at_broken() {
  for (const [name, [json, said]] of Object.entries(broken)) {
    await open(write('broken.html', json), name, { width: 1280, scheme: 'light' }, async (page, expect) => {
      const text = await page.innerText('#page');
      expect(text.includes(said), `"${said}" is not on the page, which says: ${text.slice(0, 300)}`);
      expect(!/NaN|undefined/.test(await page.innerHTML('#page')), 'NaN on the page');
      expect(!text.includes('cannot be drawn'), 'a chart failed');
    });
  }
}

try {
  if (words[0] !== undefined) {
    await look_at_report(resolve(words[0]));
  } else {
    await look_at_report(write('report.html', readFileSync(join(root, 'viewer/sample/report.json'), 'utf8')));
    await look_at_known_rasters();
    await look_at_broken();
  }
} finally {
  rmSync(folder, { recursive: true, force: true });
}
for (const failure of failures) console.log(`FAILED ${failure}`);
console.log(`${held} checks held, ${failures.length} failed`);
process.exit(failures.length === 0 ? 0 : 1);
