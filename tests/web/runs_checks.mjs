// SPDX-License-Identifier: Apache-2.0
// Marks and rows that lead to their runs, and tables as LaTeX.
import { readFileSync } from 'node:fs';

/** On every report: what leads to runs opens their list by mouse and by keyboard, and the list closes again. */
async function marks_lead_to_runs(page, expect) {
  let looked = 0;
  for (const kind of ['boxes', 'intervals']) {
    const plot = page.locator(`.chart-${kind} .plot`).first();
    if (await plot.count() === 0) continue;
    // A pointer above a plot that scrolls under it would take the tip away.
    await plot.scrollIntoViewIfNeeded();
    await page.mouse.move(0, 0);
    await plot.focus();
    await page.keyboard.press('ArrowRight');
    if (!(await page.locator('.tip:visible').allInnerTexts()).join().includes('Enter')) continue;
    await page.keyboard.press('Enter');
    await list_is_sound(page, expect, kind);
    looked += 1;
    await page.keyboard.press('Escape');
    expect(await closes(page), `Escape leaves the list of ${kind} open`);
  }
  const button = page.locator('.row-runs').first();
  if (await button.count() > 0) {
    await button.focus();
    await page.keyboard.press('Enter');
    await list_is_sound(page, expect, 'a row');
    looked += 1;
    await page.locator('dialog button[aria-label=Close]').click();
    expect(await closes(page), 'the list of a row does not close');
    expect(await button.evaluate((element) => element === document.activeElement), 'the focus does not return to the row');
  }
  const whole = page.locator('.figure .action', { hasText: /^Runs?$/ }).first();
  if (await whole.count() > 0) {
    await whole.click();
    await list_is_sound(page, expect, 'a figure');
    await page.keyboard.press('Escape');
    looked += 1;
  }
  expect(looked > 0, 'nothing leads to its runs');
}

/** A dialog is gone a moment after it was told to close. */
export function closes(page) {
  return page.waitForFunction(() => document.querySelector('dialog') === null, null, { timeout: 20_000 }).then(() => true, () => false);
}

async function list_is_sound(page, expect, of) {
  const found = await page.evaluate(() => {
    const dialog = document.querySelector('dialog[open]');
    if (dialog === null) return null;
    const frame = dialog.getBoundingClientRect();
    return {
      runs: dialog.querySelectorAll('.run-list li').length, title: dialog.querySelector('h2').textContent,
      commands: [...dialog.querySelectorAll('code')].every(({ textContent }) => /^fairway \S.*\d$/.test(textContent)),
      inside: frame.left >= 0 && frame.right <= document.documentElement.clientWidth + 1 && frame.bottom <= innerHeight + 1,
      focused: dialog.contains(document.activeElement), text: dialog.textContent,
    };
  });
  expect(found !== null && found.runs > 0 && found.title !== '', `${of} lists no runs: ${JSON.stringify(found)?.slice(0, 200)}`);
  expect(found?.commands === true && found.inside && found.focused && !/NaN|undefined/.test(found.text), `the list of ${of}: ${JSON.stringify(found)?.slice(0, 300)}`);
}

export const run_checks = [marks_lead_to_runs];

const box = { min: 1, q1: 2, median: 3, q3: 4, max: 5 };
export const runs_report = JSON.stringify({
  title: 'known runs',
  runs: [
    { label: 'cube a', command: 'fairway study cubes --only cube/a/', seeds: [1, 2, 3], playbacks: { 1: 'runs/cube-a-2.html' } },
    { label: 'cube b', command: '', seeds: ['18446744073709551615'] },
  ],
  sections: [{
    title: 'known', blocks: [
      {
        kind: 'boxes', title: 'Known boxes', y_label: 'time [s]', categories: ['one'],
        series: [{ label: 'a', boxes: [{ ...box, runs: [[0, 2]], values: [5, 1, null, 3, 2, 4] }] }, { label: 'b', boxes: [{ ...box, runs: [3] }] }],
      },
      {
        kind: 'intervals', title: 'Known intervals', y_label: 'time [s]', categories: ['one', 'two'],
        series: [{ label: 'a', points: [{ value: 2, low: 1, high: 3, published: 2.5, runs: [[0, 2]], values: [1, 2, 3] }, { value: 5, low: 4, high: 6, runs: [3] }] }],
      },
      {
        kind: 'table', title: 'Time & 100 %_of {all}', columns: [
          { key: 'case', label: 'Case_#' }, { key: 'v', label: 'Value', unit: 'm²', type: 'number', digits: 1 },
          { key: 'd', label: 'Deviation', type: 'deviation' }, { key: 'verdict', label: 'Verdict', type: 'verdict' }, { key: 'note', label: 'Note', type: 'remark' },
        ],
        rows: [
          { case: 'b~c^d\\', v: -12345.67, d: -0.032, verdict: 'within_spread', note: 'x < 3 ≈ 2–4 “quoted”, and longer than thirty', $runs: [0] },
          { case: 'a', v: 2, d: 0.013, verdict: 'reproduced', note: null },
          { case: 'c', v: null, d: null, verdict: 'no_reference', note: '$5' },
        ],
      },
    ],
  }],
});

const expected_latex = String.raw`% \usepackage{booktabs}
\begin{table}
  \centering
  \caption{Time \& 100 \%\_of \{all\}}
  \label{tab:time-100-of-all}
  \begin{tabular}{lrrlp{14em}}
    \toprule
    Case\_\# & Value [m$^2$] & Deviation & Verdict & Note \\
    \midrule
    a & 2.0 & +1.3~\% & reproduced & -- \\
    b\textasciitilde{}c\textasciicircum{}d\textbackslash{} & $-$12\,345.7 & $-$3.2~\% & within spread & x $<$ 3 $\approx$ 2--4 ${'``'}quoted'', and longer than thirty \\
    c & -- & -- & no reference & \$5 \\
    \bottomrule
  \end{tabular}
\end{table}
`;

const lines_of = (page) => page.locator('dialog .run-head').evaluateAll((heads) =>
  heads.map((head) => [...head.children].map(({ textContent }) => textContent).join(' | ')));

export async function look_at_known_runs(page, expect, context) {
  const plot = page.locator('.chart-boxes .plot');
  await plot.focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  expect(await page.locator('dialog h2').innerText() === 'Known boxes, a, one', 'the list is not titled by what was chosen');
  expect(await page.locator('dialog .run-count').innerText() === '3 runs, each with its time [s]', 'what the numbers are is not said');
  const given = ['5 | vehicle 0 | cube a | seed 1', '1 | vehicle 1 | cube a | seed 1', '– | vehicle 0 | cube a | seed 2 | Playback',
    '3 | vehicle 1 | cube a | seed 2 | Playback', '2 | vehicle 0 | cube a | seed 3', '4 | vehicle 1 | cube a | seed 3'];
  const sorted = async (order, expected) => {
    await page.locator('dialog .segments button', { hasText: order }).click();
    const found = await lines_of(page);
    expect(String(found) === String(expected.map((i) => given[i])), `${order}: ${found.join('; ')}`);
  };
  expect(String(await lines_of(page)) === String(given), `as given: ${(await lines_of(page)).join('; ')}`);
  await sorted('Smallest first', [1, 4, 3, 5, 0, 2]);
  await sorted('Largest first', [0, 5, 3, 4, 1, 2]);
  await sorted('In order', [0, 1, 2, 3, 4, 5]);
  expect(await page.locator('dialog a').first().getAttribute('href') === 'runs/cube-a-2.html', 'the playback is not linked');
  expect(await page.locator('dialog code').nth(3).innerText() === 'fairway study cubes --only cube/a/2', 'the command is another');
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.locator('dialog .action', { hasText: 'Copy' }).nth(5).click();
  await page.locator('dialog .action.done').waitFor();
  expect(await page.evaluate(() => navigator.clipboard.readText()) === 'fairway study cubes --only cube/a/3', 'the command is not copied');
  await page.locator('dialog button[aria-label=Close]').click();
  expect(await closes(page), 'the list does not close');

  // By mouse: the second box, whose run has no command.
  const at = await plot.boundingBox();
  await page.mouse.move(at.x + at.width * 0.75, at.y + at.height * 0.5);
  await page.mouse.down();
  await page.mouse.up();
  expect((await page.locator('dialog').innerText()).includes('not known'), 'a run without a command shows one');
  expect((await lines_of(page))[0] === 'cube b | seed 18446744073709551615', `a large seed: ${await lines_of(page)}`);
  await page.mouse.click(2, 2);
  expect(await closes(page), 'a click beside the list does not close it');

  const rows = page.locator('figure.table tbody tr:not(.remark)');
  await rows.nth(1).locator('td').first().click();
  expect(await page.locator('dialog').count() === 0, 'a row without runs opens a list');
  await rows.nth(0).locator('td').first().click();
  expect((await lines_of(page)).join() === 'cube a | seed 1', 'a click on a row does not lead to its run');
  await page.keyboard.press('Escape');

  await page.locator('figure.table thead button').first().click();
  const button = page.locator('figure.table .action', { hasText: 'LaTeX' });
  const [download] = await Promise.all([page.waitForEvent('download'), button.click()]);
  const text = readFileSync(await download.path(), 'utf8');
  expect(download.suggestedFilename() === 'time-100-of-all.tex' && text === expected_latex, `LaTeX is\n${text}`);
}
