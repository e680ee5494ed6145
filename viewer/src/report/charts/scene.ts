// SPDX-License-Identifier: Apache-2.0
// One view of the trajectories inside a rectangle: box, grid, spheres, goals, tracks, positions.
import type { Palette } from '../../common/colour';
import { path_data, s } from '../../common/dom';
import { fixed } from '../../common/format';
import { tick_digits, ticks } from '../../common/scale';
import type { Point, TrajectoriesBlock } from '../model';
import { back_faces, label_edge, project, type Bounds, type Camera, type Projection, type Rect, type Screen } from './projection';

export interface Track {
  label: string;
  colour: string;
  dash: string;
  points: Point[];
  times: number[];
}

export interface Scene {
  block: TrajectoriesBlock;
  bounds: Bounds;
  tracks: Track[];
  goal_colours: string[];
  /** Up to when the tracks are drawn bold. */
  time: number;
}

export interface SceneView {
  camera: Camera;
  rect: Rect;
  turnable: boolean;
  font: number;
}

const axis_names = ['N', 'E', 'D'];

/** Position at a time, between the samples; the ends hold. */
export function position_at(track: Track, time: number): Point {
  const { points, times } = track;
  let i = 0;
  while (i < times.length - 1 && times[i + 1]! <= time) ++i;
  const [a, b] = [points[i]!, points[i + 1]];
  if (b === undefined || times[i] === undefined || times[i + 1] === undefined) return a;
  const part = Math.max(0, Math.min(1, (time - times[i]!) / (times[i + 1]! - times[i]! || 1)));
  return [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])];
}

function with_axis(point: Point, axis: number, value: number): Point {
  const copy = [...point] as [number, number, number];
  copy[axis] = value;
  return copy;
}

/** Grid lines on the three faces behind the data, and labelled ticks on the outline. */
function draw_box({ bounds }: Scene, { camera, font }: SceneView, view: Projection): SVGElement[] {
  const back = back_faces(camera);
  const marks: SVGElement[] = [];
  const centre = view([0, 1, 2].map((i) => (bounds.low[i]! + bounds.high[i]!) / 2) as unknown as Point);
  const labels: SVGElement[] = [];

  ([0, 1, 2] as const).forEach((axis) => {
    const [from, to] = label_edge(bounds, camera, view, axis);
    const [a, b] = [view(from), view(to)];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const values = ticks(bounds.low[axis], bounds.high[axis], Math.max(2, Math.min(8, Math.round(length / 48))));
    // Lines at the ticks of this axis, on the two back faces that contain it.
    for (const face of ([0, 1, 2] as const).filter((i) => i !== axis)) {
      const across = 3 - axis - face;
      const on_face = with_axis(bounds.low, face, back[face] ? bounds.high[face] : bounds.low[face]);
      const ends = (value: number): [Screen, Screen] => [
        view(with_axis(with_axis(on_face, axis, value), across, bounds.low[across]!)),
        view(with_axis(with_axis(on_face, axis, value), across, bounds.high[across]!)),
      ];
      const grid = values.map(ends).flatMap(([p, q]) => [p, q, null]);
      const edges = [bounds.low[axis], bounds.high[axis]].map(ends).flatMap(([p, q]) => [p, q, null]);
      marks.push(s('path', { class: 'grid', d: path_data(grid) }), s('path', { class: 'face', d: path_data(edges) }));
    }
    if (length < 28) return;
    const middle: Screen = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    // Outwards, square to the edge.
    let out: Screen = [(b[1] - a[1]) / length, -(b[0] - a[0]) / length];
    if (out[0] * (middle[0] - centre[0]) + out[1] * (middle[1] - centre[1]) < 0) out = [-out[0], -out[1]];
    const anchor = out[0] < -0.5 ? 'end' : out[0] > 0.5 ? 'start' : 'middle';
    const place = (at: Screen, distance: number, text: string, kind: string): void => {
      labels.push(s('text', {
        class: kind, x: at[0] + out[0] * distance, y: at[1] + out[1] * distance, dy: '0.34em', 'text-anchor': anchor,
      }, text));
    };
    const digits = tick_digits(values);
    for (const value of values) place(view(with_axis(from, axis, value)), font * 0.9, fixed(value, digits), 'tick');
    place(middle, anchor === 'middle' ? font * 2.3 : font * 3.2, `${axis_names[axis]} [m]`, 'axis-label');
  });
  return [...marks, ...labels];
}

function draw_spheres({ block }: Scene, view: Projection): SVGElement[] {
  return [...block.spheres].sort((a, b) => view.depth(a.centre) - view.depth(b.centre)).map((sphere) => {
    const [cx, cy] = view(sphere.centre);
    const group = s('g', { class: 'sphere' }, s('circle', { cx, cy, r: Math.max(1.5, sphere.radius * view.scale) }));
    if (sphere.label !== '') group.append(s('title', {}, sphere.label));
    return group;
  });
}

function draw_track(track: Track, scene: Scene, view: Projection, floor: number | null): SVGElement[] {
  const { colour, dash, points, times } = track;
  if (points.length === 0) return [];
  const now = position_at(track, scene.time);
  const split = times.length === 0 ? points.length : times.filter((time) => time <= scene.time).length;
  const past = [...points.slice(0, split), now].map(view);
  const [start, here] = [view(points[0]!), view(now)];
  const marks: SVGElement[] = [
    s('path', { colour, class: 'track ahead', d: path_data(points.map(view)) }),
    s('path', { colour, class: 'track', 'stroke-dasharray': dash, d: path_data(past) }),
    s('circle', { colour, class: 'start', cx: start[0], cy: start[1], r: 2.6 }),
  ];
  if (floor !== null) {
    const below = view([now[0], now[1], floor]);
    marks.push(s('path', { colour, class: 'plumb', d: path_data([here, below]) }),
      s('circle', { colour, class: 'shadow', cx: below[0], cy: below[1], r: 2 }));
  }
  marks.push(s('circle', { colour, class: 'vehicle', cx: here[0], cy: here[1], r: 4.2 }));
  return marks;
}

/** Draws the scene; the returned projection tells where its points are. */
export function draw_scene(scene: Scene, place: SceneView): { marks: SVGElement[]; view: Projection } {
  const { rect, font, camera } = place;
  const room = { left: font * 6.2, right: font * 2.6, top: font * 1.4, bottom: font * 3.4 };
  const inner = {
    x: rect.x + room.left, y: rect.y + room.top,
    width: Math.max(20, rect.width - room.left - room.right), height: Math.max(20, rect.height - room.top - room.bottom),
  };
  const view = project(scene.bounds, camera, inner, place.turnable);
  const goals = scene.block.goals.map((goal, i) => {
    const [x, y] = view(goal);
    return s('path', {
      colour: scene.goal_colours[i] ?? 'var(--ink)', class: 'goal',
      d: `M${(x - 4).toFixed(1)} ${(y - 4).toFixed(1)}l8 8m0 -8l-8 8`,
    });
  });
  const tilted = place.turnable && camera.elevation < 75 && camera.elevation > 5;
  const near_last = [...scene.tracks].sort((a, b) =>
    view.depth(position_at(a, scene.time)) - view.depth(position_at(b, scene.time)));
  return {
    view,
    marks: [
      s('g', {}, ...draw_box(scene, place, view)),
      s('g', { class: 'marks' }, ...draw_spheres(scene, view), ...goals,
        ...near_last.flatMap((track) => draw_track(track, scene, view, tilted ? scene.bounds.high[2] : null))),
    ],
  };
}

/** A palette's colour for each goal where goals and vehicles come in pairs. */
export function goal_colours(block: TrajectoriesBlock, palette: Palette): string[] {
  return block.goals.length === block.vehicles.length
    ? block.vehicles.map(({ label }) => palette.colour(label)) : block.goals.map(() => 'var(--ink)');
}
