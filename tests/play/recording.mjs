// SPDX-License-Identifier: Apache-2.0
// Recordings go both ways: what the command wrote is verified by the module of the page, and what the module wrote by the command.
// FAIRWAY is the command (default build/bin/fairway).
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
const { decompress } = createRequire(`${root}viewer/package.json`)('fzstd');
const simulator = new Simulator(new WebAssembly.Module(readFileSync(`${root}build/web/fairway.wasm`)), decompress);
const folder = mkdtempSync(join(tmpdir(), 'fairway-play-'));
after(() => rmSync(folder, { recursive: true }));

const scenario = `${root}scenarios/sonar_crossing.yaml`;
const recorded = join(folder, 'native.mcap');
const fairway = (...words) => spawnSync(process.env.FAIRWAY ?? `${root}build/bin/fairway`, words, { encoding: 'utf8' });
fairway('run', scenario, '--perception', '--sketch', '--out', recorded);
const bytes = new Uint8Array(readFileSync(recorded));

function verdict_on(what) {
  simulator.load_recording(what, 'native.mcap');
  while (!simulator.done) simulator.run(10_000);
  return simulator.outcome();
}

test('a recording of the command, with what was perceived and drawn, is the same run here, in the words of the command', () => {
  const { same, verdict } = verdict_on(bytes);
  assert.equal(same, true);
  assert.equal(verdict, JSON.parse(fairway('replay', recorded, '--verify', '--json').stdout).verdict);
});

test('a recording in which a digit was changed is refused', () => {
  const short = join(folder, 'short.mcap');
  fairway('run', scenario, '--set', 'duration_s=20', '--out', short);
  const changed = readFileSync(short);
  const at = changed.indexOf('duration_s: 20');
  assert.ok(at > 0);
  changed.write('duration_s: 10', at);
  assert.throws(() => verdict_on(new Uint8Array(changed)), /native\.mcap: .*checksum/);
});

test('what is no recording is refused with the line of the command', () => {
  for (const damaged of [bytes.slice(0, 1000), bytes.slice(5), new Uint8Array(0)]) {
    const file = join(folder, 'native.mcap');
    writeFileSync(file, damaged);
    const line = fairway('replay', file, '--verify').stderr.replaceAll(file, 'native.mcap').replace(/^fairway: /, '').trim();
    assert.throws(() => simulator.load_recording(damaged, 'native.mcap'), { message: line });
  }
  writeFileSync(recorded, bytes);
});

test('a recording that the page saves is the same run for the command', () => {
  simulator.load({ yaml: readFileSync(scenario, 'utf8'), file: scenario, seed: '5', filmed: false });
  const saved = join(folder, 'saved.mcap');
  writeFileSync(saved, simulator.recording());
  const { status, stdout } = fairway('replay', saved, '--verify', '--json');
  assert.equal(status, 0, stdout);
  assert.match(stdout, /"recorded_on": "wasm, clang/);
  while (!simulator.done) simulator.run(10_000);
  assert.equal(JSON.parse(fairway('replay', saved, '--json').stdout).run_hash, simulator.hash);
});
