// SPDX-License-Identifier: Apache-2.0
// Box plots: quartiles, median, whiskers, mean and outliers per category and series.
import { shape_path } from '../../common/colour';
import { s } from '../../common/dom';
import { short } from '../../common/format';
import type { LegendEntry } from '../../common/legend';
import { bands } from '../../common/scale';
import type { Tip } from '../../common/tooltip';
import type { Box, BoxesBlock, Column } from '../model';
import { canvas, category_layout, draw_bands, draw_categories } from './cartesian';
import { leads_to, pick_along_x, type Chart, type Drawing, type Palettes, type Target, type View } from './chart';

function box_tip(block: BoxesBlock, category: number, series: number, box: Box, colour: string): Tip {
  const { label } = block.series[series]!;
  const name = block.categories[category]!;
  const rows: Tip['rows'] = [
    { label: 'median', value: short(box.median), colour },
    { label: 'quartiles', value: `${short(box.q1)} – ${short(box.q3)}` },
    { label: 'whiskers', value: `${short(box.min)} – ${short(box.max)}` },
  ];
  if (box.mean !== null) rows.push({ label: 'mean', value: short(box.mean) });
  if (box.outliers.length > 0) rows.push({ label: 'outliers', value: String(box.outliers.length) });
  if (box.count !== null) rows.push({ label: 'runs', value: String(box.count) });
  for (const mark of block.marks) {
    if (mark.series === label && mark.category === name) rows.push({ label: mark.label, value: short(mark.value) });
  }
  return { title: `${label}, ${name}`, rows };
}

/** The drawing of one box about x; what lies above the axis' end becomes an arrow head there. */
function box_marks(box: Box, x: number, slot: number, y: (v: number) => number, top: number, top_y: number): SVGElement[] {
  const half = Math.max(1.5, Math.min(slot * 0.4, 17));
  const at = (value: number): number => Math.max(y(value), top_y);
  const cap = half * 0.5;
  const marks: SVGElement[] = [
    s('path', {
      class: 'whisker',
      d: `M${x.toFixed(1)} ${at(box.max).toFixed(1)}V${at(box.q3).toFixed(1)}` +
        `M${x.toFixed(1)} ${at(box.q1).toFixed(1)}V${at(box.min).toFixed(1)}` +
        `M${(x - cap).toFixed(1)} ${at(box.max).toFixed(1)}h${(2 * cap).toFixed(1)}` +
        `M${(x - cap).toFixed(1)} ${at(box.min).toFixed(1)}h${(2 * cap).toFixed(1)}`,
    }),
    s('rect', {
      class: 'box', x: x - half, width: 2 * half, y: at(box.q3), height: Math.max(1, at(box.q1) - at(box.q3)), rx: 1.5,
    }),
    s('line', { class: 'median', x1: x - half, x2: x + half, y1: at(box.median), y2: at(box.median) }),
  ];
  const size = Math.max(1.4, Math.min(half * 0.28, 2.6));
  for (const value of box.outliers) {
    if (value <= top) marks.push(s('circle', { class: 'outlier', cx: x, cy: at(value), r: size }));
  }
  if (box.max > top || box.outliers.some((value) => value > top)) {
    marks.push(s('path', { class: 'beyond', d: `M${(x - 3.5).toFixed(1)} ${top_y + 5}l3.5 -5l3.5 5Z` }));
  }
  if (box.mean !== null && box.mean <= top && half >= 3.5) {
    marks.push(s('circle', { class: 'mean', cx: x, cy: y(box.mean), r: Math.min(half * 0.4, 3.1) }));
  }
  return marks;
}

function draw(block: BoxesBlock, { series: palette }: Palettes, view: View): Drawing {
  const shown = block.series.map((_, i) => i).filter((i) => !view.hidden.has(block.series[i]!.label));
  const all = block.series.flatMap((series) => series.boxes.filter((box) => box !== null));
  const values = all.flatMap((box) => [box.min, box.max, ...box.outliers]);
  const on = canvas({
    view, y_label: block.y_label, y_max: block.y_max, rules: block.lines, x_label: block.category_label,
    values: [...values, ...block.marks.map((mark) => mark.value)],
    x_space: (inner, font) => category_layout(block.categories, inner, font).space,
  });
  const { left, right, top, bottom } = on.area;
  const layout = bands(block.categories.length, shown.length, left, right, block.series.length > 1 ? 0.14 : 0.3);
  if (block.series.length > 1) draw_bands(on, block.categories.length, layout.width);
  draw_categories(on, block.categories, layout.centre);

  const targets: Target[] = [];
  block.categories.forEach((category, c) => shown.forEach((i, part) => {
    const { label, boxes } = block.series[i]!;
    const [colour, dash] = [palette.colour(label), palette.dash(label)];
    const x = layout.slot_centre(c, part);
    const box = boxes[c] ?? null;
    if (box !== null) {
      on.marks.append(s('g', { colour, 'stroke-dasharray': dash || undefined }, ...box_marks(box, x, layout.slot, on.y, on.y.domain[1], top)));
      targets.push({
        x, y: Math.max(top, on.y(box.median)), tip: () => box_tip(block, c, i, box, colour),
        runs: leads_to(box.made, block.title, label, category),
        cursor: () => [s('rect', {
          class: 'slot', x: x - layout.slot / 2, y: top, width: layout.slot, height: bottom - top, rx: 3,
        })],
      });
    }
    for (const mark of block.marks) {
      if (mark.series !== label || mark.category !== category || mark.value > on.y.domain[1]) continue;
      on.marks.append(s('path', {
        class: 'published', d: shape_path('diamond', Math.max(3, Math.min(layout.slot * 0.3, 5))),
        transform: `translate(${x.toFixed(1)} ${on.y(mark.value).toFixed(1)})`,
      }));
    }
  }));
  return { svg: on.svg, targets, pick: pick_along_x(targets, layout.slot / 2 + 1) };
}

const statistics = ['count', 'min', 'q1', 'median', 'q3', 'max', 'mean'] as const;

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
  const marks = [...new Set(block.marks.map((mark) => mark.label))];
  const any_mean = block.series.some(({ boxes }) => boxes.some((box) => box !== null && box.mean !== null));
  const legend: LegendEntry[] = [
    ...block.series.map(({ label }) => ({
      label, glyph: 'box' as const, colour: palettes.series.colour(label), dash: palettes.series.dash(label), toggles: true,
    })),
    ...(any_mean ? [{ label: 'mean', glyph: 'mean' as const, toggles: false }] : []),
    ...marks.map((label) => ({ label, glyph: 'published' as const, toggles: false })),
    ...block.lines.map(({ label }) => ({ label, glyph: 'rule' as const, toggles: false })),
  ];
  const text = (key: string, label: string): Column => ({ key, label, unit: '', type: 'text', digits: null });
  return {
    legend,
    summary: summary_of(block),
    data: () => ({
      kind: 'table', title: block.title, note: '', filter: [],
      columns: [
        text('category', block.category_label || 'category'), text('series', 'series'),
        ...statistics.map((key): Column => ({ key, label: key, unit: '', type: 'number', digits: null })),
        text('outliers', 'outliers'),
      ],
      rows: block.series.flatMap(({ label, boxes }) => boxes.flatMap((box, i) => box === null ? [] : [{
        category: block.categories[i]!, series: label, count: box.count, min: box.min, q1: box.q1, median: box.median,
        q3: box.q3, max: box.max, mean: box.mean, outliers: box.outliers.map(short).join(' '),
      }])),
    }),
    draw: (view) => draw(block, palettes, view),
  };
}
