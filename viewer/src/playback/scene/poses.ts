// SPDX-License-Identifier: Apache-2.0
// Where every vehicle is at a moment, in the axes of the picture.
import { Quaternion, Vector3 } from 'three';
import type { Film, Moment } from '../film';
import { place, turn } from './axes';

const from = new Vector3();
const to = new Vector3();
const turn_to = new Quaternion();

/** A column of three in the axes of the picture. */
export function vector_at(film: Film, column: string, frame: number, vehicle: number, out = new Vector3()): Vector3 {
  return place(film.value(column, frame, vehicle, 0), film.value(column, frame, vehicle, 1), film.value(column, frame, vehicle, 2), out);
}

function attitude_in(film: Film, frame: number, vehicle: number, out: Quaternion): Quaternion {
  return turn(film.value('attitude', frame, vehicle, 0), film.value('attitude', frame, vehicle, 1),
    film.value('attitude', frame, vehicle, 2), film.value('attitude', frame, vehicle, 3), out);
}

/** A vehicle's position between the frames of a moment. */
export function position_at(film: Film, moment: Moment, vehicle: number, out = new Vector3()): Vector3 {
  vector_at(film, 'position_m', moment.index, vehicle, out);
  return moment.part === 0 ? out : out.lerp(vector_at(film, 'position_m', moment.index + 1, vehicle, to), moment.part);
}

export function attitude_at(film: Film, moment: Moment, vehicle: number, out = new Quaternion()): Quaternion {
  attitude_in(film, moment.index, vehicle, out);
  return moment.part === 0 ? out : out.slerp(attitude_in(film, moment.index + 1, vehicle, turn_to), moment.part);
}

/** Heading about the moment, averaged over `window_s` of the run on either side: a function of time alone, so a
 * camera that keeps behind it never jumps, however the film is played. In radians, 0 north, positive to starboard. */
export function steady_heading(film: Film, moment: Moment, vehicle: number, window_s: number): number {
  const first = film.index_at(moment.time - window_s);
  const last = film.index_at(moment.time + window_s);
  const step = Math.max(1, Math.floor((last - first) / 32));
  from.set(0, 0, 0);
  for (let i = first; i <= last; i += step) {
    // A triangular weight lets frames enter and leave the window without a step.
    const weight = Math.max(1e-3, 1 - Math.abs(film.time(i) - moment.time) / window_s);
    from.addScaledVector(to.set(0, 0, -1).applyQuaternion(attitude_in(film, i, vehicle, turn_to)), weight);
  }
  return Math.atan2(from.x, -from.z);
}

/** All of them at once, computed once per moment and read by every part of the picture. */
export class Poses {
  readonly positions: Vector3[];
  readonly attitudes: Quaternion[];
  constructor(private readonly film: Film) {
    this.positions = Array.from({ length: film.vehicles }, () => new Vector3());
    this.attitudes = Array.from({ length: film.vehicles }, () => new Quaternion());
  }
  update(moment: Moment): void {
    for (let v = 0; v < this.film.vehicles; ++v) {
      position_at(this.film, moment, v, this.positions[v]);
      attitude_at(this.film, moment, v, this.attitudes[v]);
    }
  }
}
