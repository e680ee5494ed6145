// SPDX-License-Identifier: Apache-2.0
// Where the vehicles went, from above or from the south, both axes at one scale. The playback of a run shows more of it.
import { path_data, s } from '../../common/dom';
import { fixed, short } from '../../common/format';
import type { Made, Point, TrajectoriesBlock } from '../model';
import { dot, extent } from './cartesian';
import { leads_to, numbers_table, type Chart, type Drawing, type Palettes, type Target, type View } from './chart';
import { plane, type Plane } from './plane';

/** What is to the right and what is upwards; the depth grows downwards. */
const sides = {
  above: { x_label: 'east [m]', y_label: 'north [m]', of: ([n, e]: Point): [number, number] => [e, n] },
  south: { x_label: 'east [m]', y_label: 'height [m]', of: ([, e, d]: Point): [number, number] => [e, -d] },
};

type Track = TrajectoriesBlock['vehicles'][number];

function points_of({ n, e, d }: Track): Point[] {
  return n.map((north, i) => [north, e[i]!, d[i]!]);
}

/** Whether all of it lies at one depth. */
export function is_flat({ vehicles }: TrajectoriesBlock): boolean {
  const [low, high] = extent(vehicles.flatMap(({ d }) => d)) ?? [0, 0];
  return high - low < 0.05;
}

function plane_of(block: TrajectoriesBlock, view: View): Plane {
  const { of, ...labels } = sides[block.side];
  const points = [...block.vehicles.flatMap(points_of), ...block.goals].map(of);
  const held = [0, 1].map((axis) => extent([
    ...points.map((point) => point[axis]!),
    ...block.spheres.flatMap(({ centre, radius }) => [of(centre)[axis]! - radius, of(centre)[axis]! + radius]),
  ]) ?? [0, 0]);
  const margin = Math.max(0.5, 0.04 * Math.max(...held.map(([low, high]) => high! - low!)));
  const [x, y] = held.map(([low, high]) => [low! - margin, high! + margin] as const);
  return plane({ view, x: x!, y: y!, ...labels, ratio: (y![1] - y![0]) / (x![1] - x![0]) });
}

function draw(block: TrajectoriesBlock, { vehicles: palette }: Palettes, view: View): Drawing {
  const on = plane_of(block, view);
  const at = (point: Point): [number, number] => {
    const [x, y] = sides[block.side].of(point);
    return [on.x(x), on.y(y)];
  };
  const scale = (on.area.right - on.area.left) / (on.x.domain[1] - on.x.domain[0]);
  for (const { centre, radius, label } of block.spheres) {
    const [cx, cy] = at(centre);
    on.marks.append(s('g', { class: 'sphere' }, s('circle', { cx, cy, r: Math.max(1.5, radius * scale) }), s('title', {}, label)));
  }
  const paired = block.goals.length === block.vehicles.length;
  block.goals.forEach((goal, i) => {
    const [x, y] = at(goal);
    const colour = paired ? palette.colour(block.vehicles[i]!.label) : 'var(--ink)';
    on.marks.append(s('path', { class: 'goal', colour, d: `M${(x - 4).toFixed(1)} ${(y - 4).toFixed(1)}l8 8m0 -8l-8 8` }));
  });
  const targets: Target[] = [];
  for (const track of block.vehicles.filter(({ label }) => !view.hidden.has(label))) {
    const [colour, dash] = [palette.colour(track.label), palette.dash(track.label)];
    const points = points_of(track).map(at);
    const [start, end] = [points[0], points.at(-1)];
    if (start === undefined || end === undefined) continue;
    on.marks.append(s('path', { colour, class: 'curve', 'stroke-dasharray': dash, d: path_data(points) }),
      s('circle', { colour, class: 'start', cx: start[0], cy: start[1], r: 2.6 }), dot(colour, end[0], end[1]));
    points.forEach(([x, y], i) => targets.push({
      x, y, tip: () => tip(track, i, colour), cursor: () => [dot(colour, x, y)],
      runs: leads_to(track.made ?? block.made, block.title, track.label),
    }));
  }
  const away = (target: Target, x: number, y: number): number => Math.hypot(target.x - x, target.y - y);
  return {
    svg: on.svg, targets,
    pick: (x, y) => targets.reduce<Target | null>((best, target) =>
      away(target, x, y) < (best === null ? 16 : away(best, x, y)) ? target : best, null),
  };
}

function tip({ label, n, e, d, t }: Track, i: number, colour: string) {
  return {
    title: label,
    rows: [
      ...(t[i] === undefined ? [] : [{ label: 'time', value: `${short(t[i])} s`, colour }]),
      { label: 'north, east, down', value: `${fixed(n[i]!, 2)}, ${fixed(e[i]!, 2)}, ${fixed(d[i]!, 2)} m` },
    ],
  };
}

/** The runs behind the figure, each once. */
function all_made({ made, vehicles }: TrajectoriesBlock): Made | null {
  const runs = [...new Set([made, ...vehicles.map((track) => track.made)].flatMap((each) => each?.runs ?? []))];
  return runs.length === 0 ? null : { runs, values: [], values_label: '' };
}

export function trajectories_chart(block: TrajectoriesBlock, palettes: Palettes): Chart {
  const { vehicles, goals, spheres } = block;
  const palette = palettes.vehicles;
  const times = extent(vehicles.flatMap(({ t }) => t));
  const named = [...new Set(spheres.map(({ label }) => label).filter((label) => label !== ''))];
  return {
    legend: [
      ...vehicles.map(({ label }) =>
        ({ label, glyph: 'line' as const, colour: palette.colour(label), dash: palette.dash(label), toggles: true })),
      ...(goals.length > 0 ? [{ label: 'goal', glyph: 'goal' as const, toggles: false }] : []),
      ...named.slice(0, 3).map((label) => ({ label, glyph: 'sphere' as const, toggles: false })),
    ],
    summary: `The ways of ${vehicles.length} vehicles from ${block.side === 'above' ? 'above' : 'the south'}` +
      (times === null ? '.' : ` over ${short(times[1] - times[0])} seconds.`),
    data: () => numbers_table(block.title,
      [['vehicle', 'vehicle', 'text'], ['t', 't', 'number', 's'], ...['n', 'e', 'd'].map((key) => [key, key, 'number', 'm'] as const)],
      vehicles.flatMap(({ label, n, e, d, t }) => n.map((_, i) => ({ vehicle: label, t: t[i] ?? null, n: n[i]!, e: e[i]!, d: d[i]! })))),
    draw: (view) => draw(block, palettes, view),
    made: all_made(block),
  };
}
