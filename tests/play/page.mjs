// SPDX-License-Identifier: Apache-2.0
// out/play.html in a real browser from file://, driven as a visitor would. tests/play/page.mjs [--screenshots DIR]
// Ends with 0 when every check held, else with 1 and a list of those that did not.
import { join } from 'node:path';
import { browser, choose, commanded, complaint, desk, ended, is_at, keep, look_at, measure, packed, phone, plain_desk, playback, stand_at } from './visitor.mjs';

async function first_minute(page, expect) {
  const frame = await playback(page);
  const seconds = await page.evaluate(() => performance.now() / 1000);
  console.log(`the first picture after ${seconds.toFixed(2)} s`);
  await ended(page);
  expect(Number(await measure(page, 'arrived_ratio')) === 1, 'all eight vehicles of swap_8 arrive');
  await frame.waitForFunction(() => window.fairway.state().time > 1);
  await stand_at(frame, 40);
  await keep(page, 'desk');
}

async function another_method(page, expect) {
  await playback(page);
  await ended(page);
  const before = await measure(page, 'min_separation_m');
  await choose(page, 'Method', 'apf');
  await page.waitForFunction((text) => {
    const row = [...document.querySelectorAll('.measures tr')].find((tr) => tr.textContent.startsWith('min_separation_m'));
    return row !== undefined && row.lastChild.textContent !== text;
  }, before);
  expect(await page.locator('.command').textContent() === "fairway run scenarios/swap_8.yaml --set 'vehicles[*].avoider=apf'", 'the command is that of the run');
  await page.getByText('Parameters of the method').click();
  const count = await page.locator('.parameter').count();
  expect(count > 3, `apf has parameters: ${count}`);
  const address = await page.evaluate(() => location.hash);
  expect(address.startsWith('#play='), `the address says what is played: ${address}`);
}

async function beside(page, expect) {
  await playback(page);
  await choose(page, 'Beside it, under the same seed', 'apf');
  await playback(page, 1);
  await page.waitForFunction(() => document.querySelector('.results').textContent.includes('They part at'));
  expect(/They part at \d+\.\d{3} s/.test(await page.locator('.results').textContent()), 'it says when they part');
  const [first, second] = [await playback(page, 0), await playback(page, 1)];
  await stand_at(first, 30);
  await is_at(second, 30);
  await keep(page, 'beside');
}

async function broken_yaml(page, expect) {
  await playback(page);
  await page.getByText('The scenario as YAML').click();
  const area = page.getByLabel('The scenario as YAML');
  await area.fill((await area.inputValue()).replace('vehicles:', 'vehiclez:'));
  await page.getByRole('button', { name: 'Run this YAML' }).click();
  const line = await complaint(page);
  expect(/^scenario\.yaml:\d+:1: vehiclez: unknown key; did you mean vehicles\?/.test(line), `the message has a place: ${line}`);
  const selected = await area.evaluate((text) => text.value.slice(text.selectionStart, text.selectionEnd));
  expect(selected.startsWith('vehiclez:'), `the place is selected: ${selected}`);
  await page.getByRole('button', { name: 'As shipped' }).click();
  await page.waitForSelector('.note.problem[hidden]', { state: 'attached' });
}

async function recordings(page, expect) {
  await playback(page);
  await ended(page);
  const waiting = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save the run as MCAP' }).click();
  const saved = join(browser.folder, 'saved.mcap');
  await (await waiting).saveAs(saved);
  await page.getByText('A recording or scenario of yours').click();
  await page.getByLabel('A recording or a scenario').setInputFiles(saved);
  await page.waitForSelector('.verdict');
  const verdict = await page.locator('.verdict').textContent();
  expect(/same/.test(verdict), `the page verifies what it saved: ${verdict}`);
  expect(await page.locator('.command').textContent() === 'fairway replay saved.mcap --verify', 'the command is that of a replay');
  await playback(page);
}

async function why(page, expect) {
  const frame = await playback(page);
  await ended(page);
  await stand_at(frame, 30);
  await frame.locator('#vehicles').getByText('robot3', { exact: true }).click();
  await frame.waitForFunction(() => window.fairway.state().chosen.includes(3));
  await page.getByText('Why it did so').click();
  await page.getByRole('button', { name: 'Explain this instant' }).click();
  const headline = await page.locator('.explanation h2').textContent();
  expect(/^robot3 .*: /.test(headline), `it explains the vehicle that is chosen: ${headline}`);
  expect((await page.locator('.explanation .who').textContent()).includes('t = 30.00 s'), 'at the instant that is shown');
  await page.locator('.explanation').evaluate((element) => element.closest('details').scrollIntoView());
  await keep(page, 'why');
}

async function without_ompl(page, expect) {
  await playback(page);
  await choose(page, 'Scenario', 'scenarios/transport_planned.yaml');
  await commanded(page, 'transport_planned');
  const frame = await playback(page);
  await frame.waitForFunction(() => document.querySelector('.live-status')?.textContent.includes('OMPL'));
  expect((await frame.locator('.live-status').textContent()).includes('fairway run scenarios/transport_planned.yaml'), 'it says how to run it');
}

async function for_all(page, expect) {
  await playback(page);
  await choose(page, 'Vehicles', 'kinematic');
  await commanded(page, 'kinematic');
  await choose(page, 'How they hear each other', 'none');
  await commanded(page, 'exchange=none');
  await page.getByLabel('Seed', { exact: true }).fill('7');
  await page.getByLabel('Seed', { exact: true }).blur();
  await commanded(page, '--seed 7');
  const command = "fairway run scenarios/swap_8.yaml --set 'vehicles[*].model=kinematic' --set exchange=none --seed 7";
  expect(await page.locator('.command').textContent() === command, 'the command has every change');
}

async function old_link(page, expect) {
  await playback(page);
  expect((await complaint(page)).includes('version 7'), 'a link of another version is told so');
}

async function without_webassembly(page, expect) {
  const text = await page.locator('.note.problem p').textContent();
  expect(text.includes('has no WebAssembly'), `it says what is missing: ${text}`);
}

async function small(page, expect) {
  const frame = await playback(page);
  const key = frame.locator('.stage-key .lines');
  await key.waitFor({ state: 'attached' });
  await frame.waitForFunction(() => document.querySelector('.stage-key .lines').childElementCount > 0);
  expect(!await key.isVisible(), 'the key of the picture is folded');
  const { scroll, inner } = await page.evaluate(() => ({ scroll: document.documentElement.scrollWidth, inner: innerWidth }));
  expect(scroll <= inner, `nothing is wider than the screen: ${scroll} of ${inner} px`);
  await keep(page, 'phone');
  await frame.getByRole('button', { name: 'Key', exact: true }).click();
  expect(await key.isVisible(), 'a button opens it');
  await keep(page, 'phone-key');
  await frame.getByRole('button', { name: 'Key', exact: true }).click();
  expect(!await key.isVisible(), 'and folds it');
}

await look_at([[first_minute, desk], [another_method, plain_desk], [beside, desk], [broken_yaml, plain_desk], [recordings, plain_desk], [why, desk], [without_ompl, plain_desk], [for_all, plain_desk],
  [old_link, { ...plain_desk, fragment: `#play=${await packed({ version: 7 })}` }], [without_webassembly, { ...desk, missing: 'WebAssembly' }],
  [small, phone]]);
