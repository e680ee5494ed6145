// SPDX-License-Identifier: Apache-2.0
// The frames of a run, in typed arrays that grow as parts come in.
import { decompress } from 'fzstd';
import { first_index } from '../common/search';
import type { ColumnSpec, ColumnType, EchoesRecord, Flight, Part, RunEvent, SketchRecord, Thoughts, TracksRecord, Vec3, WordRecord } from './model';

type Values = Float64Array | Float32Array | Uint8Array;
const makers: Record<ColumnType, { bytes: number; of: (buffer: ArrayBuffer) => Values; empty: (length: number) => Values }> = {
  f64: { bytes: 8, of: (b) => new Float64Array(b), empty: (n) => new Float64Array(n) },
  f32: { bytes: 4, of: (b) => new Float32Array(b), empty: (n) => new Float32Array(n) },
  u8: { bytes: 1, of: (b) => new Uint8Array(b), empty: (n) => new Uint8Array(n) },
};

export function from_base64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

function unpack(data: Part['data'], compression: Part['compression']): Uint8Array {
  if (typeof data !== 'string') return data;
  const bytes = from_base64(data);
  return compression === 'zstd' ? decompress(bytes) : bytes;
}

/** A column: `width` values per vehicle and frame, or per frame; frame after frame. */
interface Column {
  spec: ColumnSpec;
  stride: number;
  values: Values;
}

/** Records that stand until the next one of the same vehicle. */
class Standing<R extends { time_s: number; vehicle: number }> {
  private readonly of_vehicle: R[][];
  constructor(vehicles: number) {
    this.of_vehicle = Array.from({ length: vehicles }, () => []);
  }
  add(records: R[]): void {
    for (const record of records) this.of_vehicle[record.vehicle]?.push(record);
  }
  clear(): void {
    for (const records of this.of_vehicle) records.length = 0;
  }
  get any(): boolean {
    return this.of_vehicle.some((records) => records.length > 0);
  }
  at(vehicle: number, time: number): R | null {
    const records = this.of_vehicle[vehicle] ?? [];
    const i = last_not_after(records.length, (k) => records[k]!.time_s, time);
    return i < 0 ? null : records[i]!;
  }
}

/** Of ascending times, the last that is at or before `time`; -1 if all are later. */
function last_not_after(count: number, time_of: (i: number) => number, time: number): number {
  return first_index(count, (i) => time_of(i) > time) - 1;
}

export class Film {
  count = 0;
  generation = 0;
  stride = 1;
  readonly events: RunEvent[] = [];
  readonly flights: Flight[] = [];
  readonly sketches: Standing<SketchRecord>;
  readonly tracks: Standing<TracksRecord>;
  readonly echoes: Standing<EchoesRecord>;
  readonly words: Standing<WordRecord>;
  private capacity = 0;
  private readonly columns = new Map<string, Column>();

  constructor(specs: ColumnSpec[], readonly vehicles: number) {
    for (const spec of specs) {
      const stride = spec.width * (spec.per === 'vehicle' ? vehicles : 1);
      this.columns.set(spec.name, { spec, stride, values: makers[spec.type].empty(0) });
    }
    this.sketches = new Standing(vehicles);
    this.tracks = new Standing(vehicles);
    this.echoes = new Standing(vehicles);
    this.words = new Standing(vehicles);
  }

  /** Adds a part that follows on what is there; one that begins at 0 replaces everything. */
  append(part: Part): void {
    if (part.first === 0) this.clear();
    if (part.first !== this.count) throw new Error(`a part begins at frame ${part.first}; expected ${this.count}`);
    this.generation = part.generation;
    this.stride = part.stride;
    this.reserve(this.count + part.count);
    const bytes = unpack(part.data, part.compression);
    let at = 0;
    for (const column of this.columns.values()) {
      const maker = makers[column.spec.type];
      const size = part.count * column.stride * maker.bytes;
      if (at + size > bytes.length) throw new Error('a part of the film is too short');
      // Copied, so that values are aligned wherever they lie.
      column.values.set(maker.of(bytes.slice(at, at + size).buffer as ArrayBuffer) as never, this.count * column.stride);
      at += size;
    }
    if (at !== bytes.length) throw new Error('a part of the film is too long');
    this.count += part.count;
    // One by one: a call cannot have as many arguments as there may be events and messages.
    for (const event of part.events) this.events.push(event);
    if (part.thoughts_anew) this.forget_thoughts();
    if (part.thoughts !== '') this.add_thoughts(JSON.parse(new TextDecoder().decode(unpack(part.thoughts, part.compression))) as Thoughts);
  }

  private add_thoughts(thoughts: Thoughts): void {
    this.sketches.add(thoughts.sketches);
    this.tracks.add(thoughts.tracks);
    this.echoes.add(thoughts.echoes);
    this.words.add(thoughts.words);
    for (const flight of thoughts.flights) this.flights.push(flight);
  }

  private clear(): void {
    this.count = 0;
    this.events.length = 0;
    this.forget_thoughts();
  }

  private forget_thoughts(): void {
    this.flights.length = 0;
    this.sketches.clear();
    this.tracks.clear();
    this.echoes.clear();
    this.words.clear();
  }

  private reserve(frames: number): void {
    if (frames <= this.capacity) return;
    this.capacity = Math.max(frames, 2 * this.capacity);
    for (const column of this.columns.values()) {
      const grown = makers[column.spec.type].empty(this.capacity * column.stride);
      grown.set(column.values as never);
      column.values = grown;
    }
  }

  private column(name: string): Column {
    const column = this.columns.get(name);
    if (column === undefined) throw new Error(`the film has no column ${name}`);
    return column;
  }

  width(name: string): number {
    return this.column(name).spec.width;
  }

  /** Component `k` of a vehicle's value in frame `i`; of a value per frame, `vehicle` is 0. */
  value(name: string, i: number, vehicle: number, k = 0): number {
    const { values, stride, spec } = this.column(name);
    return values[i * stride + vehicle * spec.width + k]!;
  }

  vector(name: string, i: number, vehicle: number): Vec3 {
    return [this.value(name, i, vehicle, 0), this.value(name, i, vehicle, 1), this.value(name, i, vehicle, 2)];
  }

  /** Of a value of three components. */
  length(name: string, i: number, vehicle: number): number {
    return Math.hypot(this.value(name, i, vehicle, 0), this.value(name, i, vehicle, 1), this.value(name, i, vehicle, 2));
  }

  time(i: number): number {
    return this.value('time_s', i, 0);
  }

  get end(): number {
    return this.count === 0 ? 0 : this.time(this.count - 1);
  }

  /** The last frame at or before `time`; 0 before the first. */
  index_at(time: number): number {
    return Math.max(0, last_not_after(this.count, (i) => this.time(i), time));
  }
}

/** An instant of a film: the frame at or before it, and how far the next one is, in [0, 1). */
export interface Moment {
  time: number;
  index: number;
  part: number;
}

export function moment_at(film: Film, time: number): Moment {
  const index = film.index_at(time);
  if (index + 1 >= film.count) return { time, index, part: 0 };
  const from = film.time(index);
  const part = (time - from) / (film.time(index + 1) - from);
  return { time, index, part: Math.min(Math.max(part, 0), 1) };
}
