// SPDX-License-Identifier: Apache-2.0
// What this page and its Worker say to each other about the simulator in fairway.wasm.

import type { Explanation } from '../playback/model';

/** A run to be begun: a scenario, and changes in it as --set makes them. */
export interface Order {
  yaml: string;
  /** Its name in messages and in the command. */
  file: string;
  set: [path: string, value: string][];
  /** Null: the scenario's. */
  seed: string | null;
  /** With what vehicles think, to be shown. */
  filmed: boolean;
}

export interface Outcome {
  outcome: 'finished' | 'diverged';
  diverged?: string;
  simulated_s: number;
  fleet: Record<string, number | null>;
  /** Of a run that is compared with a recording. */
  verdict?: string;
}

export interface Parameter {
  name: string;
  type: string;
  default: number | boolean | string;
  meaning: string;
  unit?: string;
  range?: [number | null, number | null];
  choices?: string[];
}

export interface Names {
  algorithms: { name: string; title: string; wraps: boolean }[];
  vehicles: { name: string; title: string }[];
  exchanges: { name: string; title: string }[];
}

/** What can be asked of the Worker, and what it answers. */
export interface Calls {
  names(): Names;
  describe(name: string): { parameters: Parameter[] };
  /** Begins a run, which goes on by itself, and answers with the playback's document. */
  begin(order: Order): Record<string, unknown>;
  /** Likewise of the run of a recording, with which it is compared. */
  verify(bytes: Uint8Array, file: string): Record<string, unknown>;
  /** MCAP, of the run that has begun. */
  recording(): Uint8Array<ArrayBuffer>;
  /** {"part", "state"} of the live page. */
  part(first: number, generation: number): { part: unknown; state: { done: boolean } };
  outcome(): Outcome;
  /** Of the vehicle of this index and the decision in force at this time. */
  explanation(vehicle: string, time_s: number): Explanation;
  /** Of each frame so far, 16 hexadecimal digits. */
  hashes(): string[];
  order(what: 'pause' | 'resume' | 'step'): void;
}

export type Question = { id: number; call: keyof Calls; args: unknown[] } | { module: WebAssembly.Module };
export type Answer = { id: number; result: unknown } | { id: number; error: string };
