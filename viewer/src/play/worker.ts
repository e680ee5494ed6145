// SPDX-License-Identifier: Apache-2.0
// The simulator beside the page: it goes on in slices, between which it answers.
import { decompress } from 'fzstd';
import { Simulator } from '../../../bindings/web/module.mjs';
import { reason_of } from '../common/reason';
import { bytes_of, type Answer, type Begun, type Calls, type Layout, type Question } from './module';

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
    trouble = reason_of(error);
  }
}

// A message to oneself comes after those that wait, and sooner than any timer.
const between_slices = new MessageChannel();
const soon = (): void => between_slices.port2.postMessage(turn);
between_slices.port1.onmessage = ({ data: mine }: MessageEvent<number>) => {
  if (mine !== turn || paused || !begun) return;
  const end = performance.now() + slice_ms;
  while (trouble === '' && !simulator.done && performance.now() < end) run(1);
  if (trouble === '' && !simulator.done) soon();
};

/** A run that `load` begins, and that goes on by itself. Where it is refused, the one before goes on. */
function begin(load: () => void): Begun {
  tried(load);
  ++turn;
  trouble = '';
  paused = false;
  begun = true;
  soon();
  return { document: simulator.document(), layout: simulator.layout() as Layout };
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
  think: (vehicles) => simulator.think(vehicles),
  outcome: () => simulator.outcome(),
  explanation: (vehicle, time_s) => simulator.explanation(vehicle, time_s),
  hashes: () => simulator.hashes(),
  order(what) {
    if (what === 'step' && begun && paused && !simulator.done) run(1);
    if (what === 'pause') paused = true;
    if (what === 'resume' && paused) {
      paused = false;
      ++turn;
      soon();
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
  const given: Transferable[] = [];
  try {
    const call = calls[data.call] as (...args: unknown[]) => unknown;
    const result = tried(() => call(...data.args)) ?? null;
    answer = { id: data.id, result };
    if (data.call === 'part') given.push(...bytes_of(result as ReturnType<Calls['part']>));
  } catch (error) {
    answer = { id: data.id, error: reason_of(error) };
  }
  self.postMessage(answer, { transfer: given });
});
