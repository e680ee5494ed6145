// SPDX-License-Identifier: Apache-2.0
// What must hold on every report. Each check gets the page, `expect(condition, what)` and how it was opened.
import { readFileSync } from 'node:fs';

async function nothing_overflows(page, expect, { width }) {
  const widths = await page.evaluate(() => {
    const root = document.documentElement;
    const wide = [...document.querySelectorAll('#page *')].filter((element) =>
      element.closest('.table-scroll, .command, svg, .offscreen, .skip') === null && element.getBoundingClientRect().right > root.clientWidth + 1);
    return { scroll: root.scrollWidth, client: root.clientWidth, wide: wide.slice(0, 3).map((e) => `${e.tagName}.${e.className}`) };
  });
  expect(widths.scroll <= widths.client && widths.client <= width, `the page scrolls sideways: ${JSON.stringify(widths)}`);
  expect(widths.wide.length === 0, `beyond the right edge: ${widths.wide.join(', ')}`);
}

async function headings_and_links_are_sound(page, expect) {
  const found = await page.evaluate(() => {
    const ids = [...document.querySelectorAll('[id]')].map((element) => element.id);
    const links = [...document.querySelectorAll('a[href^="#"]')].map((link) => link.getAttribute('href').slice(1));
    return {
      h1: document.querySelectorAll('h1').length, sections: document.querySelectorAll('main section').length,
      h2: document.querySelectorAll('main section > h2').length, title: document.title,
      twice: ids.filter((id, i) => ids.indexOf(id) !== i), dead: links.filter((id) => !ids.includes(id)),
      nameless: [...document.querySelectorAll('button, select, input')].filter((element) =>
        !(element.getAttribute('aria-label') || element.closest('label') || element.textContent.trim())).length,
    };
  });
  expect(found.h1 === 1 && found.h2 === found.sections && found.sections > 0, `headings: ${JSON.stringify(found)}`);
  expect(found.title !== '' && found.title !== 'fairway report', 'the window has no title');
  expect(found.twice.length === 0, `ids twice: ${found.twice.join(', ')}`);
  expect(found.dead.length === 0, `links to nothing: ${found.dead.join(', ')}`);
  expect(found.nameless === 0, `${found.nameless} controls without a name`);
}

async function charts_are_drawn(page, expect, { width }) {
  const charts = await page.evaluate(() => [...document.querySelectorAll('.plot')].map((plot) => {
    const svg = plot.querySelector('svg');
    const name = plot.closest('figure').id;
    if (svg === null) return { name, drawn: false };
    const bad = [...svg.querySelectorAll('*')].filter((element) =>
      [...element.attributes].some(({ name, value }) => name !== 'href' && /NaN|Infinity|undefined/.test(value))).length;
    const shapes = [...svg.querySelectorAll('.marks path, .marks rect, .marks circle, .marks line, .marks image')];
    const boxes = shapes.map((shape) => shape.getBoundingClientRect());
    const frame = svg.getBoundingClientRect();
    const texts = [...svg.querySelectorAll('text')].map((text) => text.getBoundingClientRect());
    return {
      name, drawn: true, bad, shapes: shapes.length, sized: boxes.filter((box) => box.width + box.height > 0).length,
      left: Math.min(...boxes.map((box) => box.left)), right: Math.max(...boxes.map((box) => box.right)),
      label: (svg.getAttribute('aria-label') ?? '').length, frame: { width: frame.width, height: frame.height },
      texts_out: texts.filter((box) => box.left < frame.left - 2 || box.right > frame.right + 2).length,
    };
  }));
  expect(charts.length > 0, 'no chart');
  for (const chart of charts) {
    expect(chart.drawn, `${chart.name} is not drawn`);
    if (!chart.drawn) continue;
    expect(chart.bad === 0, `${chart.name} has attributes that are not numbers`);
    expect(chart.shapes > 0 && chart.sized > 0, `${chart.name} has ${chart.sized} visible marks`);
    expect(chart.frame.width > 100 && chart.frame.height > 100, `${chart.name} is ${JSON.stringify(chart.frame)}`);
    expect(chart.left >= 0 && chart.right <= width, `${chart.name} spans ${chart.left} to ${chart.right}`);
    expect(chart.label > 20, `${chart.name} has no description`);
    expect(chart.texts_out === 0, `${chart.name} has ${chart.texts_out} labels outside`);
  }
}

async function theme_follows_and_toggles(page, expect, { scheme }) {
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const dark = (colour) => Number(colour.match(/\d+/)[0]) < 100;
  expect(dark(await ground()) === (scheme === 'dark'), `the ground is ${await ground()}`);
  await page.click('.theme-toggle');
  expect(dark(await ground()) === (scheme === 'light'), 'the theme does not toggle');
  await page.click('.theme-toggle');
  expect(dark(await ground()) === (scheme === 'dark'), 'the theme does not toggle back');
}

/** On a wide window nobody has to scroll a table sideways for what it comes to. */
async function verdicts_are_in_sight(page, expect, { width }) {
  if (width < 1280) return;
  const beyond = await page.evaluate(() => [...document.querySelectorAll('.table-scroll')].flatMap((frame) => {
    const edge = frame.getBoundingClientRect().left + frame.clientWidth;
    return [...frame.querySelectorAll('thead th.verdict, tbody td.verdict')].map((cell) => cell.getBoundingClientRect().right - edge);
  }).filter((over) => over > 0.5));
  expect(beyond.length === 0, `${beyond.length} verdicts end up to ${Math.max(0, ...beyond)} px beyond their table`);
}

/** What can be done with a chart stands beside its legend and its caption, not on them. */
async function buttons_cover_nothing(page, expect) {
  const covered = await page.evaluate(() => [...document.querySelectorAll('figure:has(.plot)')].filter((figure) => {
    const buttons = [...figure.querySelectorAll('.actions button')].map((button) => button.getBoundingClientRect());
    const texts = [...figure.querySelectorAll('.legend .entry, figcaption')].map((text) => text.getBoundingClientRect());
    return buttons.some((a) => texts.some((b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1));
  }).map(({ id }) => id));
  expect(covered.length === 0, `buttons lie on text in ${covered.join(', ')}`);
}

/** Remarks are read without scrolling sideways. */
async function remarks_are_in_sight(page, expect) {
  const beyond = await page.evaluate(() => [...document.querySelectorAll('.table-scroll')].flatMap((frame) => {
    const edge = frame.getBoundingClientRect().left + frame.clientWidth;
    return [...frame.querySelectorAll('.remark div')].map((text) => text.getBoundingClientRect().right - edge);
  }).filter((over) => over > 0.5));
  expect(beyond.length === 0, `${beyond.length} remarks end up to ${Math.max(0, ...beyond)} px beyond their table`);
}

/** Labels under a chart tell its categories apart, however short they are cut. */
async function categories_read_differently(page, expect) {
  const alike = await page.evaluate(() => [...document.querySelectorAll('.chart-boxes svg, .chart-intervals svg')].filter((svg) => {
    const labels = [...svg.querySelectorAll('text.tick:not([text-anchor="end"]), text.tick[transform]')].map((text) => text.textContent);
    return new Set(labels).size < labels.length;
  }).map((svg) => svg.closest('figure').id));
  expect(alike.length === 0, `categories read alike in ${alike.join(', ')}`);
}

async function tables_sort_by_keyboard(page, expect) {
  const tables = page.locator('figure.table');
  let looked = 0;
  for (let i = 0; i < await tables.count(); ++i) {
    const table = tables.nth(i);
    const heads = table.locator('thead th.number');
    if (await heads.count() === 0 || await table.locator('tbody tr:not(.remark)').count() < 2) continue;
    looked += 1;
    const head = heads.first();
    const column = await head.evaluate((element) => [...element.parentElement.children].indexOf(element));
    const values = async () => (await table.locator(`tbody tr:not(.remark) > :nth-child(${column + 1})`).allInnerTexts())
      .map((text) => Number(text.replace('\u2212', '-').replaceAll('\u2009', ''))).filter((value) => !Number.isNaN(value));
    const sorted = (list, sign) => list.every((value, k) => k === 0 || sign * (value - list[k - 1]) >= 0);
    const before = await values();
    await head.locator('button').focus();
    await page.keyboard.press('Enter');
    expect(await head.getAttribute('aria-sort') === 'ascending' && sorted(await values(), 1), `table ${i} does not sort upwards`);
    await page.keyboard.press('Enter');
    expect(await head.getAttribute('aria-sort') === 'descending' && sorted(await values(), -1), `table ${i} does not sort downwards`);
    await page.keyboard.press('Enter');
    expect(String(await values()) === String(before), `table ${i} does not return to its order`);
  }
  expect(looked > 0, 'no table of numbers to sort');
}

async function tables_filter_and_tally(page, expect) {
  const select = page.locator('.filter select').first();
  if (await select.count() > 0) {
    const rows = page.locator('figure.table:has(.filter)').first().locator('tbody tr:not(.remark)');
    const all = await rows.count();
    await select.selectOption({ index: 1 });
    expect(await rows.count() < all, 'the filter keeps every row');
    await select.selectOption({ index: 0 });
    expect(await rows.count() === all, 'the filter does not let go');
  }
  const tally = page.locator('.tally-buttons').first();
  if (await tally.count() > 0) {
    const button = tally.locator('button').first();
    const rows = page.locator('figure.table:has(.tally)').first().locator('tbody tr:not(.remark)');
    await button.click();
    const said = Number(await button.locator('b').innerText());
    // Long tables draw their first 1000 rows and one that says so.
    expect(await rows.count() === Math.min(said, 1001), 'the tally and its rows disagree');
    await button.click();
  }
}

async function legends_toggle(page, expect) {
  const buttons = page.locator('.legend button');
  if (await buttons.count() === 0) return;
  const marks = () => page.evaluate(() => document.querySelectorAll('.plot .marks *').length);
  const before = await marks();
  await buttons.first().click();
  expect(await buttons.first().getAttribute('aria-pressed') === 'false', 'the legend does not show what is hidden');
  expect(await marks() < before, 'the legend hides nothing');
  await buttons.first().click();
  expect(await marks() === before, 'the legend does not bring the series back');
}

async function pointing_shows_values(page, expect) {
  for (const kind of ['boxes', 'intervals', 'lines', 'raster']) {
    const plot = page.locator(`.chart-${kind} .plot`).first();
    if (await plot.count() === 0) continue;
    await plot.scrollIntoViewIfNeeded();
    // Some place of these must be near a mark, whatever the number of categories.
    const box = await plot.boundingBox();
    let found = false;
    for (const part of [0.3, 0.4, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75]) {
      await page.mouse.move(box.x + box.width * part, box.y + box.height * 0.5);
      found ||= await page.locator('.tip:visible').count() === 1;
    }
    expect(found, `pointing at ${kind} shows nothing`);
    await page.mouse.move(0, 0);
    await plot.focus();
    await page.keyboard.press('ArrowRight');
    expect((await page.locator('.tip:visible td').allInnerTexts()).length > 0, `arrow keys in ${kind} show nothing`);
    await page.keyboard.press('Escape');
    expect(await page.locator('.tip:visible').count() === 0, `the tip of ${kind} stays`);
  }
}

/** Of each way the end is marked, and says when it was reached and where, as all the points before. */
async function trajectories_tell_time_and_place(page, expect) {
  const plot = page.locator('.chart-trajectories .plot').first();
  if (await plot.count() === 0) return;
  await plot.scrollIntoViewIfNeeded();
  const ways = await plot.locator('.curve').count();
  expect(ways > 0 && await plot.locator('.marks .dot').count() === ways && await plot.locator('.start').count() === ways,
    `${ways} ways have another number of ends`);
  const end = await plot.locator('.marks .dot').last().boundingBox();
  await page.mouse.move(end.x + end.width / 2, end.y + end.height / 2);
  const said = (await page.locator('.tip:visible').allInnerTexts()).join();
  expect(/time\s.* s\s+north, east, down\s.* m/.test(said), `the end of a way says ${said}`);
  await page.mouse.move(0, 0);
}

async function files_can_be_saved(page, expect) {
  const missing = await page.evaluate(() => ({
    charts: [...document.querySelectorAll('.plot')].filter((plot) =>
      ![...plot.closest('figure').querySelectorAll('.action')].some((button) => button.textContent === 'SVG')).length,
    tables: [...document.querySelectorAll('figure.table')].filter((table) =>
      ![...table.querySelectorAll('.action')].some((button) => button.textContent === 'CSV')).length,
  }));
  expect(missing.charts === 0 && missing.tables === 0, `without a save button: ${JSON.stringify(missing)}`);
  const save = async (button) => {
    const [download] = await Promise.all([page.waitForEvent('download'), button.click()]);
    return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') };
  };
  for (const kind of ['boxes', 'intervals', 'lines', 'raster', 'trajectories']) {
    const button = page.locator(`.chart-${kind} .action`, { hasText: 'SVG' }).first();
    if (await button.count() === 0) continue;
    const { name, text } = await save(button);
    const sound = await page.evaluate((svg) => {
      const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml');
      return parsed.querySelector('parsererror') === null && parsed.documentElement.localName === 'svg';
    }, text);
    expect(name.endsWith('.svg') && sound, `${name} is not an image`);
    expect(!/var\(|NaN|class=|undefined/.test(text.replace(/data:image[^"]*/g, '')) && text.includes('<text'), `${name} does not stand alone`);
  }
  const csv = page.locator('figure.table .action', { hasText: 'CSV' }).first();
  if (await csv.count() > 0) {
    const { name, text } = await save(csv);
    const rows = await page.locator('figure.table').first().locator('tbody tr:not(.remark)').count();
    expect(name.endsWith('.csv') && (rows > 1000 || text.trim().split('\r\n').length === rows + 1), `${name} has other rows than the table`);
  }
  const data = page.locator('.action', { hasText: 'Data' }).first();
  await data.click();
  expect(await page.locator('.data-panel:visible tbody tr').count() > 0, 'the numbers behind a chart do not show');
  await data.click();
}

export const checks = [
  nothing_overflows, headings_and_links_are_sound, charts_are_drawn, verdicts_are_in_sight, remarks_are_in_sight, buttons_cover_nothing,
  categories_read_differently,
  theme_follows_and_toggles, tables_sort_by_keyboard,
  tables_filter_and_tally, legends_toggle, pointing_shows_values, trajectories_tell_time_and_place, files_can_be_saved,
];
