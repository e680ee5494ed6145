// SPDX-License-Identifier: Apache-2.0
// Measured values with their intervals, and the published value beside each.
import { shape_path, type Palette } from '../../common/colour';
import { path_data, s } from '../../common/dom';
import { short } from '../../common/format';
import type { IntervalPoint, IntervalsBlock } from '../model';
import { category_chart, type Slot } from './categories';
import type { Chart, Palettes } from './chart';

function point_marks({ value, low, high, published }: IntervalPoint, { x: centre, y, width, label }: Slot, palette: Palette): SVGElement[] {
  const half = Math.max(1.5, Math.min(width * 0.22, 6));
  const size = Math.max(2.2, Math.min(width * 0.24, 5));
  // The published value stands a little to the left, so that neither hides the other.
  const aside = published === null ? 0 : Math.min(width * 0.18, 7);
  const [x, from] = [centre + aside, centre - aside * 1.4];
  const across = (at: number): [number, number][] => [[x - half, y(at)], [x + half, y(at)]];
  const at = (left: number, of: number): string => `translate(${left.toFixed(1)} ${y(of).toFixed(1)})`;
  return [
    ...(published === null ? [] : [
      s('line', { class: 'gap', x1: from, y1: y(published), x2: x, y2: y(value) }),
      s('path', { class: 'published', d: shape_path('diamond', size), transform: at(from, published) })]),
    s('path', { class: 'interval', d: path_data([[x, y(low)], [x, y(high)], null, ...across(low), null, ...across(high)]) }),
    s('path', { class: 'point', d: shape_path(palette.shape(label), size), transform: at(x, value) }),
  ];
}

export function intervals_chart(block: IntervalsBlock, palettes: Palettes): Chart {
  const { series: palette } = palettes;
  const all = block.series.flatMap(({ points }) => points.filter((point) => point !== null));
  const covered = all.filter(({ published }) => published !== null);
  const inside = covered.filter(({ low, high, published }) => low <= published! && published! <= high);
  return category_chart({
    block, marks: block.series.map(({ points }) => points), padding: 0.2,
    values: all.flatMap(({ low, high, value, published }) => [low, high, value, ...(published === null ? [] : [published])]),
    draw: (point, slot) => (point === null ? [] : point_marks(point, slot, palette)),
    middle: ({ value }) => value,
    tip: ({ value, low, high, published }, { colour }) => [
      { label: 'measured', value: short(value), colour },
      { label: 'interval', value: `${short(low)} – ${short(high)}` },
      ...(published === null ? [] : [{ label: 'published', value: short(published), colour: 'var(--ink)' }]),
    ],
    legend: [
      ...block.series.map(({ label }) =>
        ({ label, glyph: 'point' as const, colour: palette.colour(label), shape: palette.shape(label), toggles: true })),
      ...(covered.length > 0 ? [{ label: 'published', glyph: 'published' as const, toggles: false }] : []),
    ],
    summary: `Values of ${block.y_label || 'the measure'} with intervals, ${block.categories.length} categories, ` +
      `${block.series.map(({ label }) => label).join(', ')}.` + (covered.length === 0 ? ''
      : ` The published value lies inside the interval in ${inside.length} of ${covered.length} cases.`),
    cells: ({ value, low, high, published }) => ({ value, low, high, published }),
  }, palettes);
}
