// SPDX-License-Identifier: Apache-2.0
// The curves of a chart at every frame, computed once per frame, and thinned to what a screen can show.
import { first_index } from '../../common/search';
import type { Film } from '../film';
import type { Curves } from './curves';

/** Min and max per pixel: two points a pixel are all that a line can show. */
export interface Thinned {
  times: Float64Array;
  columns: Float64Array[];
}

export class Store {
  count = 0;
  private generation = -1;
  private times = new Float64Array(0);
  private columns: Float64Array[];
  private readonly row: Float64Array;

  constructor(private readonly film: Film, private readonly curves: Curves) {
    this.columns = curves.series.map(() => new Float64Array(0));
    this.row = new Float64Array(curves.series.length).fill(Number.NaN);
  }

  /** Adds the frames that have come in since; O(new frames), O(all) after the film was replaced. */
  update(): void {
    if (this.was_replaced()) this.count = 0;
    this.generation = this.film.generation;
    this.reserve(this.film.count);
    if (this.count === 0) this.row.fill(Number.NaN);
    for (let i = this.count; i < this.film.count; ++i) {
      this.times[i] = this.film.time(i);
      this.curves.read(i, this.row);
      for (let k = 0; k < this.columns.length; ++k) this.columns[k]![i] = this.row[k]!;
    }
    this.count = this.film.count;
  }

  time(i: number): number {
    return this.times[i]!;
  }
  value(k: number, i: number): number {
    return this.columns[k]![i]!;
  }

  /** At most 2 `buckets` points of the frames between two times, and one frame beyond on either side. */
  thinned(from: number, to: number, buckets: number): Thinned {
    const first = Math.max(0, this.first_after(from) - 1);
    const end = Math.min(this.count, this.first_after(to) + 1);
    const length = Math.max(0, end - first);
    if (length <= 2 * buckets) {
      return { times: this.times.subarray(first, end), columns: this.columns.map((values) => values.subarray(first, end)) };
    }
    const edge = (bucket: number): number => first + Math.floor((bucket * length) / buckets);
    const times = new Float64Array(2 * buckets);
    for (let b = 0; b < buckets; ++b) {
      times[2 * b] = this.times[edge(b)]!;
      times[2 * b + 1] = this.times[edge(b + 1) - 1]!;
    }
    return { times, columns: this.columns.map((values) => extremes(values, buckets, edge)) };
  }

  private was_replaced(): boolean {
    const last = this.count - 1;
    return this.film.generation !== this.generation || this.film.count < this.count ||
      (last >= 0 && this.film.time(last) !== this.times[last]);
  }

  private reserve(frames: number): void {
    if (frames <= this.times.length) return;
    const enlarged = (values: Float64Array): Float64Array<ArrayBuffer> => {
      const larger = new Float64Array(Math.max(frames, 2 * values.length));
      larger.set(values);
      return larger;
    };
    this.times = enlarged(this.times);
    this.columns = this.columns.map(enlarged);
  }

  private first_after(time: number): number {
    return first_index(this.count, (i) => this.times[i]! > time);
  }
}

/** Of each bucket the least and the greatest value there is, in the order in which they occur. */
function extremes(values: Float64Array, buckets: number, edge: (bucket: number) => number): Float64Array {
  const thin = new Float64Array(2 * buckets);
  for (let b = 0; b < buckets; ++b) {
    const end = edge(b + 1);
    let least = edge(b);
    let most = least;
    for (let i = least + 1; i < end; ++i) {
      const value = values[i]!;
      if (value < values[least]! || Number.isNaN(values[least]!)) least = i;
      if (value > values[most]! || Number.isNaN(values[most]!)) most = i;
    }
    thin[2 * b] = values[Math.min(least, most)]!;
    thin[2 * b + 1] = values[Math.max(least, most)]!;
  }
  return thin;
}
