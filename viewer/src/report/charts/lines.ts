// SPDX-License-Identifier: Apache-2.0
// Curves over x, with a cross-hair that reads all of them at once.
import { path_data, s } from '../../common/dom';
import { finite, short } from '../../common/format';
import { linear, type Scale } from '../../common/scale';
import type { LinesBlock } from '../model';
import { canvas, draw_x_ticks } from './cartesian';
import { leads_to, pick_along_x, type Chart, type Drawing, type Palettes, type Target, type View } from './chart';

interface Curve {
  label: string;
  colour: string;
  dash: string;
  /** In the order of x; y is null where the curve has a gap. */
  points: { x: number; y: number | null }[];
}

/** A name that is a vehicle's elsewhere on the page has the vehicle's colour here too. */
function curves_of(block: LinesBlock, { series, vehicles }: Palettes): Curve[] {
  return block.series.map(({ label, x, y }) => {
    const palette = vehicles.has(label) ? vehicles : series;
    const points = x.flatMap((value, i) => value === null ? [] : [{ x: value, y: y[i] ?? null }]);
    return { label, colour: palette.colour(label), dash: palette.dash(label), points: points.sort((a, b) => a.x - b.x) };
  });
}

/** Per column of pixels the first, lowest, highest and last point: what the eye sees of a long curve. */
function thinned(points: Curve['points'], x: Scale, width: number): Curve['points'] {
  if (points.length < 4 * width) return points;
  const kept = new Set<number>();
  let column = NaN;
  let bucket: number[] = [];
  const flush = (): void => {
    const known = bucket.filter((i) => points[i]!.y !== null);
    const by = (a: number, b: number): number => points[a]!.y! - points[b]!.y!;
    const sorted = [...known].sort(by);
    for (const i of [bucket[0], bucket.at(-1), sorted[0], sorted.at(-1)]) if (i !== undefined) kept.add(i);
    const gap = bucket.find((i) => points[i]!.y === null);
    if (gap !== undefined) kept.add(gap);
    bucket = [];
  };
  points.forEach((point, i) => {
    const pixel = Math.floor(x(point.x));
    if (pixel !== column) flush();
    column = pixel;
    bucket.push(i);
  });
  flush();
  return [...kept].sort((a, b) => a - b).map((i) => points[i]!);
}

/** Position of the last point at or before x; -1 when x is before the first. */
function index_before(points: Curve['points'], x: number): number {
  let [low, high] = [-1, points.length - 1];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (points[middle]!.x <= x) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** The curve's point nearest in x, unless the curve has none near. */
function nearest(points: Curve['points'], x: number, reach: number): { x: number; y: number } | null {
  const before = index_before(points, x);
  let best: { x: number; y: number } | null = null;
  for (const point of [points[before], points[before + 1]]) {
    if (point === undefined || point.y === null || Math.abs(point.x - x) > reach) continue;
    if (best === null || Math.abs(point.x - x) < Math.abs(best.x - x)) best = { x: point.x, y: point.y };
  }
  return best;
}

function draw(block: LinesBlock, curves: Curve[], view: View): Drawing {
  const shown = curves.filter(({ label }) => !view.hidden.has(label));
  const on = canvas({
    view, y_label: block.y_label, y_max: null, rules: block.lines, x_label: block.x_label,
    values: curves.flatMap(({ points }) => points.map(({ y }) => y).filter(finite)),
    x_space: (_inner, font) => font + 10,
  });
  const { left, right, top, bottom } = on.area;
  const all_x = curves.flatMap(({ points }) => points.map((point) => point.x));
  const domain: [number, number] = all_x.length > 0
    ? [all_x.reduce((a, b) => Math.min(a, b)), all_x.reduce((a, b) => Math.max(a, b))] : [0, 1];
  const x = linear(domain[0] === domain[1] ? [domain[0] - 1, domain[1] + 1] : domain, [left + 4, right - 6]);

  draw_x_ticks(on, x, Math.max(2, Math.round((right - left) / 70)), view.width);
  for (const { points, colour, dash } of shown) {
    const path = thinned(points, x, right - left);
    on.marks.append(s('path', {
      colour, class: 'curve', 'stroke-dasharray': dash,
      d: path_data(path.map((point) => point.y === null ? null : [x(point.x), on.y(point.y)] as const)),
    }));
    const single = path.length === 1 ? path[0] : undefined;
    if (single !== undefined && single.y !== null) {
      on.marks.append(s('circle', { colour, class: 'dot', cx: x(single.x), cy: on.y(single.y), r: 3 }));
    }
  }

  // At most one target per two pixels, each at an x where some curve has a point.
  const at = new Map<number, number>();
  for (const { points } of shown) for (const point of points) at.set(Math.round(x(point.x) / 2), point.x);
  const reach = (domain[1] - domain[0]) / 40;
  const targets: Target[] = [...at.values()].sort((a, b) => a - b).map((value) => {
    const readings = (): { curve: Curve; point: { x: number; y: number } }[] => shown.flatMap((curve) => {
      const point = nearest(curve.points, value, reach);
      return point === null ? [] : [{ curve, point }];
    });
    return {
      x: x(value), y: (top + bottom) / 2,
      runs: leads_to(block.made, block.title),
      tip: () => ({
        title: `${block.x_label || 'x'}: ${short(value)}`,
        rows: readings().sort((a, b) => b.point.y - a.point.y)
          .map(({ curve, point }) => ({ label: curve.label, value: short(point.y), colour: curve.colour })),
      }),
      cursor: () => [
        s('line', { class: 'crosshair', x1: x(value), x2: x(value), y1: top, y2: bottom }),
        ...readings().map(({ curve, point }) =>
          s('circle', { colour: curve.colour, class: 'dot', cx: x(point.x), cy: on.y(point.y), r: 3.5 })),
      ],
    };
  });
  return { svg: on.svg, targets, pick: pick_along_x(targets, 40) };
}

export function lines_chart(block: LinesBlock, palettes: Palettes): Chart {
  const curves = curves_of(block, palettes);
  const ranges = curves.map(({ label, points }) => {
    const values = points.map(({ y }) => y).filter(finite);
    if (values.length === 0) return `${label}: no data`;
    const [low, high] = [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
    return `${label}: from ${short(low)} to ${short(high)}`;
  });
  return {
    legend: [
      ...curves.map(({ label, colour, dash }) => ({ label, glyph: 'line' as const, colour, dash, toggles: true })),
      ...block.lines.map(({ label }) => ({ label, glyph: 'rule' as const, toggles: false })),
    ],
    summary: `Lines of ${block.y_label || 'y'} over ${block.x_label || 'x'}. ${ranges.join('; ')}.`,
    data: () => ({
      kind: 'table', title: block.title, note: '', filter: [],
      columns: [
        { key: 'series', label: 'series', unit: '', type: 'text', digits: null },
        { key: 'x', label: block.x_label || 'x', unit: '', type: 'number', digits: null },
        { key: 'y', label: block.y_label || 'y', unit: '', type: 'number', digits: null },
      ],
      rows: curves.flatMap(({ label, points }) => points.map(({ x, y }) => ({ series: label, x, y }))),
    }),
    draw: (view) => draw(block, curves, view),
    made: block.made,
  };
}
