// SPDX-License-Identifier: Apache-2.0
// The simulator beside the page: it goes on in slices, between which it answers.
import { decompress } from 'fzstd';
import { Simulator } from '../../../bindings/web/module.mjs';
import type { Answer, Calls, Question } from './module';

const slice_ms = 12;

let compiled: WebAssembly.Module;
let simulator: Simulator;
let begun = false;
let paused = false;
let trouble = '';
let turn = 0;

/** A module that has broken off is made anew: what it had in memory cannot be trusted. */
function tried<T>(work: () => T): T {
  try {
    return work();
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) {
      const words = simulator.last_words;
      simulator = new Simulator(compiled, decompress);
      begun = false;
      throw new Error(`the simulator broke off: ${words === '' ? error.message : words}`);
    }
    throw error;
  }
}

function run(steps: number): void {
  try {
    tried(() => simulator.run(steps));
  } catch (error) {
    trouble = error instanceof Error ? error.message : String(error);
  }
}

function go_on(mine: number): void {
  if (mine !== turn || paused) return;
  const end = performance.now() + slice_ms;
  while (trouble === '' && !simulator.done && performance.now() < end) run(1);
  if (trouble === '' && !simulator.done) setTimeout(() => go_on(mine));
}

/** A run that `load` begins, and that goes on by itself. */
function begin(load: () => void): Record<string, unknown> {
  const mine = ++turn;
  trouble = '';
  paused = false;
  begun = false;
  tried(load);
  begun = true;
  setTimeout(() => go_on(mine));
  return simulator.document();
}

const calls: { [K in keyof Calls]: (...args: Parameters<Calls[K]>) => unknown } = {
  names: () => simulator.names(),
  describe: (name) => simulator.describe(name),
  begin: (order) => begin(() => simulator.load(order)),
  verify: (bytes, file) => begin(() => simulator.load_recording(bytes, file)),
  recording: () => simulator.recording(),
  part(first, generation) {
    if (!begun) throw new Error(trouble === '' ? 'no run has begun' : trouble);
    const answer = simulator.part(first, generation);
    answer.state.paused = paused && !simulator.done;
    if (trouble !== '') Object.assign(answer.state, { done: true, divergence: `ended: ${trouble}` });
    return answer;
  },
  outcome: () => simulator.outcome(),
  explanation: (vehicle, time_s) => simulator.explanation(vehicle, time_s),
  hashes: () => simulator.hashes(),
  order(what) {
    if (what === 'step' && paused && !simulator.done) run(1);
    if (what === 'pause') paused = true;
    if (what === 'resume' && paused) {
      paused = false;
      go_on(++turn);
    }
  },
};

self.addEventListener('message', ({ data }: MessageEvent<Question>) => {
  if ('module' in data) {
    compiled = data.module;
    simulator = new Simulator(compiled, decompress);
    return;
  }
  let answer: Answer;
  try {
    const call = calls[data.call] as (...args: unknown[]) => unknown;
    answer = { id: data.id, result: tried(() => call(...data.args)) ?? null };
  } catch (error) {
    answer = { id: data.id, error: error instanceof Error ? error.message : String(error) };
  }
  self.postMessage(answer);
});
