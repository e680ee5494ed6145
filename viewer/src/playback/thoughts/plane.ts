// SPDX-License-Identifier: Apache-2.0
// Draws a plane of velocities: rings of speed, what is forbidden, and the velocities themselves.
import { path_data, s } from '../../common/dom';
import { fixed } from '../../common/format';
import { tick_digits, ticks } from '../../common/scale';
import type { ImageStroke, Stroke, Vec3 } from '../model';
import { image_under } from './image';
import type { Look, Meanings } from './meanings';
import { cut_half_space, dot, forbidden_part, projected, type Point, type Slice } from './slice';

export interface PlaneOptions {
  slice: Slice;
  /** From the middle to the sides [m/s]. */
  reach: number;
  /** Of the square [px]. */
  size: number;
  /** What its top and its right side are called. */
  up: string;
  right: string;
  /** Regions are outlines in the horizontal plane alone. */
  regions: boolean;
  meanings: Meanings;
  /** Lies under everything else. */
  image: ImageStroke | null;
}
export interface Spot {
  x: number;
  y: number;
  meaning: string;
  velocity: Vec3;
}
export interface Plane {
  svg: SVGSVGElement;
  spots: Spot[];
}

const head_length = 9;
let clip_count = 0;

export function draw_plane(strokes: readonly Stroke[], options: PlaneOptions): Plane {
  const { slice, reach, size, meanings } = options;
  const place = ([x, y]: Point): Point => [((x / reach + 1) * size) / 2, ((1 - y / reach) * size) / 2];
  const clip = `plane-clip-${++clip_count}`;
  const spots: Spot[] = [];
  const areas = options.image === null ? [] : [image_under(options.image, size, reach)];
  const edges: SVGElement[] = [];
  const halos: SVGElement[] = [];
  const marks: SVGElement[] = [];
  for (const stroke of strokes) {
    const look = meanings.look(stroke.kind, stroke.meaning);
    if (stroke.kind === 'half_space') {
      const { outline, edge } = forbidden_part(cut_half_space(slice, ...stroke.points), reach);
      if (outline.length > 0) areas.push(s('path', { class: 'forbidden', colour: look.colour, d: closed(outline.map(place)) }));
      edges.push(s('path', { class: 'edge', colour: look.colour, d: path_data(edge.map(place)) }));
    } else if (stroke.kind === 'region' && options.regions) {
      areas.push(s('path', { class: 'region', colour: look.colour, d: closed(stroke.points.map((v) => place(projected(slice, v)))) }));
    } else if (stroke.kind === 'velocity') {
      const velocity = stroke.points[0];
      const [x, y] = place(projected(slice, velocity));
      spots.push({ x, y, meaning: meanings.words(stroke.meaning), velocity });
      for (const mark of velocity_marks(look, [size / 2, size / 2], [x, y])) (mark.classList.contains('halo') ? halos : marks).push(mark);
    }
  }
  const quarter = emptiest(spots, size / 2);
  const svg = s('svg', { class: 'chart plane', viewBox: `0 0 ${size} ${size}`, width: size, height: size, role: 'img' },
    s('defs', {}, s('clipPath', { id: clip }, s('rect', { width: size, height: size, rx: 4 }))),
    s('g', { 'clip-path': `url(#${clip})` }, ...areas, ...edges, ...rings(options, quarter), ...halos, ...marks),
    s('rect', { class: 'frame', x: 0.5, y: 0.5, width: size - 1, height: size - 1, rx: 4 }),
    ...names(options, quarter));
  svg.style.fontSize = '11px';
  return { svg, spots };
}

function closed(points: Point[]): string {
  return path_data(points) + 'Z';
}

/** The quarter of the plane on the far side of the velocities, as signs of x to the right and y downwards. */
function emptiest(spots: readonly Spot[], middle: number): Point {
  const [x, y] = spots.reduce(([sx, sy], spot) => [sx + spot.x - middle, sy + spot.y - middle], [0, 0]);
  return [x > 0 ? -1 : 1, y > 0 ? -1 : 1];
}

function rings({ reach, size }: PlaneOptions, quarter: Point): SVGElement[] {
  const middle = size / 2;
  const speeds = ticks(0, reach, size > 260 ? 4 : 2).filter((speed) => speed > 0);
  const digits = tick_digits(speeds.length > 1 ? speeds : [0, ...speeds]);
  return [
    s('path', { class: 'axis-cross', d: `M${middle} 0V${size}M0 ${middle}H${size}` }),
    ...speeds.flatMap((speed, k) => {
      const radius = (speed / reach) * middle;
      const label = fixed(speed, digits) + (k === speeds.length - 1 ? ' m/s' : '');
      const at = (side: number): number => middle + side * radius * Math.SQRT1_2;
      return [s('circle', { class: 'speed-ring', cx: middle, cy: middle, r: radius }),
        s('text', { class: 'ring-label', x: at(quarter[0]), y: at(quarter[1]) + 4, 'text-anchor': 'middle' }, label)];
    }),
  ];
}

function names({ size, up, right }: PlaneOptions, [x, y]: Point): SVGElement[] {
  return [
    s('text', { class: 'axis-name', x: size / 2 + 6 * x, y: 15, 'text-anchor': x > 0 ? 'start' : 'end' }, up),
    s('text', { class: 'axis-name', x: size - 7, y: size / 2 + (y > 0 ? 15 : -6), 'text-anchor': 'end' }, right),
  ];
}

function velocity_marks({ mark, colour, dash }: Look, from: Point, [x, y]: Point): SVGElement[] {
  switch (mark) {
    case 'dot': return [s('circle', { class: 'particle', colour, cx: x, cy: y, r: 2 })];
    case 'diamond': return [s('path', { class: 'ring', colour, d: `M${x} ${y - 7}L${x + 7} ${y}L${x} ${y + 7}L${x - 7} ${y}Z` })];
    case 'arrow': return arrow(colour, dash, from, [x, y]);
    default: return [
      s('line', { class: 'arrow thin', colour, x1: from[0], y1: from[1], x2: x, y2: y }),
      s('circle', { class: 'ring', colour, cx: x, cy: y, r: 4 })];
  }
}

function arrow(colour: string, dash: string, from: Point, to: Point): SVGElement[] {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  // No speed has no arrow.
  if (length < head_length) return [s('circle', { class: 'head', colour, cx: to[0], cy: to[1], r: 3.5 })];
  const [ux, uy] = [dx / length, dy / length];
  const [bx, by] = [to[0] - head_length * ux, to[1] - head_length * uy];
  const half = 0.42 * head_length;
  const head = closed([to, [bx - half * uy, by + half * ux], [bx + half * uy, by - half * ux]]);
  // Edged, to stand out from any image.
  return [
    s('path', { class: 'halo', d: path_data([from, [bx, by]]) + head }),
    s('line', { class: 'arrow', colour, x1: from[0], y1: from[1], x2: bx, y2: by, 'stroke-dasharray': dash || undefined }),
    s('path', { class: 'head', colour, d: head }),
  ];
}

/** Speed, course and descent of a velocity, in words. */
export function velocity_words(v: Vec3): { label: string; value: string }[] {
  const course = ((Math.atan2(v[1], v[0]) * 180) / Math.PI + 360) % 360;
  const rows = [{ label: 'speed', value: `${fixed(Math.sqrt(dot(v, v)), 3)} m/s` }, { label: 'course', value: `${fixed(course, 1)}°` }];
  if (Math.abs(v[2]) > 5e-4) rows.push({ label: v[2] > 0 ? 'down' : 'up', value: `${fixed(Math.abs(v[2]), 3)} m/s` });
  return rows;
}
