// SPDX-License-Identifier: Apache-2.0
// What is put into out/play.html and may be wrong, in a real browser from file://: changes, links, files. tests/play/opened.mjs
// [--screenshots DIR]; as page.mjs.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../web/browser.mjs';
import { browser, choose, commanded, complaint, desk, ended, look_at, packed, plain_desk, playback, stand_at } from './visitor.mjs';

const head_on = readFileSync(join(root, 'scenarios/head_on.yaml'), 'utf8');
const type_seed = async (page, seed) => {
  await page.getByLabel('Seed', { exact: true }).fill(seed);
  await page.getByLabel('Seed', { exact: true }).blur();
};
const command = (page) => page.locator('.command').textContent();
const chosen = (page) => page.getByLabel('Scenario', { exact: true }).first().evaluate((select) => select.selectedOptions[0].textContent);
const quiet = (page) => page.waitForSelector('.note.problem[hidden]', { state: 'attached' });
const file = (name, content) => {
  const path = join(browser.folder, name);
  writeFileSync(path, content);
  return path;
};
const open = async (page, path) => {
  await page.getByText('A recording or scenario of yours').evaluate((summary) => { summary.parentElement.open = true; });
  await page.getByLabel('A recording or a scenario').setInputFiles(path);
};
/** Drops a text file on what `target` of this page or frame finds, which answers whether a browser would have opened it instead. */
const drop = (frame, target, name, text) => frame.evaluate(([selector, called, content]) => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([content], called));
  const on = document.querySelector(selector);
  const events = ['dragover', 'drop'].map((kind) => new DragEvent(kind, { dataTransfer, bubbles: true, cancelable: true }));
  return events.map((event) => on.dispatchEvent(event)).some((goes_on) => goes_on);
}, [target, name, text]);

async function refused_while_running(page, expect) {
  const frame = await playback(page);
  await type_seed(page, '-3');
  expect((await complaint(page)).startsWith('seed: '), 'the seed is refused');
  const end = await frame.evaluate(() => window.fairway.film.end);
  await frame.waitForFunction((before) => window.fairway.film.end > before + 1, end);
  expect(!frame.isDetached(), 'the run before it goes on');
}

async function refused_at_the_end(page, expect) {
  const frame = await playback(page);
  await ended(page);
  await stand_at(frame, 30);
  await type_seed(page, '-3');
  await complaint(page);
  await page.getByText('Why it did so').click();
  await page.getByRole('button', { name: 'Explain this instant' }).click();
  expect(/^robot0 .*: /.test(await page.locator('.explanation h2').textContent()), 'the run before it is explained');
  const waiting = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save the run as MCAP' }).click();
  expect(readFileSync(await (await waiting).path()).subarray(1, 5).toString() === 'MCAP', 'and saved');
  await type_seed(page, '3');
  await commanded(page, '--seed 3');
}

async function put_into_an_open_page(page, expect) {
  await playback(page);
  const go = (address) => page.evaluate((hash) => { location.hash = hash; }, address);
  await go('#seed=5&set=vehicles[*].avoider=apf&scenario=scenarios/head_on.yaml');
  await commanded(page, "head_on.yaml --set 'vehicles[*].avoider=apf' --seed 5");
  expect(await chosen(page) === 'head_on', 'a link that is put into an open page is played, its words in any order');
  await go('#sed=5');
  expect(/^The link cannot be read: “sed” says nothing here; .* What was played goes on\.$/.test(await complaint(page)), `a wrong one is told: ${await complaint(page)}`);
  await page.waitForFunction(() => location.hash.startsWith('#play='));
  expect((await command(page)).includes('--seed 5'), 'and what was played goes on');
  await go('#scenario=scenarios/swap_8.yaml&seed=abc');
  await commanded(page, 'fairway run scenarios/swap_8.yaml');
  expect((await complaint(page)).startsWith('What the link asks for is refused: seed: expected a whole number'), `a refused one is told: ${await complaint(page)}`);
}

/** Links that this page cannot read, each put into the open page in turn. */
async function unreadable_links(page, expect) {
  await playback(page);
  for (const [address, why] of [
    ['#seed=5', 'it names no scenario'], [`#play=${link}%20`, 'it has “ ”, which no copied link has'], [`#play=${link.slice(0, -9)}`, 'it is cut short']]) {
    await page.evaluate((hash) => { location.hash = hash; }, address);
    await page.waitForFunction((told) => document.querySelector('.note.problem:not([hidden]) p')?.textContent.startsWith(told), `The link cannot be read: ${why}`);
    expect((await complaint(page)).endsWith(' What was played goes on.'), `what is played: ${await complaint(page)}`);
  }
}

/** A link whose scenario is played as shipped, and whose refusal is told. */
const refused_link = (pattern, told = /This is scenarios\/swap_8\.yaml as it is shipped\.$/) => async function refused_link(page, expect) {
  const line = await complaint(page);
  expect(pattern.test(line), `why it is refused: ${line}`);
  await playback(page);
  await page.waitForFunction(() => document.querySelector('.command').textContent === 'fairway run scenarios/swap_8.yaml');
  expect(told.test(await complaint(page)), `and what is played instead: ${await complaint(page)}`);
};
const first_instead = /^The link cannot be read: .*This is the first scenario instead\.$/;

async function opened_scenario(page, expect) {
  await playback(page);
  await choose(page, 'Method', 'apf');
  await commanded(page, 'avoider=apf');
  await type_seed(page, '7');
  await commanded(page, '--seed 7');
  const before = await page.evaluate(() => location.hash);
  await open(page, file('of mine.yaml', head_on));
  await page.waitForFunction((hash) => document.querySelector('.command').textContent === "fairway run 'of mine.yaml'" && location.hash !== hash, before);
  expect(await page.locator('.changed li').count() === 0, 'nothing of the run before is in it');
  expect(await chosen(page) === 'of mine.yaml', 'its name stands in place of the scenario');
  const address = await page.evaluate(() => location.hash);
  await choose(page, 'Scenario', 'scenarios/swap_8.yaml');
  await commanded(page, 'fairway run scenarios/swap_8.yaml');
  await page.waitForFunction((hash) => location.hash !== hash, address);
  await page.evaluate((hash) => { location.hash = hash; }, address);
  await commanded(page, 'of mine.yaml');
  expect(await chosen(page) === 'of mine.yaml', 'and in a link');
}

async function not_text(page, expect) {
  await playback(page);
  await open(page, file('latin.yaml', Buffer.from(head_on.replace(/^summary: .*$/m, 'summary: caf\xE9'), 'latin1')));
  expect((await complaint(page)).startsWith('latin.yaml is neither a recording (MCAP) nor text in UTF-8'), `it is told: ${await complaint(page)}`);
  expect(await command(page) === 'fairway run scenarios/swap_8.yaml', 'and the run before it goes on');
}

async function recording_by_its_bytes(page, expect) {
  await playback(page);
  await ended(page);
  const waiting = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save the run as MCAP' }).click();
  const bytes = readFileSync(await (await waiting).path());
  await open(page, file('SAVED.MCAP', bytes));
  await commanded(page, 'fairway replay SAVED.MCAP --verify');
  expect(await chosen(page) === 'SAVED.MCAP', 'no scenario is chosen');
  expect(await page.evaluate(() => location.hash) === '', 'the address is of no run');
  expect(await page.getByRole('button', { name: 'Copy a link' }).count() === 0, 'and there is no link');
  await page.waitForSelector('.verdict');
  await open(page, file('unnamed', bytes));
  await commanded(page, 'fairway replay unnamed --verify');
  await choose(page, 'Scenario', 'scenarios/head_on.yaml');
  await commanded(page, 'fairway run scenarios/head_on.yaml');
  await page.waitForFunction(() => location.hash.startsWith('#play='));
}

async function place_behind_other_letters(page, expect) {
  await playback(page);
  await page.getByText('The scenario as YAML').click();
  const area = page.getByLabel('The scenario as YAML');
  await area.fill("fairway: 1\nname: a\nvehicles:\n  - {name: '数据🐟数据', modell: sparus2}\n");
  await page.getByRole('button', { name: 'Run this YAML' }).click();
  const line = await complaint(page);
  expect(/^scenario\.yaml:4:21: .*modell/.test(line), `the place counts characters: ${line}`);
  const selected = await area.evaluate((text) => text.value.slice(text.selectionStart, text.selectionEnd));
  expect(selected === 'modell: sparus2}', `and is selected: ${selected}`);
}

async function dropped_anywhere(page, expect) {
  await playback(page);
  expect(!await drop(page, '.shows', 'beside.yaml', head_on), 'what is dropped beside the panel opens in no other page');
  await commanded(page, 'fairway run beside.yaml');
  const frame = await playback(page);
  expect(!await drop(frame, '.picture', 'inside.yaml', head_on), 'nor in the picture');
  await commanded(page, 'fairway run inside.yaml');
  await quiet(page);
}

const shipped = { version: 2, scenario: 'scenarios/swap_8.yaml', yaml: null, seed: null, set: [], beside: null, changes: [] };
const link = await packed(shipped);
const with_link = (fragment, check) => [check, { ...plain_desk, fragment }];
await look_at([with_link('#scenario=scenarios/fleet_1000.yaml&set=duration_s=3600', refused_while_running), [refused_at_the_end, plain_desk], [put_into_an_open_page, plain_desk],
  with_link('#scenario=scenarios/swap_8.yaml&set=vehicles[*].avoider=bogus', refused_link(/bogus/)),
  with_link(`#play=${await packed({ ...shipped, beside: [['vehicles[*].avoider', 'bogus']] })}`, refused_link(/bogus/)),
  with_link('#scenario=constructor', refused_link(/which this page does not have/, first_instead)),
  [unreadable_links, plain_desk],
  [opened_scenario, plain_desk], [not_text, plain_desk], [recording_by_its_bytes, plain_desk], [place_behind_other_letters, plain_desk], [dropped_anywhere, desk]]);
