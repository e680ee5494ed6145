// SPDX-License-Identifier: Apache-2.0
// What the command refuses, the module in a page refuses with the same line: same place, same words. And numbers that are hard to read
// come to the same bits. FAIRWAY is the command (default build/bin/fairway).
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { Simulator } from '../../bindings/web/module.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const module = new WebAssembly.Module(readFileSync(`${root}build/web/fairway.wasm`));
const { decompress } = createRequire(`${root}viewer/package.json`)('fzstd');
const simulator = new Simulator(module, decompress);
const head_on = readFileSync(`${root}scenarios/head_on.yaml`, 'utf8');
const folder = mkdtempSync(join(tmpdir(), 'fairway-play-'));
after(() => rmSync(folder, { recursive: true }));

function natively(yaml, ...more) {
  const file = join(folder, 'scenario.yaml');
  writeFileSync(file, yaml);
  const { status, stderr, stdout } = spawnSync(process.env.FAIRWAY ?? `${root}build/bin/fairway`, ['run', file, ...more], { encoding: 'utf8' });
  return { status, line: stderr.replaceAll(file, 'scenario.yaml').replace(/^fairway: /, '').trim(), stdout };
}

function in_page(order) {
  try {
    simulator.load({ file: 'scenario.yaml', filmed: false, ...order });
    return '';
  } catch (error) {
    return error.message;
  }
}

const refused = {
  'a key that there is not': head_on.replace('vehicles:', 'vehiclez:'),
  'a list that is not closed': `${head_on}\nextra: [1, 2`,
  'a tab that indents': head_on.replace('\n  ', '\n\t'),
  'a number beyond all numbers': head_on.replace(/duration_s: \S+/, 'duration_s: 1e999'),
  'a number below all numbers': head_on.replace(/duration_s: \S+/, 'duration_s: 1e-999'),
  'a number that is none': head_on.replace(/duration_s: \S+/, 'duration_s: 12x'),
  'a number out of its range': head_on.replace(/duration_s: \S+/, 'duration_s: -1'),
  'a method that there is not': head_on.replace('orca3d', 'orca4d'),
  'an alias without an anchor': `${head_on}\nsummary2: *nowhere`,
  'two documents': `${head_on}\n---\nname: x\n`,
  'nothing': '',
  'a key behind letters of several bytes': head_on.replace('vehicles:', "x: {'数据🐟': 1, '数据🐟': 2}\nvehicles:"),
};

for (const [what, yaml] of Object.entries(refused)) {
  test(`${what} is refused with the line of the command`, () => {
    assert.notEqual(yaml, head_on);
    const { status, line } = natively(yaml);
    assert.equal(status, 2);
    assert.equal(in_page({ yaml }), line);
  });
}

test('a change that cannot be made is refused with the line of the command', () => {
  const set = ['vehicles[9].radius_m', '1'];
  assert.equal(in_page({ yaml: head_on, set: [set] }), natively(head_on, '--set', set.join('=')).line);
});

test('numbers that are hard to read have the same bits', () => {
  // halfway between two doubles, a digit more, more digits than a double has, an exponent
  for (const number of ['0.30000000000000004', '2.00000000000000022204460492503130808', '2.000000000000000222044604925031308085', '+1.5', '1.7976931348623157000001', '9007199254740993e-16']) {
    const set = ['vehicles[0].radius_m', number];
    const { stdout } = natively(head_on, '--set', set.join('='), '--json');
    assert.equal(in_page({ yaml: head_on, set: [set] }), '');
    while (!simulator.done) simulator.run(10_000);
    assert.deepEqual(simulator.outcome().fleet, JSON.parse(stdout).fleet, number);
  }
});

test('a simulator that has refused goes on with the next scenario', () => {
  assert.notEqual(in_page({ yaml: 'vehicles: 3' }), '');
  assert.equal(in_page({ yaml: head_on }), '');
  assert.equal(simulator.run(10), 10);
});

test('a run goes on where the next one is refused', () => {
  assert.equal(in_page({ yaml: head_on }), '');
  simulator.run(10);
  const { time_s, hash } = simulator;
  assert.notEqual(in_page({ yaml: head_on, seed: '-3' }), '');
  assert.notEqual(in_page({ yaml: '' }), '');
  assert.throws(() => simulator.load_recording(new Uint8Array(9), 'run.mcap'), /run\.mcap: /);
  assert.equal(simulator.time_s, time_s);
  assert.equal(simulator.hash, hash);
  assert.equal(simulator.hashes().length, 10);
  while (!simulator.done) simulator.run(10_000);
  assert.equal(simulator.outcome().outcome, 'finished');
  assert.ok(simulator.explanation('0', time_s).headline !== undefined);
});

test('before a run has begun everything that is asked of it says so', () => {
  const fresh = new Simulator(module);
  const asked = {
    run: () => fresh.run(1), done: () => fresh.done, time: () => fresh.time_s, hash: () => fresh.hash, hashes: () => fresh.hashes(),
    document: () => fresh.document(), layout: () => fresh.layout(), part: () => fresh.part(0, 0), think: () => fresh.think([0]),
    outcome: () => fresh.outcome(), explanation: () => fresh.explanation('0', 0), recording: () => fresh.recording(),
  };
  for (const [what, ask] of Object.entries(asked)) assert.throws(ask, { message: 'no run has begun' }, what);
  assert.throws(() => fresh.load({ yaml: '', file: 'scenario.yaml' }), /scenario\.yaml/);
  for (const [what, ask] of Object.entries(asked)) assert.throws(ask, { message: 'no run has begun' }, `${what}, after one that was refused`);
  assert.ok(fresh.names().algorithms.length > 0);
});
