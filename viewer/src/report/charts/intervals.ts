// SPDX-License-Identifier: Apache-2.0
// Measured values with their intervals, and the published value beside each.
import { shape_path } from '../../common/colour';
import { s } from '../../common/dom';
import { short } from '../../common/format';
import { bands } from '../../common/scale';
import type { Column, IntervalPoint, IntervalsBlock } from '../model';
import { canvas, category_layout, draw_bands, draw_categories } from './cartesian';
import { leads_to, pick_along_x, type Chart, type Drawing, type Palettes, type Target, type View } from './chart';

function draw(block: IntervalsBlock, { series: palette }: Palettes, view: View): Drawing {
  const shown = block.series.filter(({ label }) => !view.hidden.has(label));
  const all = block.series.flatMap((series) => series.points.filter((point) => point !== null));
  const on = canvas({
    view, y_label: block.y_label, y_max: block.y_max, rules: block.lines, x_label: block.category_label,
    values: all.flatMap((point) => [point.low, point.high, point.value, ...(point.published === null ? [] : [point.published])]),
    x_space: (inner, font) => category_layout(block.categories, inner, font).space,
  });
  const { left, right, top, bottom } = on.area;
  const layout = bands(block.categories.length, shown.length, left, right, block.series.length > 1 ? 0.2 : 0.4);
  if (block.series.length > 1) draw_bands(on, block.categories.length, layout.width);
  draw_categories(on, block.categories, layout.centre);
  const half = Math.max(1.5, Math.min(layout.slot * 0.22, 6));
  const size = Math.max(2.2, Math.min(layout.slot * 0.24, 5));
  const at = (value: number): number => Math.max(top, on.y(value));

  const targets: Target[] = [];
  block.categories.forEach((category, c) => shown.forEach(({ label, points }, part) => {
    const point = points[c] ?? null;
    if (point === null) return;
    const colour = palette.colour(label);
    // The published value stands a little to the left, so that neither hides the other.
    const aside = point.published === null ? 0 : Math.min(layout.slot * 0.18, 7);
    const centre = layout.slot_centre(c, part);
    const x = centre + aside;
    const [low, high, y] = [at(point.low), at(point.high), at(point.value)];
    const group = s('g', { colour });
    if (point.published !== null) {
      const from = centre - aside * 1.4;
      group.append(
        s('line', { class: 'gap', x1: from, y1: at(point.published), x2: x, y2: y }),
        s('path', {
          class: 'published', d: shape_path('diamond', size),
          transform: `translate(${from.toFixed(1)} ${at(point.published).toFixed(1)})`,
        }));
    }
    group.append(
      s('path', {
        class: 'interval',
        d: `M${x.toFixed(1)} ${low.toFixed(1)}V${high.toFixed(1)}` +
          `M${(x - half).toFixed(1)} ${low.toFixed(1)}h${(2 * half).toFixed(1)}` +
          `M${(x - half).toFixed(1)} ${high.toFixed(1)}h${(2 * half).toFixed(1)}`,
      }),
      s('path', {
        class: 'point', d: shape_path(palette.shape(label), size),
        transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})`,
      }));
    on.marks.append(group);
    targets.push({
      x: centre, y,
      tip: () => ({ title: `${label}, ${category}`, rows: tip_rows(point, colour) }),
      runs: leads_to(point.made, block.title, label, category),
      cursor: () => [s('rect', {
        class: 'slot', x: centre - layout.slot / 2, y: top, width: layout.slot, height: bottom - top, rx: 3,
      })],
    });
  }));
  return { svg: on.svg, targets, pick: pick_along_x(targets, layout.slot / 2 + 1) };
}

function tip_rows(point: IntervalPoint, colour: string) {
  const rows = [
    { label: 'measured', value: short(point.value), colour },
    { label: 'interval', value: `${short(point.low)} – ${short(point.high)}` },
  ];
  if (point.published !== null) rows.push({ label: 'published', value: short(point.published), colour: 'var(--ink)' });
  return rows;
}

export function intervals_chart(block: IntervalsBlock, palettes: Palettes): Chart {
  const palette = palettes.series;
  const any_published = block.series.some(({ points }) => points.some((point) => point?.published != null));
  const covered = block.series.flatMap(({ points }) => points).filter((point) => point?.published != null);
  const inside = covered.filter((point) => point!.low <= point!.published! && point!.published! <= point!.high);
  const coverage = any_published
    ? ` The published value lies inside the interval in ${inside.length} of ${covered.length} cases.` : '';
  const column = (key: string, label: string, type: Column['type']): Column =>
    ({ key, label, unit: '', type, digits: null });
  return {
    legend: [
      ...block.series.map(({ label }) => ({
        label, glyph: 'point' as const, colour: palette.colour(label), shape: palette.shape(label), toggles: true,
      })),
      ...(any_published ? [{ label: 'published', glyph: 'published' as const, toggles: false }] : []),
      ...block.lines.map(({ label }) => ({ label, glyph: 'rule' as const, toggles: false })),
    ],
    summary: `Values of ${block.y_label || 'the measure'} with intervals, ${block.categories.length} categories, ` +
      `${block.series.map(({ label }) => label).join(', ')}.${coverage}`,
    data: () => ({
      kind: 'table', title: block.title, note: '', filter: [],
      columns: [
        column('category', block.category_label || 'category', 'text'), column('series', 'series', 'text'),
        ...['value', 'low', 'high', 'published'].map((key) => column(key, key, 'number')),
      ],
      rows: block.series.flatMap(({ label, points }) => points.flatMap((point, i) =>
        point === null ? [] : [{
          category: block.categories[i]!, series: label, value: point.value, low: point.low, high: point.high,
          published: point.published,
        }])),
    }),
    draw: (view) => draw(block, palettes, view),
  };
}
