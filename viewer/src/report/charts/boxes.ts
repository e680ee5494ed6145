// SPDX-License-Identifier: Apache-2.0
// Box plots: quartiles, median, whiskers, mean and outliers per category and series.
import { shape_path } from '../../common/colour';
import { path_data, s } from '../../common/dom';
import { short } from '../../common/format';
import type { Tip } from '../../common/tooltip';
import type { Box, BoxesBlock } from '../model';
import { category_chart, type Slot } from './categories';
import type { Chart, Palettes } from './chart';

function tip(block: BoxesBlock, box: Box, { label, category, colour }: Slot): Tip['rows'] {
  return [
    { label: 'median', value: short(box.median), colour },
    { label: 'quartiles', value: `${short(box.q1)} – ${short(box.q3)}` },
    { label: 'whiskers', value: `${short(box.min)} – ${short(box.max)}` },
    ...(box.mean === null ? [] : [{ label: 'mean', value: short(box.mean) }]),
    ...(box.outliers.length === 0 ? [] : [{ label: 'outliers', value: String(box.outliers.length) }]),
    ...(box.count === null ? [] : [{ label: 'runs', value: String(box.count) }]),
    ...block.marks.filter((mark) => mark.series === label && mark.category === category)
      .map((mark) => ({ label: mark.label, value: short(mark.value) })),
  ];
}

/** What lies above the axis' end becomes an arrow head there. */
function box_marks(box: Box, { x, y, width, most }: Slot): SVGElement[] {
  const half = Math.max(1.5, Math.min(width * 0.4, 17));
  const cap = half / 2;
  const size = Math.max(1.4, Math.min(half * 0.28, 2.6));
  const top = y(most);
  const upright = (from: number, to: number): [number, number][] => [[x, y(from)], [x, y(to)]];
  const across = (value: number): [number, number][] => [[x - cap, y(value)], [x + cap, y(value)]];
  return [
    s('path', {
      class: 'whisker',
      d: path_data([...upright(box.max, box.q3), null, ...upright(box.q1, box.min), null, ...across(box.max), null, ...across(box.min)]),
    }),
    s('rect', { class: 'box', x: x - half, width: 2 * half, y: y(box.q3), height: Math.max(1, y(box.q1) - y(box.q3)), rx: 1.5 }),
    s('line', { class: 'median', x1: x - half, x2: x + half, y1: y(box.median), y2: y(box.median) }),
    ...box.outliers.filter((value) => value <= most).map((value) => s('circle', { class: 'outlier', cx: x, cy: y(value), r: size })),
    ...([box.max, ...box.outliers].some((value) => value > most)
      ? [s('path', { class: 'beyond', d: `M${(x - 3.5).toFixed(1)} ${top + 5}l3.5 -5l3.5 5Z` })] : []),
    ...(box.mean !== null && box.mean <= most && half >= 3.5
      ? [s('circle', { class: 'mean', cx: x, cy: y(box.mean), r: Math.min(half * 0.4, 3.1) })] : []),
  ];
}

function published(block: BoxesBlock, { label, category, x, y, width, most }: Slot): SVGElement[] {
  return block.marks.filter((mark) => mark.series === label && mark.category === category && mark.value <= most).map(({ value }) =>
    s('path', {
      class: 'published', d: shape_path('diamond', Math.max(3, Math.min(width * 0.3, 5))),
      transform: `translate(${x.toFixed(1)} ${y(value).toFixed(1)})`,
    }));
}

function summary_of(block: BoxesBlock): string {
  const medians = block.series.map(({ label, boxes }) => {
    const known = boxes.filter((box) => box !== null).map((box) => box.median);
    if (known.length === 0) return `${label}: no data`;
    return `${label}: medians from ${short(Math.min(...known))} to ${short(Math.max(...known))}`;
  });
  const over = block.category_label === '' ? '' : ` by ${block.category_label}`;
  return `Box plots of ${block.y_label || 'values'}${over}, ${block.categories.length} categories. ${medians.join('; ')}.`;
}

export function boxes_chart(block: BoxesBlock, palettes: Palettes): Chart {
  const all = block.series.flatMap(({ boxes }) => boxes.filter((box) => box !== null));
  const { series } = palettes;
  return category_chart({
    block, marks: block.series.map(({ boxes }) => boxes), padding: 0.15,
    values: [...all.flatMap(({ min, max, outliers }) => [min, max, ...outliers]), ...block.marks.map(({ value }) => value)],
    draw: (box, slot) => [...(box === null ? [] : box_marks(box, slot)), ...published(block, slot)],
    middle: ({ median }) => median,
    tip: (box, slot) => tip(block, box, slot),
    legend: [
      ...block.series.map(({ label }) =>
        ({ label, glyph: 'box' as const, colour: series.colour(label), dash: series.dash(label), toggles: true })),
      ...(all.some(({ mean }) => mean !== null) ? [{ label: 'mean', glyph: 'mean' as const, toggles: false }] : []),
      ...[...new Set(block.marks.map(({ label }) => label))].map((label) => ({ label, glyph: 'published' as const, toggles: false })),
    ],
    summary: summary_of(block),
    cells: ({ count, min, q1, median, q3, max, mean, outliers }) =>
      ({ count, min, q1, median, q3, max, mean, outliers: outliers.map(short).join(' ') }),
  }, palettes);
}
