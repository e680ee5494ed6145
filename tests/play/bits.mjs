// SPDX-License-Identifier: Apache-2.0
// Every shipped scenario, simulated by the WebAssembly module in this Node.js: the frames' hashes are those of hashes.txt, which the
// native build makes. tests/play/bits.mjs [chromium] [PART/PARTS] [NAME...]: in Chromium; a share of the scenarios, or those whose path holds
// a name.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { chromium_simulator } from './chromium.mjs';
import { Simulator } from '../../bindings/web/module.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const read = (path) => readFileSync(`${root}${path}`, 'utf8');
const golden = read('tests/replay/hashes.txt').split('\n').filter((line) => line !== '' && !line.startsWith('#')).map((line) => line.split(' '));

// What searches a path by OMPL, which the module has not: it has to say so, and may not come to another hash.
const absent = 'searches a path by OMPL';

const words = process.argv.slice(2);
const in_chromium = words[0] === 'chromium';
if (in_chromium) words.shift();
const share = /^(\d+)\/(\d+)$/.exec(words[0] ?? '');
if (share !== null) words.shift();
const chosen = golden.filter(([path], i) => (share === null || i % Number(share[2]) === Number(share[1])) &&
  (words.length === 0 || words.some((word) => path.includes(word))));
if (chosen.length === 0) throw new Error(`no scenario of hashes.txt is called ${words.join(' or ')}`);

/** The hash of all frames. */
function simulated(simulator, order) {
  simulator.load(order);
  while (!simulator.done) simulator.run(10_000);
  return simulator.hash;
}

const bytes = readFileSync(`${root}build/web/fairway.wasm`);
const there = in_chromium ? await chromium_simulator(bytes) : null;
const here = in_chromium ? null : new Simulator(new WebAssembly.Module(bytes));
const hash_of = (order) => (there === null ? simulated(here, order) : there.ask(simulated, order));
let same = 0;
const without = [];
const other = [];
for (const [path, hash] of chosen) {
  try {
    const found = await hash_of({ yaml: read(path), file: path, filmed: false });
    if (found === hash) ++same;
    else other.push(`${path}: ${found}, expected ${hash}`);
  } catch (error) {
    if (error.message.includes(absent)) without.push(path);
    else other.push(`${path}: ${error.message}`);
  }
}
await there?.end();
console.log(`${in_chromium ? 'Chromium' : 'Node.js'}: ${same} scenarios came to the bits of the native build; ${without.length} need OMPL and say so: ${without.join(' ')}`);
for (const line of other) console.log(line);
process.exit(other.length === 0 && same > 0 ? 0 : 1);
