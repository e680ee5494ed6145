// SPDX-License-Identifier: Apache-2.0
// How far everything reaches that happens, and the scales that follow from it.
import { Box3, Vector3 } from 'three';
import type { Film } from '../film';
import type { Scene } from '../model';
import { place_of } from './axes';
import { vector_at } from './poses';

/** The next of 1, 2, 5, 10, ... that is not below `value`. */
export function round_up(value: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1e-9)));
  const step = [1, 2, 5, 10].find((s) => s * power >= value * 0.999) ?? 10;
  return step * power;
}

export interface Extent {
  /** Of vehicles, goals and obstacles, in the axes of the picture. */
  box: Box3;
  /** Of the grid, a multiple of `step` in every direction. */
  frame: Box3;
  step: number;
  depth_step: number;
  /** What a camera has to take in. */
  view: Box3;
  /** Half of the box' longest diagonal. */
  radius: number;
  /** Whether there is a sea surface to show, and whether all of it happens there. */
  surface: boolean;
  afloat: boolean;
  /** How long a velocity is drawn: where it leads in this time [s]. */
  seconds: number;
}

const point = new Vector3();

/** Half a vehicle, and its inner sphere. */
function margin_of(scene: Scene): number {
  return Math.max(scene.exam.safety_distance_m, ...scene.vehicles.map((v) => v.length_m)) / 2;
}

function trails_box(scene: Scene, film: Film): Box3 {
  const box = new Box3();
  const step = Math.max(1, Math.floor(film.count / 400));
  for (let i = 0; i < film.count; i += step) {
    for (let v = 0; v < film.vehicles; ++v) {
      for (const column of ['position_m', 'goal_m']) {
        vector_at(film, column, i, v, point);
        if (Number.isFinite(point.x + point.y + point.z)) box.expandByPoint(point);
      }
    }
  }
  if (box.isEmpty()) box.expandByPoint(point.set(0, 0, 0));
  return box.expandByScalar(margin_of(scene));
}

function top_speed(film: Film): number {
  let fastest = 0;
  const step = Math.max(1, Math.floor(film.count / 100));
  for (let i = 0; i < film.count; i += step) {
    for (let v = 0; v < film.vehicles; ++v) {
      fastest = Math.max(fastest, film.length('velocity_mps', i, v));
    }
  }
  return fastest > 0 ? fastest : 1;
}

function frame_of(box: Box3, step: number, depth_step: number): Box3 {
  const down = (x: number, s: number): number => Math.floor(x / s - 1e-6) * s;
  const up = (x: number, s: number): number => Math.ceil(x / s + 1e-6) * s;
  return new Box3(
    new Vector3(down(box.min.x, step), down(box.min.y, depth_step), down(box.min.z, step)),
    new Vector3(up(box.max.x, step), up(box.max.y, depth_step), up(box.max.z, step)));
}

export function extent_of(scene: Scene, film: Film): Extent {
  const box = trails_box(scene, film);
  const reach = margin_of(scene);
  const deepest = box.min.y + reach;
  const highest = box.max.y - reach;
  for (const o of scene.obstacles) {
    if (o.kind === 'sphere' && o.radius < 4 * Math.hypot(box.max.x - box.min.x, box.max.z - box.min.z)) {
      box.expandByPoint(place_of(o.position, point).addScalar(o.radius)).expandByPoint(place_of(o.position, point).addScalar(-o.radius));
    }
  }
  const across = Math.max(box.max.x - box.min.x, box.max.z - box.min.z);
  const afloat = deepest > -0.5;
  const crests = scene.waves.reduce((sum, w) => sum + w.amplitude_m, 0);
  // Where vehicles start in the air, as in scenes without a sea, a surface would only confuse.
  const surface = highest < Math.max(1, 2 * crests);
  if (afloat) box.min.y = Math.min(box.min.y, -Math.max(0.05 * across, 1));
  if (surface) box.max.y = Math.min(box.max.y, Math.max(crests, 0.5));
  // The surface belongs to the scene unless it is far above it.
  if (surface && -highest < 0.6 * across) box.max.y = Math.max(box.max.y, Math.max(crests, 0.2));
  const step = round_up(across / 16);
  const depth_step = round_up(Math.max((box.max.y - box.min.y) / 6, across / 40));
  const size = box.getSize(new Vector3());
  const frame = frame_of(box, step, depth_step);
  const view = frame.clone();
  view.max.y = box.max.y;
  return {
    box, frame, view, step, depth_step, radius: size.length() / 2, surface, afloat,
    seconds: round_up(0.6 * Math.min(scene.exam.crit_dist_m, across / 3) / top_speed(film)),
  };
}
