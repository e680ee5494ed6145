// SPDX-License-Identifier: Apache-2.0
// Orthographic views of a box in north, east, down; on the screen x grows to the right and y downwards.
import type { Point } from '../model';

export interface Camera {
  /** Compass heading the camera looks along, and its elevation above the horizon, in degrees. */
  heading: number;
  elevation: number;
}

export interface Rect {
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface Bounds {
  low: Point;
  high: Point;
}

export type Screen = readonly [x: number, y: number];

export interface Projection {
  (point: Point): Screen;
  /** Larger for what is nearer to the viewer. */
  depth(point: Point): number;
  /** Pixels per metre. */
  scale: number;
}

/** Right, up and towards the viewer as vectors in north, east, down. */
function axes({ heading, elevation }: Camera): [Point, Point, Point] {
  const [a, b] = [(heading * Math.PI) / 180, (elevation * Math.PI) / 180];
  const [n, e] = [Math.cos(a), Math.sin(a)];
  return [
    [-e, n, 0],
    [Math.sin(b) * n, Math.sin(b) * e, -Math.cos(b)],
    [-Math.cos(b) * n, -Math.cos(b) * e, -Math.sin(b)],
  ];
}

const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export function corners({ low, high }: Bounds): Point[] {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((i) =>
    [i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]] as const);
}

/** The projection that fits the box into the rectangle; `turnable` keeps its scale for every heading. */
export function project(bounds: Bounds, camera: Camera, into: Rect, turnable: boolean): Projection {
  const [right, up, towards] = axes(camera);
  const { low, high } = bounds;
  const centre: Point = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
  const half: Point = [(high[0] - low[0]) / 2, (high[1] - low[1]) / 2, (high[2] - low[2]) / 2];
  const reach = (axis: Point): number => half.reduce((sum, size, i) => sum + size * Math.abs(axis[i]!), 0);
  const [flat, tilt] = [Math.hypot(half[0], half[1]), (camera.elevation * Math.PI) / 180];
  const across = turnable ? flat : reach(right);
  const tall = turnable ? flat * Math.abs(Math.sin(tilt)) + half[2] * Math.cos(tilt) : reach(up);
  const scale = Math.min(into.width / (2 * across || 1), into.height / (2 * tall || 1));
  const [x, y] = [into.x + into.width / 2, into.y + into.height / 2];
  const from_centre = (p: Point): Point => [p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]];
  const projection = (p: Point): Screen =>
    [x + scale * dot(from_centre(p), right), y - scale * dot(from_centre(p), up)];
  return Object.assign(projection, { depth: (p: Point) => dot(from_centre(p), towards), scale });
}

/** Height over width of the box as it is seen, over all headings; for the shape of a drawing. */
export function outline_ratio({ low, high }: Bounds, elevation: number): number {
  const flat = Math.hypot(high[0] - low[0], high[1] - low[1]);
  const tilt = (elevation * Math.PI) / 180;
  return Math.sin(tilt) + (Math.cos(tilt) * (high[2] - low[2])) / (flat || 1);
}

/** For each axis, whether the box's face at its high end is the one behind the data. */
export function back_faces(camera: Camera): [boolean, boolean, boolean] {
  const [, , towards] = axes(camera);
  return [towards[0] < -1e-9, towards[1] < -1e-9, towards[2] < 1e-9];
}

/** The edge of the box along `axis` where its labels stand clear of the data: on the outline, lowest or leftmost. */
export function label_edge(bounds: Bounds, camera: Camera, view: Projection, axis: 0 | 1 | 2): [Point, Point] {
  const back = back_faces(camera);
  const others = ([0, 1, 2] as const).filter((i) => i !== axis);
  const [p, q] = [others[0]!, others[1]!];
  let best: [Point, Point] | null = null;
  let best_score = -Infinity;
  for (const [high_p, high_q] of [[false, false], [false, true], [true, false], [true, true]] as const) {
    // On the outline exactly one of the two faces that meet in the edge is behind.
    if ((back[p] === high_p) === (back[q] === high_q)) continue;
    const from = [...bounds.low] as [number, number, number];
    const to = [...bounds.low] as [number, number, number];
    from[p] = to[p] = high_p ? bounds.high[p] : bounds.low[p];
    from[q] = to[q] = high_q ? bounds.high[q] : bounds.low[q];
    to[axis] = bounds.high[axis];
    const [a, b] = [view(from), view(to)];
    const upright = Math.abs(a[1] - b[1]) > Math.abs(a[0] - b[0]);
    const score = (axis === 2 || upright ? [-1, 0.01] : [-0.01, 1]).reduce((sum, w, i) => sum + w * (a[i]! + b[i]!), 0);
    if (score > best_score) [best, best_score] = [[from, to], score];
  }
  return best ?? [bounds.low, bounds.high];
}
