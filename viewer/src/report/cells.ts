// SPDX-License-Identifier: Apache-2.0
// What stands in a table's cells, by the column's type.
import type { Palette } from '../common/colour';
import { h } from '../common/dom';
import { column_digits, fixed, p_value, signed_percent } from '../common/format';
import type { Cell, Column } from './model';

/** Verdicts from the best to the worst, which is also how they sort. */
export const verdicts: Record<string, { symbol: string; words: string }> = {
  reproduced: { symbol: '✓', words: 'reproduced' },
  reproduced_assuming: { symbol: '✓*', words: 'reproduced, assuming' },
  within_spread: { symbol: '≈', words: 'within spread' },
  partly: { symbol: '◐', words: 'partly' },
  not_reproduced: { symbol: '✕', words: 'not reproduced' },
  another_course: { symbol: '↷', words: 'on another course' },
  follows_from_inputs: { symbol: '=', words: 'follows from inputs' },
  no_reference: { symbol: '–', words: 'no reference' },
};

export function verdict_chip(verdict: string): HTMLElement {
  const known = verdicts[verdict];
  return h('span', { class: `verdict ${known === undefined ? 'no_reference' : verdict}` },
    h('span', { class: 'sign', 'aria-hidden': 'true' }, known?.symbol ?? '?'), known?.words ?? verdict);
}

/** Deviations up to here fill the bar; larger ones end in an arrow. */
function bar_range(values: number[]): number {
  const sizes = values.map(Math.abs).sort((a, b) => a - b);
  const most = sizes[Math.floor((sizes.length - 1) * 0.95)] ?? 0;
  return Math.max(0.05, Math.min(1, most));
}

function deviation(value: number, range: number): HTMLElement {
  const part = Math.min(1, Math.abs(value) / range) * 50;
  const bar = h('span', { class: `deviation-bar${Math.abs(value) > range * 1.0001 ? ' beyond' : ''}`, 'aria-hidden': 'true' }, h('i'));
  const fill = bar.firstElementChild as HTMLElement;
  fill.style.left = value < 0 ? `${50 - part}%` : '50%';
  fill.style.width = `${part}%`;
  return h('span', { class: 'deviation' }, h('span', {}, signed_percent(value)), bar);
}

/** Draws the cells of one column; what the whole column decides is found once. */
export function cell_writer(column: Column, values: Cell[], palette: Palette | null): (value: Cell) => Node {
  const numbers = values.filter((value) => typeof value === 'number');
  const digits = column.digits ?? column_digits(numbers);
  const range = bar_range(numbers);
  return (value) => {
    if (value === null || value === '') {
      const dash = h('span', { class: 'absent', 'aria-label': 'none' }, '–');
      // Under the percentages, not under the bars.
      return column.type === 'deviation' ? h('span', { class: 'deviation' }, dash, h('span', { class: 'no-bar' })) : dash;
    }
    if (column.type === 'verdict') return verdict_chip(String(value));
    if (column.type === 'deviation' && typeof value === 'number') return deviation(value, range);
    if (column.type === 'p' && typeof value === 'number') return document.createTextNode(p_value(value));
    if (typeof value === 'number') return document.createTextNode(fixed(value, digits));
    if (column.type === 'text' && palette?.has(value)) {
      const swatch = h('i', { class: 'swatch', 'aria-hidden': 'true' });
      swatch.style.background = palette.colour(value);
      return h('span', { class: 'named' }, swatch, value);
    }
    return document.createTextNode(value);
  };
}

/** The order of two cells of a column, smallest first; empty cells come last either way. */
export function compare_cells(column: Column, a: Cell, b: Cell, direction: 1 | -1): number {
  const empty = (value: Cell): boolean => value === null || value === '';
  if (empty(a) || empty(b)) return Number(empty(a)) - Number(empty(b));
  if (column.type === 'verdict') {
    const order = Object.keys(verdicts);
    const rank = (value: Cell): number => (order.indexOf(String(value)) + order.length + 1) % (order.length + 1);
    return direction * (rank(a) - rank(b));
  }
  if (typeof a === 'number' && typeof b === 'number') return direction * (a - b);
  return direction * String(a).localeCompare(String(b), 'en', { numeric: true });
}
