// SPDX-License-Identifier: Apache-2.0
// Opens a page of `fairway view` in a real browser from file:// and looks at it as a reader would.
//
//   node tests/web/view.mjs [PAGE.html] [--screenshots DIR]
//
// Without a file, the committed template is filled with the sample (sample_playback.mjs); broken documents, links to
// a moment and a live run are tried as well. CHECKS=word leaves out the checks of a page without that word in their name.
// Ends with 0 when every check held, else with 1 and a list of those that did not.
import { join } from 'node:path';
import { Browser, command_line } from './browser.mjs';
import { look_at_divergence, look_at_live } from './live_checks.mjs';
import { playback } from './sample_playback.mjs';
import { checks, phone_checks, theme_checks } from './view_checks.mjs';
import { desk, ViewPage } from './view_page.mjs';

const { path: given, screenshots } = command_line();
// Chromium remarks on reading back what its software renderer drew.
const browser = new Browser('fairway/view/template.html', ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'], /GPU stall|GL Driver Message/);

async function look_at_page(path, name, options, chosen) {
  await browser.open(path, name, options, async (page, expect) => {
    const view = new ViewPage(page);
    console.log(`${name}: the first picture after ${(await view.first_picture()).toFixed(2)} s`);
    if (screenshots !== null) await page.screenshot({ path: join(screenshots, `view-${name.replace(/\W+/g, '-')}.png`) });
    const only = process.env.CHECKS;
    for (const check of chosen) {
      if (only !== undefined && !check.name.includes(only)) continue;
      try {
        await check(view, expect, options);
      } catch (error) {
        expect(false, `${check.name} stopped: ${error.message.split('\n')[0]}`);
      }
    }
  });
}

async function look_at_every_side(path) {
  await look_at_page(path, 'light', { ...desk, scheme: 'light' }, checks);
  await look_at_page(path, 'dark', { ...desk, scheme: 'dark' }, theme_checks);
  await look_at_page(path, 'phone', { width: 390, height: 844, scheme: 'light' }, phone_checks);
}

async function look_at_links(path) {
  const options = { ...desk, scheme: 'light', fragment: '#t=12.5&v=2&camera=top' };
  await browser.open(path, 'a link', options, async (page, expect) => {
    await page.waitForFunction(() => window.fairway !== undefined);
    const view = new ViewPage(page);
    const { time_text, camera, chosen } = await view.state();
    expect(time_text === '12.500' && camera === 'top' && chosen.join() === '2', `it opens at ${time_text}, ${camera}, ${chosen}`);
    await view.seek_frame(300);
    await page.waitForFunction(() => location.hash.includes('t=30.000'), null, { timeout: 20000 }).catch(() => undefined);
    const address = await page.evaluate(() => location.hash);
    expect(address === '#t=30.000&v=2&camera=top', `the address is ${address}`);
    await page.evaluate(() => { location.hash = '#t=7.3'; });
    const moved = page.waitForFunction(() => window.fairway.state().time_text === '7.300', null, { timeout: 20000 });
    expect(await moved.then(() => true, () => false), 'a changed address does not move time');
  });
}

/** Small, as every one is opened anew. */
function brief(sample) {
  return { ...sample, film: { ...sample.film, thoughts: '' } };
}

/** Documents that cannot be shown, and what the page then says. */
function broken(sample) {
  const without = (change) => {
    const document = structuredClone(sample);
    change(document);
    return JSON.stringify(document);
  };
  return {
    'not JSON': ['{"title": ', 'not JSON'],
    'a list': ['[]', 'expected an object'],
    'an unfilled template': ['__NOTHING__', 'empty template'],
    'no title': [without((d) => delete d.title), 'title: expected text, found nothing'],
    'no vehicles': [without((d) => { d.scene.vehicles = []; }), 'scene.vehicles: expected 1 to'],
    'an unknown shape': [without((d) => { d.scene.vehicles[1].shape = 'whale'; }), 'scene.vehicles[1].shape: expected one of auv,'],
    'a hull without length': [without((d) => { d.scene.vehicles[0].length_m = 0; }), 'scene.vehicles[0].length_m: expected a number above 0'],
    'a missing column': [without((d) => d.columns.splice(2, 1)), 'the column position_m is missing'],
    'a column of another kind': [without((d) => { d.columns[2].type = 'f32'; }), 'position_m has 3 f32 per vehicle, expected 3 f64'],
    'a film cut short': [without((d) => { d.film.data = d.film.data.slice(0, 4000); }), 'film: a part of the film is too short'],
    'a film that is not base64': [without((d) => { d.film.data = '!'; }), 'film: '],
    'bytes that are not zstd': [without((d) => { d.film.compression = 'zstd'; }), 'film: '],
    'a film without frames': [without((d) => { Object.assign(d.film, { count: 0, data: '', thoughts: '', events: [] }); }), 'film: it has no frames'],
    'an event of nobody': [without((d) => { d.film.events[0].vehicle = 6; }), 'film.events[0].vehicle: expected a whole number from 0 to 5'],
    'an unknown compression': [without((d) => { d.film.compression = 'rar'; }), 'film.compression: expected one of none, zstd'],
    'an explanation without words': [without((d) => delete d.explanation.headline), 'explanation.headline: expected text'],
  };
}

async function look_at_broken(sample) {
  const cases = Object.entries(broken(brief(sample)));
  // One window for all: each is a page of its own all the same.
  const first = browser.write('broken.html', cases[0][1][0]);
  await browser.open(first, 'broken documents', { ...desk, scheme: 'light' }, async (page, expect) => {
    for (const [name, [json, said]] of cases) {
      browser.write('broken.html', json);
      await page.reload();
      const text = await page.innerText('#page');
      expect(text.includes('cannot be shown') && text.includes(said), `${name}: "${said}" is not on the page, which says: ${text.slice(0, 240)}`);
    }
  });
}

async function look_at_markup(sample) {
  const marked = structuredClone(brief(sample));
  marked.title = '</script><img src=x onerror=alert(1)>';
  marked.scene.vehicles[0].name = '<b>bold</b>';
  await browser.open(browser.write('markup.html', JSON.stringify(marked)), 'markup in texts', { ...desk, scheme: 'light' }, async (page, expect) => {
    await page.waitForFunction(() => window.fairway !== undefined);
    const text = await page.innerText('#page');
    expect(text.includes('<img src=x') && text.includes('<b>bold</b>'), 'texts are not shown as they are');
    expect(await page.locator('#page img[src="x"]').count() === 0, 'a text became markup');
  });
}

/** Names longer than the picture end in an ellipsis, in it and in the charts' legend. */
async function look_at_long_names(sample) {
  const named = structuredClone(brief(sample));
  named.scene.vehicles.forEach((vehicle, k) => { vehicle.name = `vehicle_${k}_${'of_a_long_name_'.repeat(16)}`; });
  await browser.open(browser.write('long.html', JSON.stringify(named)), 'long names', { ...desk, scheme: 'light' }, async (page, expect) => {
    await page.waitForFunction(() => document.querySelector('.stage-label.name') !== null);
    const labels = await page.locator('.stage-label.name:visible').evaluateAll((all) => all.map((label) => ({ text: label.textContent, width: label.offsetWidth })));
    expect(labels.length > 0 && labels.every(({ text, width }) => text.endsWith('…') && width <= 230), `in the picture: ${JSON.stringify(labels)}`);
    await page.locator('summary', { hasText: 'Charts' }).first().click();
    await page.waitForFunction((count) => document.querySelectorAll('.vehicle-key li span').length === count, named.scene.vehicles.length);
    const entries = await page.locator('.vehicle-key li span').evaluateAll((all) => all.map((name) => name.scrollWidth > name.clientWidth && name.clientWidth < 320));
    expect(entries.length === named.scene.vehicles.length && entries.every(Boolean), `in the legend: ${entries}`);
  });
}

if (given !== null) {
  await look_at_every_side(given);
} else {
  const path = browser.write('view.html', JSON.stringify(playback));
  await look_at_every_side(path);
  await look_at_links(path);
  await look_at_broken(playback);
  await look_at_markup(playback);
  await look_at_long_names(playback);
  await look_at_live(browser, playback);
  await look_at_divergence(browser, playback);
}
browser.finish();
