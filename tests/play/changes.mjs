// SPDX-License-Identifier: Apache-2.0
// What is changed in out/play.html, in a real browser from file://: on the way, in the picture, in the sea, in links. tests/play/changes.mjs
// [--screenshots DIR]; as page.mjs.
import { choose, commanded, complaint, desk, ended, is_at, keep, look_at, packed, phone, plain_desk, playback, stand_at } from './visitor.mjs';

const result_text = (page) => page.locator('.results').textContent();

/** Of frame `i` of the film: all positions. */
const positions = (frame, time) => frame.evaluate((at) => {
  const { film } = window.fairway;
  const i = film.index_at(at);
  return Array.from({ length: film.vehicles }, (_, v) => film.vector('position_m', i, v));
}, time);

async function on_the_way(page, expect) {
  const before = await playback(page);
  await ended(page);
  await choose(page, 'Beside it, under the same seed', 'orca3d');
  await playback(page, 1);
  const first = await playback(page);
  await first.waitForFunction(() => window.fairway.film.end > 60);
  await stand_at(first, 20);
  await is_at(await playback(page, 1), 20);
  const [then, later] = [await positions(first, 20), await positions(first, 50)];
  await choose(page, 'A change counts', 'later');
  await choose(page, 'Method', 'apf');
  await page.waitForFunction(() => document.querySelector('.changed')?.textContent.includes('from 20.00 s'));
  while (!first.isDetached()) await page.waitForTimeout(50);  // the changes are listed before the run begins anew
  const changed = await playback(page);
  await changed.waitForFunction(() => window.fairway.film.end > 60);
  expect(JSON.stringify(await positions(changed, 20)) === JSON.stringify(then), 'up to the instant everything is where it was');
  expect(JSON.stringify(await positions(changed, 50)) !== JSON.stringify(later), 'and not after it');
  await changed.waitForFunction(() => window.fairway.state().time > 20.5 && window.fairway.state().playing);
  await page.waitForFunction(() => document.querySelector('.results').textContent.includes('They part at'));
  expect((await result_text(page)).includes('They part at 20.000 s'), `the run beside it, which goes on as it was, parts there: ${await result_text(page)}`);
  expect((await page.locator('.controls').textContent()).includes('From 20 s on this run is changed on its way. No command does that'), 'it is said of the command');
  await keep(page, 'on-the-way');
  await page.getByRole('button', { name: 'Save the run as MCAP' }).click();
  expect((await complaint(page)).includes('changed on its way has no recording'), 'and of a recording');
  expect(before !== changed, 'it is another frame');
}

async function taken_back(page, expect) {
  await playback(page);
  await choose(page, 'Method', 'apf');
  await commanded(page, 'avoider=apf');
  await page.getByRole('button', { name: /Take back/ }).click();
  await page.waitForFunction(() => document.querySelector('.command').textContent === 'fairway run scenarios/swap_8.yaml');
  expect(await page.locator('.changed li').count() === 0, 'nothing is changed any more');
}

async function not_on_the_way(page, expect) {
  expect((await complaint(page)).includes('and not: '), `what cannot change on the way is refused: ${await complaint(page)}`);
}

async function moving(page, expect) {
  const frame = await playback(page);
  await stand_at(frame, 0);
  await frame.getByRole('button', { name: 'Top', exact: true }).click();
  await frame.getByRole('button', { name: 'Move', exact: true }).click();
  const start = frame.getByRole('button', { name: 'Move the start of robot0' });  // over the goal of robot4
  await start.waitFor();
  expect(await frame.locator('.handle').count() === 16, 'every start and goal has a handle');
  await keep(page, 'moving');
  const box = await start.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 60, box.y + 40, { steps: 5 });
  expect(/start of robot0: .* m deep/.test(await frame.locator('.handle-tip').textContent()), 'it says where it is');
  await page.mouse.up();
  await commanded(page, 'vehicles[0].start.position_m=[');
  const [, north, east, down] = /position_m=\[([-\d.]+), ([-\d.]+), ([-\d.]+)\]/.exec(await page.locator('.command').textContent());
  expect(Number(north) < 20 && Number(east) > 0 && Number(down) === 5.5, `down and to the right is south and east, as deep as it was: ${north}, ${east}, ${down}`);
  const again = await playback(page);
  const [first] = await positions(again, 0);
  expect(first[0] === Number(north) && first[1] === Number(east), `the run begins there: ${first}`);
  expect(await again.locator('.handle').count() === 16, 'and the handles stay');
  await again.getByRole('button', { name: 'Move the goal of robot1' }).focus();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Enter');
  await commanded(page, 'vehicles[1].mission[0].transit.position_m=[-12.9, -14.9, 5.5]');
}

async function obstacles_move(page, expect) {
  await playback(page);
  await choose(page, 'Scenario', 'scenarios/static_obstacles.yaml');
  await commanded(page, 'static_obstacles');
  const frame = await playback(page);
  await frame.getByRole('button', { name: 'Move', exact: true }).click();
  await frame.locator('.handle.obstacle').first().focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await commanded(page, 'obstacles[');
  expect(await page.locator('.changed li').count() === 1, 'one thing is changed');
}

async function sea(page, expect) {
  await playback(page);
  await page.getByText('Current and waves').click();
  const type = async (label, value) => {
    await page.getByLabel(`${label}, typed`).fill(value);
    await page.getByLabel(`${label}, typed`).blur();
  };
  await type('current east', '0.2');
  await commanded(page, "--set 'water.current_mps=[0, 0.2, 0]'");
  await type('current wanders by', '0.05');
  await commanded(page, 'gauss_markov: {mean_speed_mps: 0.2, deviation_mps: 0.05, direction_deg: 90}');
  expect(!(await page.locator('.command').textContent()).includes('current_mps'), 'only one kind of current is given');
  await type('wave height', '1.5');
  await commanded(page, 'waves={spectrum: jonswap, significant_height_m: 1.5, peak_period_s: 5}');
  await playback(page);
  await keep(page, 'sea');
}

async function each_its_method(page, expect) {
  await playback(page);
  await page.getByText('A method for each vehicle').click();
  await choose(page, 'robot2', 'apf');
  await commanded(page, "--set 'vehicles[2].avoider=apf'");
  await choose(page, 'Scenario', 'scenarios/fleet_1000.yaml');
  await commanded(page, 'fleet_1000');
  await page.getByLabel('How many the fleet has').fill('30');
  await page.getByLabel('How many the fleet has').blur();
  await commanded(page, '--set fleet.count=30');
  const frame = await playback(page);
  expect(await frame.evaluate(() => window.fairway.film.vehicles) === 30, 'the fleet has as many');
}

async function thoughts(page, expect) {
  const frame = await playback(page);
  await ended(page);
  const thinks = (vehicle) => frame.evaluate((v) => window.fairway.film.sketches.at(v, 30) !== null, vehicle);
  expect(await thinks(0) && !await thinks(3), 'at first the first vehicle thinks aloud');
  await frame.locator('#vehicles').getByText('robot3', { exact: true }).click();
  await frame.waitForFunction(() => window.fairway.film.sketches.at(3, 30) !== null);
  expect(!await thinks(0), 'and then the one that is chosen');
}

async function plain_link(page, expect) {
  await commanded(page, "scenarios/cube20_4.yaml --set 'vehicles[*].avoider=apf' --seed 5");
  await playback(page);
  expect(await page.locator('.note.problem').isHidden(), 'an address written by hand opens');
}

async function first_version(page, expect) {
  await commanded(page, 'scenarios/head_on.yaml --seed 3');
  await playback(page);
  expect(await page.locator('.note.problem').isHidden(), 'a link of the first version opens');
}

async function mangled_link(page, expect) {
  expect(/^The link cannot be read: .*This is the first scenario instead\.$/.test(await complaint(page)), `a link that lost letters is told: ${await complaint(page)}`);
  await playback(page);
}

async function without_webgl(page, expect) {
  const frame = await playback(page);
  expect((await frame.locator('.picture').textContent()).includes('There is no picture: This browser shows no WebGL'), 'it says what is missing');
  await ended(page);
}

async function by_finger(page, expect) {
  const frame = await playback(page);
  await frame.getByRole('button', { name: 'Top', exact: true }).click();
  await frame.getByRole('button', { name: 'Move', exact: true }).click();
  const size = await frame.locator('.handle.start').first().boundingBox();
  expect(size.width >= 22, `a handle is ${size.width} px wide`);
  await keep(page, 'phone-moving');
}

const shipped = (more) => ({ scenario: 'scenarios/swap_8.yaml', yaml: null, seed: null, set: [], beside: null, ...more });
await look_at([[on_the_way, desk], [taken_back, plain_desk],
  [not_on_the_way, { ...plain_desk, fragment: `#play=${await packed(shipped({ version: 2, changes: [{ at_s: 10, set: [['vehicles[*].radius_m', '3']] }] }))}` }],
  [moving, desk], [obstacles_move, desk], [sea, desk], [each_its_method, plain_desk], [thoughts, plain_desk],
  [plain_link, { ...plain_desk, fragment: '#scenario=scenarios/cube20_4.yaml&set=vehicles[*].avoider%3Dapf&seed=5' }],
  [first_version, { ...plain_desk, fragment: `#play=${await packed(shipped({ version: 1, scenario: 'scenarios/head_on.yaml', seed: '3' }))}` }],
  [mangled_link, { ...plain_desk, fragment: '#play=q1ZKSU1MLlGyUiopKk' }],
  [without_webgl, plain_desk], [by_finger, phone]]);
