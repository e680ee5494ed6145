// SPDX-License-Identifier: Apache-2.0
// Where vehicles have been and will go: the whole run in one buffer, of which time shows what is past.
import { Group, Vector3 } from 'three';
import type { Film } from '../../film';
import type { Extent } from '../extent';
import { Lines } from '../ink/lines';
import { order, type Now, type Part } from '../part';
import { vector_at } from '../poses';

/** More lines than this are not seen, only paid for; a frame is left out between two that are kept. */
const most_lines = 32_000;

const from = new Vector3();
const to = new Vector3();

export class Trails implements Part {
  readonly object = new Group();
  private readonly whole: Lines;
  /** From the last frame kept to where the vehicle is, and from there to the next. */
  private readonly heads = new Lines(2.6, order.trails, { timed: true });
  private generation = -1;
  private stride = 1;
  private frames = 0;
  /** The look of each line's vehicle: changed only when the choice or theme does. */
  private look = '';

  constructor(private readonly film: Film) {
    this.whole = new Lines(2.6, order.trails, { timed: true, capacity: 1024 });
    this.object.add(this.whole.object, this.heads.object);
  }

  set_extent(extent: Extent): void {
    // A trail stays fresh for as long as it takes to cross a quarter of the scene.
    const fade = Math.max(4, (0.5 * extent.radius * extent.seconds) / Math.max(extent.step, 1));
    for (const lines of [this.whole, this.heads]) lines.uniform('fade_s', fade);
  }

  show(now: Now): void {
    const look = `${[...now.chosen].join()}/${now.colours.deep.getHex()}`;
    this.take_frames(now, look !== this.look);
    this.look = look;
    this.whole.uniform('now', now.moment.time);
    this.heads.uniform('now', now.moment.time);
    this.show_heads(now);
  }

  /** Adds the frames that have come in since; begins anew where there are too many or others. */
  private take_frames(now: Now, other_look: boolean): void {
    const { film } = this;
    const stride = 2 ** Math.max(0, Math.ceil(Math.log2((film.count * film.vehicles) / most_lines)));
    const anew = film.generation !== this.generation || stride !== this.stride || film.count < this.frames;
    if (anew) {
      this.whole.clear();
      this.frames = 0;
      this.generation = film.generation;
      this.stride = stride;
    }
    const added = this.add_lines(now);
    if (anew || added) this.whole.commit();
    if (other_look && !anew) this.retint(now);
  }

  private add_lines(now: Now): boolean {
    const { film, stride } = this;
    const before = this.frames;
    for (let i = this.frames; i + stride < film.count; i += stride) {
      for (let v = 0; v < film.vehicles; ++v) {
        this.whole.add_timed(vector_at(film, 'position_m', i, v, from), vector_at(film, 'position_m', i + stride, v, to), film.time(i), film.time(i + stride), ...this.tint(now, v));
      }
      this.frames = i + stride;
    }
    return this.frames !== before;
  }

  private retint(now: Now): void {
    for (let k = 0; k < this.whole.count; ++k) this.whole.tint_at(k, ...this.tint(now, k % this.film.vehicles));
    this.whole.commit_tint();
  }

  private tint(now: Now, vehicle: number): [Now['colours']['ink'], number] {
    return [now.colours.vehicle(vehicle), now.chosen.size === 0 || now.chosen.has(vehicle) ? 1 : 0.28];
  }

  private show_heads(now: Now): void {
    const { film, stride } = this;
    const { time } = now.moment;
    const kept = Math.min(Math.floor(now.moment.index / stride) * stride, this.frames);
    const next = Math.min(kept + stride, film.count - 1);
    this.heads.clear();
    for (let v = 0; film.count > 0 && v < film.vehicles; ++v) {
      const here = now.poses.positions[v]!;
      this.heads.add_timed(vector_at(film, 'position_m', kept, v, from), here, film.time(kept) - 1e-9, time, ...this.tint(now, v));
      if (next > now.moment.index) this.heads.add_timed(here, vector_at(film, 'position_m', next, v, to), time, film.time(next), ...this.tint(now, v));
    }
    this.heads.commit();
  }
}
