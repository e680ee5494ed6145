// SPDX-License-Identifier: Apache-2.0
// A small raster whose every pixel is known, alone and in a grid, and rasters that must be refused.
import { readFileSync } from 'node:fs';
import { Picture, png_uri } from './picture.mjs';

// Three cells by two, the upper row first.
const rows = [['#ff0000', '#00ff00', '#0000ff'], ['#ffff00', '#808080', '#ff00ff']];
const raster = {
  kind: 'raster', title: 'Six cells', x_label: 'velocity east [m/s]', y_label: 'velocity north [m/s]', x: [-1.5, 1.5], y: [0, 4],
  width: 3, height: 2, rgb: rows.flat().join('').replaceAll('#', ''),
  marks: [{ label: 'desired', x: 0, y: 3 }, { label: 'too fast', x: 2.5, y: 1 }],
};
const plain = { ...raster, marks: undefined, title: 'No marks' };
const largest = { ...plain, title: 'As many cells as may be', width: 401, height: 401, rgb: '123456'.repeat(401 * 401) };

const refused = [
  [{ rgb: raster.rgb.slice(1) }, 'rgb: 35 digits for 3 by 2 cells, which take 36'],
  [{ rgb: raster.rgb.replace('f', 'g') }, 'rgb: expected hexadecimal digits'],
  [{ rgb: undefined }, 'rgb: expected text'],
  [{ width: 0, rgb: '' }, 'width: expected a whole number from 1 to 401, found the number 0'],
  [{ height: 1.5 }, 'height: expected a whole number'],
  [{ width: 402, height: 1, rgb: '000000'.repeat(402) }, 'width: expected a whole number from 1 to 401'],
  [{ width: undefined }, 'width: expected a number'],
  [{ x: [1, 1] }, 'x: the first end, 1, is not below the second, 1'],
  [{ y: [1] }, 'y: 1 entries for 2 ends'],
  [{ marks: [{ label: 'm', x: 0 }] }, 'marks[0].y: expected a number'],
];

const shown = [raster, { kind: 'grid', title: 'Panels', columns: 3, blocks: [plain, plain, plain] }, largest];
export const raster_report = JSON.stringify({
  title: 'Rasters', sections: [{ title: 'A', blocks: [...shown, ...refused.map(([change]) => ({ ...raster, ...change }))] }],
});

/** Two points of every cell of an image that fills `box`, near opposite corners: where it is sharp, both have the cell's colour. */
function near_corners(box) {
  return rows.flatMap((cells, row) => cells.flatMap((colour, column) => [0.08, 0.92].map((part) => ({
    colour, at: [box.x + ((column + part) / 3) * box.width, box.y + ((row + part) / 2) * box.height],
  }))));
}

async function expect_cells(page, expect, uri, box, where) {
  const points = near_corners(box);
  const picture = await Picture.of(uri, page);
  for (const { colour, at: [x, y] } of points) {
    const found = `#${picture.at(Math.floor(x), Math.floor(y)).map((part) => part.toString(16).padStart(2, '0')).join('')}`;
    expect(found === colour, `${where}: ${found} at ${x}, ${y}, expected ${colour}`);
  }
}

async function expect_cells_on_screen(page, expect, figure, where) {
  const image = figure.locator('.plot svg image');
  await image.scrollIntoViewIfNeeded();
  const box = await image.boundingBox();
  const shot = await page.screenshot({ clip: box });
  await expect_cells(page, expect, png_uri(shot), { ...box, x: 0, y: 0 }, where);
}

async function marks_stand_where_they_belong(page, expect) {
  const figure = page.locator('#figure-1');
  const image = await figure.locator('.plot svg image').boundingBox();
  const pins = await figure.locator('.plot svg .pin').evaluateAll((all) => all.map((pin) => {
    const { left, right, top, bottom } = pin.getBoundingClientRect();
    return { left, right, x: (left + right) / 2, y: (top + bottom) / 2 };
  }));
  expect(Math.abs(image.width - image.height) < 0.01, `the image is ${image.width} by ${image.height}`);
  expect(pins.length === 2, `${pins.length} marks are drawn`);
  expect(Math.abs(pins[0].x - image.x - image.width / 2) < 1 && Math.abs(pins[0].y - image.y - image.height / 4) < 1,
    `the mark is at ${JSON.stringify(pins[0])} of ${JSON.stringify(image)}`);
  // Beyond the right edge: an arrow head that ends there, as high as the mark.
  expect(Math.abs(pins[1].right - image.x - image.width) < 1.5 && Math.abs(pins[1].y - image.y - image.height * 0.75) < 1,
    `the mark beyond is at ${JSON.stringify(pins[1])} of ${JSON.stringify(image)}`);
  expect((await figure.locator('.legend .entry').allInnerTexts()).join() === 'desired,too fast', 'the legend has other names');
  const described = await figure.locator('.plot svg').getAttribute('aria-label');
  expect(described.includes('desired at 0.00, 3.00') && described.includes('from \u22121.5 to 1.5'), `described as ${described}`);
}

async function pointing_reads_cells_and_marks(page, expect) {
  const figure = page.locator('#figure-1');
  await figure.locator('.plot svg image').scrollIntoViewIfNeeded();
  const box = await figure.locator('.plot svg image').boundingBox();
  const tip_at = async (x, y) => {
    await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    return (await page.locator('.tip:visible').allInnerTexts()).join().replace(/\s+/g, ' ');
  };
  const cell = await tip_at(0.1, 0.9);
  expect(/Cell velocity east \[m\/s\] \u22121\.00 velocity north \[m\/s\] 1\.00 colour #ffff00/.test(cell), `the cell says ${cell}`);
  const mark = await tip_at(0.505, 0.255);
  expect(/desired velocity east \[m\/s\] 0\.00 velocity north \[m\/s\] 3\.00/.test(mark), `the mark says ${mark}`);
  expect(await tip_at(-0.05, 0.5) === '', 'pointing beside the image says something');
  // A pointer above a plot that scrolls under it would take the tip away.
  await page.locator('#figure-2-b .plot').scrollIntoViewIfNeeded();
  await page.mouse.move(0, 0);
  await page.locator('#figure-2-b .plot').focus();
  await page.keyboard.press('ArrowRight');
  expect((await page.locator('.tip:visible td').allInnerTexts()).join() === '\u22121.00,1.00,#ffff00', 'arrow keys do not read the cells');
  await page.keyboard.press('Escape');
}

async function saved_image_has_the_cells(page, expect) {
  const button = page.locator('#figure-1 .action', { hasText: 'SVG' });
  const [download] = await Promise.all([page.waitForEvent('download'), button.click()]);
  const text = readFileSync(await download.path(), 'utf8');
  const box = await page.evaluate((svg) => {
    const image = new DOMParser().parseFromString(svg, 'image/svg+xml').querySelector('image');
    const [, left, top] = image.closest('[transform]').getAttribute('transform').match(/translate\((\S+) (\S+)\)/);
    const [x, y, width, height] = ['x', 'y', 'width', 'height'].map((name) => Number(image.getAttribute(name)));
    return { x: x + Number(left), y: y + Number(top), width, height };
  }, text);
  await expect_cells(page, expect, `data:image/svg+xml;base64,${Buffer.from(text).toString('base64')}`, box, 'saved');
}

async function bad_rasters_say_so(page, expect) {
  const said = await page.locator('.note.problem').allInnerTexts();
  refused.forEach(([, reason], i) => expect(said[i]?.includes(`sections[0].blocks[${shown.length + i}].${reason}`),
    `"${reason}" is not said, but: ${said[i]}`));
  expect(said.length === refused.length, `${said.length} blocks are refused`);
}

export async function look_at_rasters(page, expect) {
  await expect_cells_on_screen(page, expect, page.locator('#figure-1'), 'on screen');
  for (const letter of ['a', 'b', 'c']) {
    await expect_cells_on_screen(page, expect, page.locator(`#figure-2-${letter}`), `panel ${letter}`);
  }
  expect(await page.locator('#figure-2 .legend, .grid-figure .legend').count() === 0, 'panels without marks have a legend');
  expect(await page.locator('#figure-3 image').count() === 1, 'the largest raster is not drawn');
  await marks_stand_where_they_belong(page, expect);
  await pointing_reads_cells_and_marks(page, expect);
  await saved_image_has_the_cells(page, expect);
  await bad_rasters_say_so(page, expect);
  await page.mouse.move(0, 0);
  await page.emulateMedia({ media: 'print' });
  await expect_cells_on_screen(page, expect, page.locator('#figure-1'), 'printed');
}
