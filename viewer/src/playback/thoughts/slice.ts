// SPDX-License-Identifier: Apache-2.0
// A plane through the space of velocities, and where what was drawn there meets it.
import type { Vec3 } from '../model';

export type Point = readonly [x: number, y: number];

/** Velocities x right + y up + fixed [m/s, NED]; `right` and `up` are unit vectors, `fixed` is square to both. */
export interface Slice {
  right: Vec3;
  up: Vec3;
  fixed: Vec3;
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** North up, east to the right, at this speed downwards. */
export function horizontal_slice(down: number): Slice {
  return { right: [0, 1, 0], up: [1, 0, 0], fixed: [0, 0, down] };
}

/** The course to the right, up is up, through this velocity. */
export function vertical_slice(course: number, through: Vec3): Slice {
  const right: Vec3 = [Math.cos(course), Math.sin(course), 0];
  const across: Vec3 = [-right[1], right[0], 0];
  const drift = dot(across, through);
  return { right, up: [0, 0, -1], fixed: [across[0] * drift, across[1] * drift, 0] };
}

/** Its place in the plane, seen along the plane's normal. */
export function projected({ right, up }: Slice, v: Vec3): Point {
  return [dot(v, right), dot(v, up)];
}

/** In the plane, points with normal . p >= offset are allowed; not normalised. */
export interface Cut {
  normal: Point;
  offset: number;
}

export function cut_half_space({ right, up, fixed }: Slice, point: Vec3, normal: Vec3): Cut {
  return { normal: [dot(normal, right), dot(normal, up)], offset: dot(normal, point) - dot(normal, fixed) };
}

/** What of the square [-reach, reach]^2 the cut forbids, and its edge inside the square, if it has one. */
export function forbidden_part({ normal, offset }: Cut, reach: number): { outline: Point[]; edge: Point[] } {
  const square: Point[] = [[-reach, -reach], [reach, -reach], [reach, reach], [-reach, reach]];
  const height = ([x, y]: Point): number => normal[0] * x + normal[1] * y - offset;
  const outline: Point[] = [];
  const edge: Point[] = [];
  square.forEach((from, k) => {
    const to = square[(k + 1) % square.length]!;
    const [a, b] = [height(from), height(to)];
    if (a < 0) outline.push(from);
    if (a < 0 === b < 0) return;
    const part = a / (a - b);
    const crossing: Point = [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
    outline.push(crossing);
    edge.push(crossing);
  });
  return { outline, edge };
}

/** A round reach [m/s] that holds so much: it stays the same from one decision to the next. */
export function round_reach(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const lead = value / power;
  return power * ([1, 1.5, 2, 3, 4, 6, 8].find((step) => lead <= step * 1.001) ?? 10);
}
