// SPDX-License-Identifier: Apache-2.0
// How quick the simulator is in a page: eight Sparus II under ORCA (cube20_8), without a picture, natively and in Chromium and Node.js by
// turns, the quickest of so many. A measurement, no test: node tests/play/speed.mjs [TURNS]. After `scripts/build` and `scripts/web module`.
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { Simulator } from '../../bindings/web/module.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const { chromium } = createRequire(`${root}viewer/package.json`)('playwright-core');
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
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true, args: ['--no-sandbox'] });
const page = await browser.newPage();
const source = readFileSync(`${root}bindings/web/module.mjs`, 'utf8').replace('export class', 'class');
await page.addScriptTag({ content: `${source}\nwindow.Simulator = Simulator;\nwindow.measured = ${measured};` });
await page.evaluate(async (packed) => {
  const module = await WebAssembly.compile(Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0)));
  window.simulator = new window.Simulator(module);
}, bytes.toString('base64'));

const best = { native: Infinity, chromium: Infinity, node: Infinity };
let simulated_s = 0;
const memory = [];
for (let turn = 0; turn < turns; ++turn) {
  best.native = Math.min(best.native, natively());
  const there = await page.evaluate((asked) => window.measured(window.simulator, asked), order);
  best.chromium = Math.min(best.chromium, there.wall_s);
  memory.push(there.memory_bytes);
  best.node = Math.min(best.node, measured(here, order).wall_s);
  simulated_s = there.simulated_s;
}
await browser.close();
for (const [where, wall_s] of Object.entries(best)) {
  console.log(`${where}: ${simulated_s.toFixed(1)} s simulated in ${wall_s.toFixed(3)} s, ${(simulated_s / wall_s).toFixed(0)} times real time, ${(wall_s / best.native).toFixed(2)} times as long as natively`);
}
console.log(`memory of the module in Chromium after the first and the last run: ${memory[0]} and ${memory.at(-1)} bytes`);
