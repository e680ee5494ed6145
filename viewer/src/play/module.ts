// SPDX-License-Identifier: Apache-2.0
// What this page and its Worker say to each other about the simulator in fairway.wasm.

import type { Explanation } from '../playback/model';
import type { Handle } from '../playback/source';

/** A run to be begun: a scenario, and changes in it as --set makes them. */
export interface Order {
  yaml: string;
  /** Its name in messages and in the command. */
  file: string;
  set: [path: string, value: string][];
  /** Null: the scenario's. */
  seed: string | null;
  /** To be shown. */
  filmed: boolean;
  /** Whose thoughts are filmed, by index. */
  thinkers: readonly number[];
  /** From an instant on it has these changes too; ascending. */
  changes: { at_s: number; set: [path: string, value: string][] }[];
}

export interface Layout {
  handles: Handle[];
  /** Null where there is no fleet. */
  fleet_count: number | null;
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
  /** JSON schema of a scenario's keys. */
  schema: unknown;
}

export interface Begun {
  /** The playback's. */
  document: Record<string, unknown>;
  layout: Layout;
}

/** What can be asked of the Worker, and what it answers. */
export interface Calls {
  names(): Names;
  describe(name: string): { parameters: Parameter[] };
  /** Begins a run, which goes on by itself. */
  begin(order: Order): Begun;
  /** Likewise that of a recording, with which it is compared. */
  verify(bytes: Uint8Array, file: string): Begun;
  /** MCAP, of the run that has begun. */
  recording(): Uint8Array<ArrayBuffer>;
  /** {"part", "state"} of the live page; the part's columns are bytes. */
  part(first: number, generation: number): { part: { data: Uint8Array<ArrayBuffer> } | null; state: { done: boolean; time_s: number } };
  /** From now on the film has what these vehicles think, by index, from the beginning. */
  think(vehicles: readonly number[]): void;
  outcome(): Outcome;
  /** Of the vehicle of this index and the decision in force at this time. */
  explanation(vehicle: string, time_s: number): Explanation;
  /** Of each frame so far, 16 hexadecimal digits. */
  hashes(): string[];
  order(what: 'pause' | 'resume' | 'step'): void;
}

/** What of a part is handed on and not copied. */
export const bytes_of = ({ part }: ReturnType<Calls['part']>): Transferable[] => (part === null ? [] : [part.data.buffer]);

export type Question = { id: number; call: keyof Calls; args: unknown[] } | { module: WebAssembly.Module };
export type Answer = { id: number; result: unknown } | { id: number; error: string };
