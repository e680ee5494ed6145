// SPDX-License-Identifier: Apache-2.0
// What charts over categories share: bands, slots for the series inside each, labels under them, and pointing at a slot.
import { fit_texts, s, text_width } from '../../common/dom';
import type { LegendEntry } from '../../common/legend';
import { bands } from '../../common/scale';
import type { Tip } from '../../common/tooltip';
import type { BoxesBlock, Cell, IntervalsBlock, Made } from '../model';
import { canvas, least_left, type Canvas } from './cartesian';
import { leads_to, numbers_table, pick_along_x, type Chart, type Drawing, type Palettes, type Target, type View } from './chart';

/** The place of one series in one category. */
export interface Slot {
  label: string;
  category: string;
  colour: string;
  x: number;
  width: number;
  /** The upper end of the axis: what lies above it is drawn at it. */
  most: number;
  y(value: number): number;
}

/** How a kind of chart draws and tells its marks. */
export interface Marks<M extends { made: Made | null }> {
  block: BoxesBlock | IntervalsBlock;
  /** The marks of each series, null where a category has none. */
  marks: (M | null)[][];
  /** All that the axis must hold. */
  values: number[];
  padding: number;
  draw(mark: M | null, slot: Slot): SVGElement[];
  /** Where it is pointed at. */
  middle(mark: M): number;
  tip(mark: M, slot: Slot): Tip['rows'];
  legend: LegendEntry[];
  summary: string;
  /** Of the numbers behind the chart, by key. */
  cells(mark: M): Record<string, Cell>;
}

/** Labels under categories: level where they fit, slanted where they do not. */
function category_layout(categories: string[], inner: number, font: number) {
  const band = inner / Math.max(1, categories.length);
  const widest = Math.max(0, ...categories.map((name) => text_width(name, font)));
  const slanted = widest > band - 4;
  // The first label may not reach beyond the left edge: half a band and the least room for ticks are beside it.
  const room = Math.min(widest, 92, (band / 2 + least_left - 2) / 0.71);
  const labels = slanted ? fit_texts(categories, room, font) : categories;
  const longest = Math.max(0, ...labels.map((name) => text_width(name, font)));
  return { slanted, labels, space: slanted ? longest * 0.71 + font + 4 : font + 10 };
}

function draw_categories({ svg, area, font }: Canvas, categories: string[], centre: (i: number) => number): void {
  const { slanted, labels } = category_layout(categories, area.right - area.left, font);
  labels.forEach((label, i) => {
    const x = centre(i);
    const y = area.bottom + (slanted ? 10 : font + 6);
    svg.append(s('text', {
      class: 'tick', x, y, 'text-anchor': slanted ? 'end' : 'middle',
      transform: slanted ? `rotate(-45 ${x.toFixed(1)} ${y.toFixed(1)})` : undefined,
    }, label));
  });
}

function draw<M extends { made: Made | null }>(of: Marks<M>, palettes: Palettes, view: View): Drawing {
  const { categories, series, y_label, y_max, lines: rules, category_label: x_label, title } = of.block;
  const shown = series.map((_, i) => i).filter((i) => !view.hidden.has(series[i]!.label));
  const on = canvas({
    view, y_label, y_max, rules, x_label, values: of.values,
    x_space: (inner, font) => category_layout(categories, inner, font).space,
  });
  const { left, right, top, bottom } = on.area;
  const layout = bands(categories.length, shown.length, left, right, of.padding * (series.length > 1 ? 1 : 2));
  // Faint bands behind every other category, where several series share one.
  for (let i = 1; series.length > 1 && i < categories.length; i += 2) {
    on.svg.prepend(s('rect', { class: 'band', x: left + i * layout.width, y: top, width: layout.width, height: bottom - top }));
  }
  draw_categories(on, categories, layout.centre);

  const targets: Target[] = [];
  categories.forEach((category, c) => shown.forEach((i, part) => {
    const { label } = series[i]!;
    const slot: Slot = {
      label, category, colour: palettes.series.colour(label), x: layout.slot_centre(c, part), width: layout.slot,
      most: on.y.domain[1], y: (value) => Math.max(on.y(value), top),
    };
    const mark = of.marks[i]![c] ?? null;
    on.marks.append(s('g', { colour: slot.colour, 'stroke-dasharray': palettes.series.dash(label) || undefined }, ...of.draw(mark, slot)));
    if (mark === null) return;
    targets.push({
      x: slot.x, y: slot.y(of.middle(mark)),
      tip: () => ({ title: `${label}, ${category}`, rows: of.tip(mark, slot) }),
      runs: leads_to(mark.made && { ...mark.made, values_label: mark.made.values_label || y_label }, title, label, category),
      cursor: () => [s('rect', { class: 'slot', x: slot.x - slot.width / 2, y: top, width: slot.width, height: bottom - top, rx: 3 })],
    });
  }));
  return { svg: on.svg, targets, pick: pick_along_x(targets, layout.slot / 2 + 1) };
}

export function category_chart<M extends { made: Made | null }>(of: Marks<M>, palettes: Palettes): Chart {
  const { block } = of;
  const rows = block.series.flatMap(({ label }, i) => of.marks[i]!.flatMap((mark, c) =>
    mark === null ? [] : [{ category: block.categories[c]!, series: label, ...of.cells(mark) }]));
  const keys = Object.keys(rows[0] ?? {}).slice(2);
  return {
    legend: [...of.legend, ...block.lines.map(({ label }) => ({ label, glyph: 'rule' as const, toggles: false }))],
    summary: of.summary,
    data: () => numbers_table(block.title, [
      ['category', block.category_label || 'category', 'text'], ['series', 'series', 'text'],
      ...keys.map((key) => [key, key, key === 'outliers' ? 'text' : 'number'] as const),
    ], rows),
    draw: (view) => draw(of, palettes, view),
  };
}
