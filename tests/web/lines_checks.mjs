// SPDX-License-Identifier: Apache-2.0
// Series of one point each, some of them on a front, and where a link leads.

const names = Array.from({ length: 19 }, (_, i) => `method ${i}`);
export const front_report = JSON.stringify({
  title: 'Fronts', sections: [
    { title: 'A', blocks: [{
      kind: 'lines', title: 'Safety and time', x_label: 'unsafe', y_label: 'time', front: ['method 1', 'method 0'],
      series: names.map((label, i) => ({ label, x: [i < 2 ? 10 * i : 20 + i], y: [i < 2 ? 2 - i : 3] })),
    }] },
    { id: 'last', title: 'Last', paragraphs: Array.from({ length: 60 }, () => 'A line.') },
  ],
});

export async function look_at_fronts(page, expect) {
  const plot = page.locator('#figure-1 .plot');
  const looks = await plot.locator('.marks .point').evaluateAll((points) =>
    points.map((point) => `${getComputedStyle(point).fill} ${point.getAttribute('d')}`));
  expect(looks.length === 19 && new Set(looks).size === 19, `of 19 methods ${new Set(looks).size} look different`);
  const entries = await page.locator('#figure-1 .legend .entry').allInnerTexts();
  expect(entries.join() === [...names, 'on the front'].join(), `the legend has ${entries.join()}`);
  expect(await plot.locator('.front-ring').count() === 2, 'the front is not ringed');
  // From the safest to the fastest: level up to who comes next, then down to it.
  const steps = (await plot.locator('.front').getAttribute('d')).match(/[\d.]+/g).map(Number);
  expect(steps.length === 6 && steps[1] === steps[3] && steps[2] === steps[4] && steps[5] > steps[3], `the front goes ${steps.join()}`);
  await plot.focus();
  await page.keyboard.press('ArrowRight');
  expect((await page.locator('.tip:visible').innerText()).includes('method 0, on the front'), 'the tip does not say who is on the front');
}

/** A link to a section below figures leads there, however high these turn out. */
export async function look_at_linked(page, expect) {
  await page.waitForTimeout(300);
  const top = await page.locator('#last').evaluate((section) => section.getBoundingClientRect().top);
  expect(Math.abs(top - 20) < 2, `the linked section begins ${top} px below the upper edge`);
}
