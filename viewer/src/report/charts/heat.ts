// SPDX-License-Identifier: Apache-2.0
// A table of colours: how good each row is in each column, with a word inside each cell.
import { fit_texts, s, text_width } from '../../common/dom';
import { short } from '../../common/format';
import type { HeatBlock, HeatCell } from '../model';
import { extent } from './cartesian';
import { leads_to, numbers_table, type Chart, type Drawing, type Target, type View } from './chart';

const font = 11.5;
const row_height = 22;

/** From the colour of 0 to that of 1; beyond these it stays. */
function shade(value: number, low: number, high: number): string {
  const part = Math.max(0, Math.min(1, high === low ? 1 : (value - low) / (high - low)));
  return `color-mix(in oklab, var(--c2) ${(100 * part).toFixed(1)}%, var(--c1))`;
}

/** Where everything lies, from the width there is. */
function layout_of(block: HeatBlock, view: View) {
  const widest = Math.max(0, ...block.series.map(({ label }) => text_width(label, font)));
  const left = Math.min(widest, view.width * 0.34) + 12;
  const width = Math.max(14, (view.width - left - 6) / Math.max(1, block.categories.length));
  const slanted = block.categories.some((name) => text_width(name, font) > width - 6);
  const labels = slanted ? fit_texts(block.categories, 96, font) : block.categories;
  const top = slanted ? Math.max(0, ...labels.map((name) => text_width(name, font))) * 0.71 + font + 8 : font + 12;
  return { left, width, top, slanted, labels };
}

function cell_rows({ value, low, high, text, mark, note }: HeatCell, block: HeatBlock, colour: string) {
  return [
    { label: block.value_label || 'value', value: short(value), colour },
    ...(low === null || high === null ? [] : [{ label: 'interval', value: `${short(low)} – ${short(high)}` }]),
    ...(text === '' ? [] : [{ label: block.text_label || 'text', value: text }]),
    ...(note === '' ? [] : [{ label: mark || 'place', value: note }]),
  ];
}

function draw(block: HeatBlock, view: View): Drawing {
  const { left, width, top, slanted, labels } = layout_of(block, view);
  const height = top + block.series.length * row_height + 6;
  const across = Math.max(view.width, left + block.categories.length * width + 6);
  const svg = s('svg', { class: 'chart', 'font-size': font, viewBox: `0 0 ${across} ${height}`, width: view.width, height: (height * view.width) / across });
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
        runs: leads_to(cell.made, block.title, title),
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
