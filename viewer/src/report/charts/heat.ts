// SPDX-License-Identifier: Apache-2.0
// A table of colours: how good each row is in each column, with a word inside each cell.
import { fit_text, fit_texts, s, text_width } from '../../common/dom';
import { fixed, short } from '../../common/format';
import type { HeatBlock, HeatCell } from '../model';
import { extent } from './cartesian';
import { leads_to, numbers_table, type Chart, type Drawing, type Leading, type Target, type View } from './chart';

const font = 11.5;
const row_height = 22;
/** Room for a mark and a number in a cell; where that is more than there is, the table scrolls. */
const least_width = 44;
const scale_width = 110;

/** From the colour of 0 to that of 1; beyond these it stays. */
function shade(value: number, low: number, high: number): string {
  const part = Math.max(0, Math.min(1, high === low ? 1 : (value - low) / (high - low)));
  return `color-mix(in oklab, var(--c2) ${(100 * part).toFixed(1)}%, var(--c1))`;
}

function shown_value(value: number, { unit }: HeatBlock): string {
  return unit === '%' ? `${fixed(100 * value, 0)}\u00a0%` : short(value);
}

/** Where everything lies, from the width there is. */
function layout_of(block: HeatBlock, view: View) {
  const widest = Math.max(0, ...block.series.map(({ label }) => text_width(label, font)));
  const left = Math.min(widest, view.width * 0.34) + 12;
  const level = (view.width - left - 6) / Math.max(1, block.categories.length);
  const slanted = block.categories.some((name) => text_width(name, font) > Math.max(least_width, level) - 6);
  const labels = slanted ? fit_texts(block.categories, 96, font) : block.categories;
  // Slanted names reach beyond their columns, the last ones beyond the table.
  const reach = labels.map((name) => slanted ? text_width(name, font) * 0.71 + 4 : 0);
  const width = Math.max(least_width, Math.min(level, ...reach.map((beyond, c) => (view.width - left - beyond) / (c + 0.5))));
  const across = Math.max(left + labels.length * width + 6, ...reach.map((beyond, c) => left + (c + 0.5) * width + beyond));
  const top = slanted ? Math.max(0, ...labels.map((name) => text_width(name, font))) * 0.71 + font + 8 : font + 12;
  return { left, width, top, slanted, labels, across: Math.max(view.width, Math.ceil(across)) };
}

/** The colours between both ends of the range, and what they are of. */
function scale_marks(block: HeatBlock, left: number, across: number, y: number): SVGElement[] {
  const [low, high] = block.range;
  const [from, to] = [low, high].map((value) => shown_value(value, block)) as [string, string];
  const start = text_width(from, font) + 6;
  const whole = start + scale_width + 6 + text_width(to, font) + 12;
  const x = left + whole + text_width(block.value_label, font) <= across ? left : 0;
  const part = 5;
  const parts = scale_width / part;
  const text = (at: number, shown: string): SVGElement => s('text', { class: 'tick', x: at, y: y + font * 0.86 }, shown);
  return [
    text(x, from), text(x + start + scale_width + 6, to), text(x + whole, fit_text(block.value_label, across - x - whole, font)),
    ...Array.from({ length: parts }, (_, i) => s('rect', {
      class: 'heat-scale', colour: shade(i, 0, parts - 1), x: x + start + i * part, y, width: part, height: 11,
    })),
  ];
}

function cell_rows({ value, low, high, text, mark, note }: HeatCell, block: HeatBlock, colour: string) {
  return [
    { label: block.value_label || 'value', value: shown_value(value, block), colour },
    ...(low === null || high === null ? [] : [{ label: 'interval', value: `${shown_value(low, block)} – ${shown_value(high, block)}` }]),
    ...(text === '' ? [] : [{ label: block.text_label || 'text', value: text }]),
    ...(note === '' ? [] : [{ label: mark || 'place', value: note }]),
  ];
}

function leading({ made }: HeatCell, block: HeatBlock, column: number, title: string): Leading | null {
  const leads = leads_to(made, block.title, title);
  const see = block.see[column];
  return leads === null || see === undefined ? leads : { ...leads, see };
}

function draw(block: HeatBlock, view: View): Drawing {
  const { left, width, top, slanted, labels, across } = layout_of(block, view);
  const bottom = top + block.series.length * row_height;
  const height = bottom + 28;
  const svg = s('svg', { class: 'chart', 'font-size': font, viewBox: `0 0 ${across} ${height}`, width: across, height });
  svg.append(...scale_marks(block, left, view.width, bottom + 12));
  labels.forEach((label, c) => {
    const [x, y] = [left + (c + 0.5) * width, top - 7];
    svg.append(s('text', {
      class: 'tick', x, y, 'text-anchor': slanted ? 'start' : 'middle',
      transform: slanted ? `rotate(-45 ${x.toFixed(1)} ${y.toFixed(1)})` : undefined,
    }, label));
  });
  const names = fit_texts(block.series.map(({ label }) => label), left - 12, font);
  const targets: Target[] = [];
  const grid: (Target | null)[][] = block.series.map(({ label, cells }, r) => {
    const y = top + r * row_height;
    svg.append(s('text', { class: 'tick', x: left - 8, y: y + row_height / 2 + font * 0.36, 'text-anchor': 'end' }, names[r]));
    return cells.map((cell, c) => {
      const frame = { x: left + c * width + 1, y: y + 1, width: width - 2, height: row_height - 2 };
      if (cell === null) {
        svg.append(s('rect', { class: 'heat-none', ...frame }));
        return null;
      }
      const colour = shade(cell.value, block.range[0], block.range[1]);
      svg.append(s('rect', { class: 'heat', colour, ...frame }));
      const shown = `${cell.mark === '' ? '' : `${cell.mark} `}${cell.text}`;
      svg.append(s('text', { class: 'heat-text', x: frame.x + frame.width / 2, y: y + row_height / 2 + font * 0.36, 'text-anchor': 'middle' },
        text_width(shown, font) <= width - 4 ? shown : cell.mark));
      const title = `${label}, ${block.categories[c]!}`;
      const target: Target = {
        x: frame.x + frame.width / 2, y: frame.y + frame.height / 2,
        tip: () => ({ title, rows: cell_rows(cell, block, colour) }),
        cursor: () => ['pin-edge', 'pin-ring'].map((name) => s('rect', { class: name, ...frame })),
        runs: leading(cell, block, c, title),
      };
      targets.push(target);
      return target;
    });
  });
  const pick: Drawing['pick'] = (x, y) => grid[Math.floor((y - top) / row_height)]?.[Math.floor((x - left) / width)] ?? null;
  return { svg, targets, pick };
}

export function heat_chart(block: HeatBlock): Chart {
  const known = block.series.flatMap(({ cells }) => cells.filter((cell) => cell !== null));
  const ends = extent(known.map(({ value }) => value));
  return {
    legend: [],
    summary: `Table of ${block.value_label || 'values'} of ${block.series.length} by ${block.categories.length}, ${known.length} known` +
      (ends === null ? '.' : `, from ${short(ends[0])} to ${short(ends[1])}.`),
    data: () => numbers_table(block.title, [
      ['row', 'row', 'text'], ['column', block.category_label || 'column', 'text'], ['value', block.value_label || 'value'],
      ['low', 'from'], ['high', 'to'], ['text', block.text_label || 'text', 'text'], ['note', 'place', 'text'],
    ], block.series.flatMap(({ label, cells }) => cells.flatMap((cell, c) => cell === null ? [] : [
      { row: label, column: block.categories[c]!, value: cell.value, low: cell.low, high: cell.high, text: cell.text, note: cell.note },
    ]))),
    draw: (view) => draw(block, view),
  };
}
