// SPDX-License-Identifier: Apache-2.0
// How quick the simulator is in a page: eight Sparus II under ORCA (cube20_8), without a picture, natively and in Chromium and Node.js by
// turns, the quickest of so many. A measurement, no test: node tests/play/speed.mjs [TURNS]. After `scripts/build` and `scripts/web module`.
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Simulator } from '../../bindings/web/module.mjs';
import { chromium_simulator } from './chromium.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const scenario = 'scenarios/cube20_8.yaml';
const order = { yaml: readFileSync(`${root}${scenario}`, 'utf8'), file: scenario, filmed: false };
const bytes = readFileSync(`${root}build/web/fairway.wasm`);
const turns = Number(process.argv[2] ?? 7);

function measured(simulator, asked) {
  simulator.load(asked);
  const begin = performance.now();
  while (!simulator.done) simulator.run(1000);
  return { wall_s: (performance.now() - begin) / 1000, simulated_s: simulator.time_s, memory_bytes: simulator.memory_bytes };
}

function natively() {
  const { stdout } = spawnSync(`${root}build/bin/fairway`, ['run', scenario], { cwd: root, encoding: 'utf8' });
  return Number(/simulated in ([\d.]+) s/.exec(stdout)[1]);
}

const here = new Simulator(new WebAssembly.Module(bytes));
const there = await chromium_simulator(bytes);

const best = { native: Infinity, chromium: Infinity, node: Infinity };
let simulated_s = 0;
const memory = [];
for (let turn = 0; turn < turns; ++turn) {
  best.native = Math.min(best.native, natively());
  const found = await there.ask(measured, order);
  best.chromium = Math.min(best.chromium, found.wall_s);
  memory.push(found.memory_bytes);
  best.node = Math.min(best.node, measured(here, order).wall_s);
  simulated_s = found.simulated_s;
}
await there.end();
for (const [where, wall_s] of Object.entries(best)) {
  console.log(`${where}: ${simulated_s.toFixed(1)} s simulated in ${wall_s.toFixed(3)} s, ${(simulated_s / wall_s).toFixed(0)} times real time, ${(wall_s / best.native).toFixed(2)} times as long as natively`);
}
/** With the film, as the page asks for it: parts as they come. */
function filmed(path, seconds) {
  here.load({ yaml: readFileSync(`${root}${path}`, 'utf8'), file: path, filmed: true, thinkers: [0] });
  const begin = performance.now();
  let count = 0;
  let generation = 0;
  while (!here.done && here.time_s < seconds) {
    here.run(50);
    for (;;) {
      const { part } = here.part(count, generation);
      if (part === null) break;
      count = part.first + part.count;
      generation = part.generation;
    }
  }
  return here.time_s / ((performance.now() - begin) / 1000);
}
for (const [path, seconds] of [['scenarios/swap_8.yaml', Infinity], ['scenarios/fleet_1000.yaml', 20]]) {
  const pace = Math.max(...Array.from({ length: 3 }, () => filmed(path, seconds)));
  console.log(`Node.js, filmed: ${path} at ${pace.toFixed(1)} times real time`);
}
console.log(`memory of the module in Chromium after the first and the last run: ${memory[0]} and ${memory.at(-1)} bytes`);
