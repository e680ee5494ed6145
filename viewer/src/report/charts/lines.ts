// SPDX-License-Identifier: Apache-2.0
// Curves over x, with a cross-hair that reads all of them at once.
import { shape_path, type Shape } from '../../common/colour';
import { path_data, s } from '../../common/dom';
import { finite, short } from '../../common/format';
import { linear } from '../../common/scale';
import type { LinesBlock } from '../model';
import { canvas, dot, draw_x_ticks, extent } from './cartesian';
import { leads_to, numbers_table, palette_of, pick_along_x, type Chart, type Drawing, type Palettes, type Target, type View } from './chart';

interface Curve {
  label: string;
  colour: string;
  dash: string;
  shape: Shape;
  /** One point, drawn as a mark of its own shape. */
  single: boolean;
  on_front: boolean;
  /** In the order of x; y is null where the curve has a gap. */
  points: { x: number; y: number | null }[];
}

function curves_of(block: LinesBlock, palettes: Palettes): Curve[] {
  return block.series.map(({ label, x, y }) => {
    const palette = palette_of(label, palettes);
    const points = x.flatMap((value, i) => value === null ? [] : [{ x: value, y: y[i] ?? null }]);
    return {
      label, colour: palette.colour(label), dash: palette.dash(label), shape: palette.shape(label), single: points.length === 1,
      on_front: block.front.includes(label), points: points.sort((a, b) => a.x - b.x),
    };
  });
}

/** The curve's point nearest in x, unless the curve has none near. */
function nearest({ points }: Curve, x: number, reach: number): { x: number; y: number } | null {
  let best: { x: number; y: number } | null = null;
  for (const { x: at, y } of points) {
    const away = Math.abs(at - x);
    if (y !== null && away <= reach && (best === null || away < Math.abs(best.x - x))) best = { x: at, y };
  }
  return best;
}

/** The border of what somebody on the front is better than, as steps, and a ring about everybody on it. */
function front_marks(curves: Curve[], at: (point: { x: number; y: number }) => [number, number]): SVGElement[] {
  const points = curves.filter(({ on_front }) => on_front)
    .flatMap(({ points: [first] }) => first !== undefined && first.y !== null ? [at({ x: first.x, y: first.y })] : [])
    .sort(([a_x, a_y], [b_x, b_y]) => a_x - b_x || b_y - a_y);
  const steps = points.flatMap(([x, y], i): [number, number][] => i === 0 ? [[x, y]] : [[x, points[i - 1]![1]], [x, y]]);
  return [
    s('path', { class: 'front', d: path_data(steps) }),
    ...points.map(([cx, cy]) => s('circle', { class: 'front-ring', cx, cy, r: 8 })),
  ];
}

function draw(block: LinesBlock, curves: Curve[], view: View): Drawing {
  const shown = curves.filter(({ label }) => !view.hidden.has(label));
  const on = canvas({
    view, y_label: block.y_label, y_max: null, rules: block.lines, x_label: block.x_label,
    values: curves.flatMap(({ points }) => points.map(({ y }) => y).filter(finite)),
    x_space: (_inner, font) => font + 10,
  });
  const { left, right, top, bottom } = on.area;
  const domain = extent(curves.flatMap(({ points }) => points.map((point) => point.x))) ?? [0, 1];
  const x = linear(domain[0] === domain[1] ? [domain[0] - 1, domain[1] + 1] : domain, [left + 4, right - 6]);

  draw_x_ticks(on, x, Math.max(2, Math.round((right - left) / 70)), view.width);
  on.marks.append(...front_marks(shown, (point) => [x(point.x), on.y(point.y)]));
  // Whoever is on the front lies above the others.
  for (const { points, colour, dash, shape, single } of [...shown].sort((a, b) => Number(a.on_front) - Number(b.on_front))) {
    if (single) {
      const [{ x: at, y }] = points as [Curve['points'][number]];
      if (y === null) continue;
      on.marks.append(s('path', {
        colour, class: 'point', d: shape_path(shape, 4.5), transform: `translate(${x(at).toFixed(1)} ${on.y(y).toFixed(1)})`,
      }));
      continue;
    }
    on.marks.append(s('path', {
      colour, class: 'curve', 'stroke-dasharray': dash,
      d: path_data(points.map((point) => point.y === null ? null : [x(point.x), on.y(point.y)] as const)),
    }));
  }

  // At most one target per two pixels, each at an x where some curve has a point.
  const at = new Map<number, number>();
  for (const { points } of shown) for (const point of points) at.set(Math.round(x(point.x) / 2), point.x);
  const reach = (domain[1] - domain[0]) / 40;
  const targets: Target[] = [...at.values()].sort((a, b) => a - b).map((value) => {
    const readings = (): { curve: Curve; point: { x: number; y: number } }[] => shown.flatMap((curve) => {
      const point = nearest(curve, value, reach);
      return point === null ? [] : [{ curve, point }];
    });
    return {
      x: x(value), y: (top + bottom) / 2,
      runs: leads_to(block.made, block.title),
      tip: () => ({
        title: `${block.x_label || 'x'}: ${short(value)}`,
        rows: readings().sort((a, b) => b.point.y - a.point.y)
          .map(({ curve, point }) => ({ label: curve.label + (curve.on_front ? ', on the front' : ''), value: short(point.y), colour: curve.colour })),
      }),
      cursor: () => [
        s('line', { class: 'crosshair', x1: x(value), x2: x(value), y1: top, y2: bottom }),
        ...readings().map(({ curve, point }) => dot(curve.colour, x(point.x), on.y(point.y))),
      ],
    };
  });
  return { svg: on.svg, targets, pick: pick_along_x(targets, 40) };
}

export function lines_chart(block: LinesBlock, palettes: Palettes): Chart {
  const curves = curves_of(block, palettes);
  const ranges = curves.map(({ label, points }) => {
    const ends = extent(points.map(({ y }) => y).filter(finite));
    return ends === null ? `${label}: no data` : `${label}: from ${short(ends[0])} to ${short(ends[1])}`;
  });
  return {
    legend: [
      ...curves.map(({ label, colour, dash, shape, single }) =>
        ({ label, glyph: single ? 'point' as const : 'line' as const, colour, dash, shape, toggles: true })),
      ...(curves.some(({ on_front }) => on_front) ? [{ label: 'on the front', glyph: 'front' as const, toggles: false }] : []),
      ...block.lines.map(({ label }) => ({ label, glyph: 'rule' as const, toggles: false })),
    ],
    summary: `Lines of ${block.y_label || 'y'} over ${block.x_label || 'x'}. ${ranges.join('; ')}.`,
    data: () => numbers_table(block.title, [['series', 'series', 'text'], ['x', block.x_label || 'x'], ['y', block.y_label || 'y']],
      curves.flatMap(({ label, points }) => points.map(({ x, y }) => ({ series: label, x, y })))),
    draw: (view) => draw(block, curves, view),
    made: block.made,
  };
}
