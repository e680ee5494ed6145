// SPDX-License-Identifier: Apache-2.0
// Opens a report in a real browser from file:// and looks at it as a reader would.
//
//   node tests/web/report.mjs [REPORT.html] [--screenshots DIR]
//
// Without a file, the committed template is filled with rasters of known pixels, known runs and a few broken documents. Ends with 0 when every check held, else with 1 and a list of those that did not.
import { join } from 'node:path';
import { Browser, command_line } from './browser.mjs';
import { heat_report, look_at_heats, look_at_wide_heat, wide_heat_report } from './heat_checks.mjs';
import { front_report, look_at_fronts, look_at_linked } from './lines_checks.mjs';
import { look_at_rasters, raster_report } from './raster_checks.mjs';
import { checks } from './report_checks.mjs';
import { look_at_known_runs, run_checks, runs_report } from './runs_checks.mjs';

const { path: given, screenshots } = command_line();
const browser = new Browser('fairway/report/template.html', ['--disable-gpu']);

const sides = [[1280, 'light'], [400, 'dark']];

/** Charts are laid out anew a moment after the page has got its size. */
function open(path, name, options, look) {
  return browser.open(path, name, options, async (page, expect, context) => {
    await page.waitForTimeout(150);
    await look(page, expect, context);
  });
}

async function look_at_report(path, name = '') {
  for (const [width, scheme] of sides) {
    await open(path, `${name}${width} px, ${scheme}`, { width, scheme }, async (page, expect, context) => {
      if (screenshots !== null) {
        await page.screenshot({ path: join(screenshots, `report-${width}-${scheme}.png`), fullPage: true });
      }
      for (const check of [...checks, ...run_checks]) await check(page, expect, { width, scheme, context });
    });
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
  'a run that is not there': [
    '{"title":"x","runs":[{"command":"a","seeds":[1,2]}],"sections":[{"title":"A","blocks":[{"kind":"lines","title":"t","series":[],' +
    '"runs":[[0,2]]}]}]}', 'blocks[0].runs[0][1]: expected a whole number from 0 to 1, found the number 2'],
  'values for other runs': [
    '{"title":"x","runs":[{"command":"a","seeds":[1,2]}],"sections":[{"title":"A","blocks":[{"kind":"table","columns":[{"key":"a"}],' +
    '"rows":[{"a":1,"$runs":[0,1],"$values":[1,2,3]}]}]}]}', 'rows[0].$values: 3 entries for 2 runs'],
  'a playback elsewhere': [
    '{"title":"x","runs":[{"command":"a","seeds":[1],"playbacks":{"0":"javascript:alert(1)//.html"}}],"sections":[]}',
    'runs[0].playbacks.0: expected the path of a page below this one'],
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
          { kind: 'heat', title: 'h', categories: [], range: [0, 1], series: [] }, { kind: 'heat', title: 'h', categories: ['1'], range: [0, 0], series: [{ label: 'm', cells: [null] }] },
          { kind: 'intervals', title: 'i', categories: ['1'], series: [{ label: 'm', points: [null] }] },
          { kind: 'lines', title: 'l', series: [{ label: 'm', x: [], y: [] }, { label: 'one', x: [1], y: [0] }, { label: 'none', x: [1, 2], y: [null, null] }] },
          { kind: 'trajectories', title: 't', vehicles: [] }, { kind: 'trajectories', title: 't', vehicles: [{ label: 'still', n: [0], e: [0], d: [0], t: [0] }] },
          { kind: 'table', title: 'T', columns: [{ key: 'a' }], rows: [] }, { kind: 'grid', columns: 3, blocks: [] },
        ],
      }],
    }), 'nothing here'],
};

async function look_at_known_rasters() {
  const path = browser.write('raster.html', raster_report);
  for (const [width, scheme] of sides) {
    await open(path, `raster, ${width} px, ${scheme}`, { width, scheme }, look_at_rasters);
  }
}

async function look_at_broken() {
  for (const [name, [json, said]] of Object.entries(broken)) {
    await open(browser.write('broken.html', json), name, { width: 1280, scheme: 'light' }, async (page, expect) => {
      const text = await page.innerText('#page');
      expect(text.includes(said), `"${said}" is not on the page, which says: ${text.slice(0, 300)}`);
      expect(!/NaN|undefined/.test(await page.innerHTML('#page')), 'NaN on the page');
      expect(!text.includes('cannot be drawn'), 'a chart failed');
    });
  }
}

if (given !== null) {
  await look_at_report(given);
} else {
  await look_at_known_rasters();
  await open(browser.write('heat.html', heat_report), 'tables of colours', { width: 1280, scheme: 'light' }, look_at_heats);
  await open(browser.write('wide.html', wide_heat_report), 'a wide table of colours', { width: 390, scheme: 'light' }, look_at_wide_heat);
  const fronts = browser.write('fronts.html', front_report);
  await open(fronts, 'fronts', { width: 1280, scheme: 'light' }, look_at_fronts);
  await open(fronts, 'a link to a section', { width: 1280, scheme: 'light', fragment: '#last' }, look_at_linked);
  await open(fronts, 'a link that is no text', { width: 1280, scheme: 'light', fragment: '#50%' }, look_at_fronts);
  const known = browser.write('runs.html', runs_report);
  await open(known, 'known runs', { width: 1280, scheme: 'light' }, look_at_known_runs);
  await look_at_report(known, 'known runs, ');
  await look_at_broken();
}
browser.finish();
