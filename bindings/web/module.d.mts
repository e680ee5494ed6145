// SPDX-License-Identifier: Apache-2.0
/** The simulator in fairway.wasm. What fails throws an Error whose message is the module's line; so does what is asked of a run before one has begun. */
export class Simulator {
  /** `compiled` is fairway.wasm; `unzstd` unpacks a frame of zstd, as fzstd's decompress, for whoever reads recordings. */
  constructor(compiled: WebAssembly.Module, unzstd?: (frame: Uint8Array) => Uint8Array);
  /** Begins a run; the one before it is gone, and goes on where this one is refused. */
  load(order: object): void;
  /** Likewise the run of a recording, which is compared with it; the outcome has `same` and `verdict` then. */
  load_recording(bytes: Uint8Array, file: string): void;
  /** The recording of this run, MCAP. */
  recording(): Uint8Array;
  /** At most so many steps; how many were made. */
  run(steps: number): number;
  readonly done: boolean;
  readonly time_s: number;
  /** Of all frames so far, as a recording has it: 16 hexadecimal digits. */
  readonly hash: string;
  readonly memory_bytes: number;
  /** What was written where a program has its standard error. */
  readonly last_words: string;
  /** The playback's document, without a film. */
  document(): Record<string, unknown>;
  /** What of the scenario may be moved: `handles` and `fleet_count` (layout.hpp). */
  layout(): unknown;
  /** The columns are in `data`, as bytes. */
  part(first: number, generation: number): { part: { data: Uint8Array<ArrayBuffer> } | null; state: Record<string, unknown> };
  /** The film has what these vehicles think, by index, from the beginning. */
  think(vehicles: readonly number[]): void;
  outcome(): unknown;
  names(): unknown;
  /** Why a vehicle, by name, id or index, decided as it did: the `explanation` of the playback's document. */
  explanation(vehicle: string, time_s: number): unknown;
  describe(name: string): unknown;
  /** Of each frame so far, likewise. */
  hashes(): string[];
}
