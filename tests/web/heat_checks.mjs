// SPDX-License-Identifier: Apache-2.0
// A small table of colours, pointed at and clicked, and tables that must be refused.
import { closes } from './runs_checks.mjs';

const cell = (value, mark, runs) => ({ value, low: value - 0.1, high: value + 0.1, text: '1.20', mark, note: 'a note', runs: [runs], values: [-1, 3], values_label: 'clearance [m]' });
const heat = {
  kind: 'heat', title: 'Two by two', categories: ['cubes', 'mazes'], category_label: 'family', value_label: 'safe', text_label: 'time',
  range: [0, 1], unit: '%', see: ['cubes: clearance', 'mazes: clearance'], series: [{ label: 'orca3d', cells: [cell(1, '=', [0, 1]), null] }, { label: 'apf', cells: [cell(0, '', [2, 3]), cell(0.5, '', [0, 1])] }],
};
const refused = [
  [{ range: [0] }, 'range: 1 entries for 2 ends'],
  [{ series: [{ label: 'm', cells: [null] }] }, 'series[0].cells: 1 entries for 2 categories'],
  [{ series: [{ label: 'm', cells: [null, { value: 'x' }] }] }, 'series[0].cells[1].value: expected a number'],
];
export const heat_report = JSON.stringify({
  title: 'Heats', runs: [{ label: 'a', command: 'fairway run a --seed ', seeds: [7, 8] }, { label: 'b', command: 'fairway run b --seed ', seeds: [7, 8] }],
  sections: [{ title: 'A', blocks: [heat, ...refused.map(([change]) => ({ ...heat, ...change })), ...['cubes', 'mazes'].map((family) =>
    ({ kind: 'lines', title: `${family}: clearance`, x_label: 'x', y_label: 'y', series: [{ label: 'm', x: [0, 1], y: [0, 1] }] }))] }],
});

/** Twenty families on a phone: the table scrolls, and no name is cut. */
const families = Array.from({ length: 20 }, (_, i) => `a long family ${i}`);
export const wide_heat_report = JSON.stringify({
  title: 'Wide', sections: [{ title: 'A', blocks: [{
    kind: 'heat', title: 'Wide', range: [0, 1], categories: families, series: [{ label: 'orca3d', cells: families.map(() => ({ value: 1, text: '1.20', mark: '=' })) }],
  }] }],
});

export async function look_at_wide_heat(page, expect) {
  const found = await page.locator('#figure-1 .plot').evaluate((plot) => {
    const svg = plot.querySelector('svg');
    const frame = svg.getBoundingClientRect();
    return {
      scrolls: plot.scrollWidth > plot.clientWidth, font: svg.viewBox.baseVal.width === frame.width,
      cut: [...svg.querySelectorAll('text')].filter((text) => text.getBoundingClientRect().right > frame.right + 1).length,
      texts: [...svg.querySelectorAll('.heat-text')].map((text) => text.textContent),
    };
  });
  expect(found.scrolls && found.font && found.cut === 0 && found.texts.every((text) => text === '= 1.20'), `a wide table: ${JSON.stringify(found)}`);
}

export async function look_at_heats(page, expect) {
  const figure = page.locator('#figure-1');
  const cells = figure.locator('.plot svg .heat');
  const colours = await cells.evaluateAll((all) => all.map((one) => getComputedStyle(one).fill));
  expect(colours.length === 3 && new Set(colours).size === 3, `the cells have the colours ${colours.join()}`);
  expect(await figure.locator('.plot svg .heat-none').count() === 1, 'what is not known is not told apart');
  expect((await figure.locator('.heat-text').allTextContents()).join() === '= 1.20,1.20,1.20', 'the cells say something else');

  const box = await cells.nth(1).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  const tip = (await page.locator('.tip:visible').allInnerTexts()).join().replace(/\s+/g, ' ');
  expect(/apf, cubes safe 0 % interval \u221210 % – 10 % time 1\.20 place a note click or Enter lists its 2 runs/.test(tip), `pointing says ${tip}`);
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  const listed = await page.locator('dialog.runs').innerText();
  expect(listed.includes('fairway run b --seed 7') && listed.includes('fairway run b --seed 8'), `a click lists ${listed}`);
  expect(listed.includes('2 runs, each with its clearance [m]'), `of the numbers is said ${listed}`);
  const link = page.locator('dialog a', { hasText: 'cubes: clearance' });
  const shown = await link.getAttribute('href');
  await link.click();
  expect(await closes(page) && await page.locator(`${shown} .title`).innerText() === 'cubes: clearance', `the link leads to ${shown}`);
  const scale = await figure.locator('.plot svg').evaluate((svg) => ({
    ends: [...svg.querySelectorAll('text')].map((text) => text.textContent).filter((text) => text.endsWith('%')),
    colours: [...svg.querySelectorAll('.heat-scale')].map((part) => getComputedStyle(part).fill),
  }));
  expect(scale.ends.join() === '0\u00a0%,100\u00a0%' && scale.colours[0] === colours[1] && scale.colours.at(-1) === colours[0],
    `the scale is ${JSON.stringify(scale)}`);

  const said = await page.locator('.note.problem').allInnerTexts();
  refused.forEach(([, reason], i) => expect(said[i]?.includes(`sections[0].blocks[${1 + i}].${reason}`), `"${reason}" is not said, but: ${said[i]}`));
}
