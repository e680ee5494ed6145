// SPDX-License-Identifier: Apache-2.0
// Tables that sort, filter, lead to their runs, and leave as CSV and LaTeX.
import type { Palette } from '../common/colour';
import { h, slug } from '../common/dom';
import { fixed } from '../common/format';
import { action_button, copy_text, save_text } from '../common/save';
import { cell_writer, compare_cells, verdict_chip, verdicts } from './cells';
import { to_csv } from './csv';
import { to_latex } from './latex';
import type { Column, Row, TableBlock } from './model';
import { count_of, show_runs } from './runs_panel';

/** More rows than this are not drawn; CSV has them all. */
const most_rows = 1000;

export interface TableView {
  element: HTMLElement;
  /** The rows that pass the filters, in the order shown. */
  rows(): Row[];
  keep(key: string, value: string | null): void;
  changed(listener: (shown: number) => void): void;
}

const numeric = ({ type }: Column): boolean => type === 'number' || type === 'p' || type === 'deviation';
/** How a column is laid out. */
const layout_of = ({ type }: Column): string => type === 'p' ? 'number' : type;

/** A row; where its runs are known a click leads to them, and a button in its first cell does. */
function leading_row(block: TableBlock, row: Row, cells: HTMLElement[]): HTMLElement {
  const made = block.made?.get(row);
  const first = cells[0];
  if (made === undefined || first === undefined) return h('tr', {}, ...cells);
  const texts = block.columns.filter(({ type }) => type === 'text').map(({ key }) => String(row[key] ?? ''));
  const title = texts.filter((text) => text !== '' && text.length <= 30).join(', ');
  const button = h('button', {
    type: 'button', class: 'row-runs', 'aria-haspopup': 'dialog', title: `Show ${count_of(made)}`,
  }, ...first.childNodes);
  first.replaceChildren(button);
  const element = h('tr', { class: 'leads' }, ...cells);
  element.addEventListener('click', () => {
    // Whoever selects text in a row wants the text.
    if (getSelection()?.isCollapsed !== false) show_runs(title || block.title, made);
  });
  return element;
}

/** The scrolling table itself. */
export function table_body(block: TableBlock, label: string, palette: Palette | null = null): TableView {
  const columns = block.columns.filter(({ type }) => type !== 'remark');
  const remarks = block.columns.filter(({ type }) => type === 'remark');
  const writers = columns.map((column) => cell_writer(column, block.rows.map((row) => row[column.key] ?? null), palette));
  // Long texts wrap; short ones stay on their line.
  const kinds = columns.map((column) => column.type === 'text' &&
    block.rows.some((row) => String(row[column.key] ?? '').length > 30) ? 'text long' : layout_of(column));
  const kept = new Map<string, string>();
  const listeners: ((shown: number) => void)[] = [];
  let sorted: { column: Column; direction: 1 | -1 } | null = null;
  const body = h('tbody');

  const rows = (): Row[] => {
    const passing = block.rows.filter((row) => [...kept].every(([key, value]) => String(row[key] ?? '') === value));
    if (sorted === null) return passing;
    const { column, direction } = sorted;
    return passing.sort((a, b) => compare_cells(column, a[column.key] ?? null, b[column.key] ?? null, direction));
  };
  const refresh = (): void => {
    const shown = rows();
    body.replaceChildren(...shown.slice(0, most_rows).flatMap((row) => {
      const cells = columns.map((column, i) => h(i === 0 ? 'th' : 'td', {
        class: kinds[i], scope: i === 0 ? 'row' : undefined,
      }, writers[i]!(row[column.key] ?? null)));
      const said = remarks.map(({ key }) => String(row[key] ?? '')).filter((text) => text !== '');
      const line = leading_row(block, row, cells);
      if (said.length > 0) line.classList.add('remarked');
      const leads = line.classList.contains('leads');
      return [line, ...said.map((text) => h('tr', { class: `remark${leads ? ' leads' : ''}`, click: leads && (() => line.click()) },
        h('td', { colspan: columns.length }, h('div', {}, text))))];
    }));
    if (shown.length > most_rows) {
      body.append(h('tr', {}, h('td', { class: 'text', colspan: columns.length },
        `… ${fixed(shown.length - most_rows, 0)} more rows; CSV has them all`)));
    }
    if (shown.length === 0) {
      body.append(h('tr', {}, h('td', { class: 'text absent', colspan: columns.length }, 'No rows')));
    }
    for (const listener of listeners) listener(shown.length);
  };

  const heads = columns.map((column) => {
    const button = h('button', { type: 'button', title: `Sort by ${column.label}` }, h('span', {}, column.label),
      column.unit === '' ? null : h('span', { class: 'unit' }, ` [${column.unit}]`), h('i', { class: 'arrow', 'aria-hidden': 'true' }));
    const head = h('th', { scope: 'col', class: layout_of(column), 'aria-sort': 'none' }, button);
    button.addEventListener('click', () => {
      // Up, down, and back to the order of the data.
      const before = sorted?.column === column ? sorted.direction : null;
      sorted = before === null ? { column, direction: 1 } : before === 1 ? { column, direction: -1 } : null;
      for (const other of heads) other.setAttribute('aria-sort', 'none');
      if (sorted !== null) head.setAttribute('aria-sort', sorted.direction === 1 ? 'ascending' : 'descending');
      refresh();
    });
    return head;
  });
  const table = h('table', { class: columns.filter(numeric).length > columns.length / 2 ? 'mostly-numbers' : '' },
    h('caption', { class: 'offscreen' }, label), h('thead', {}, h('tr', {}, ...heads)), body);
  refresh();
  return {
    element: h('div', { class: 'table-scroll', tabindex: 0, role: 'region', 'aria-label': label }, table),
    rows,
    keep: (key, value) => {
      if (value === null) kept.delete(key);
      else kept.set(key, value);
      refresh();
    },
    changed: (listener) => listeners.push(listener),
  };
}

function filter_box(block: TableBlock, key: string, view: TableView): HTMLElement {
  const values = [...new Set(block.rows.map((row) => String(row[key] ?? '')))].filter((value) => value !== '');
  const label = block.columns.find((column) => column.key === key)?.label ?? key;
  const select = h('select', {}, h('option', { value: '' }, 'all'), ...values.map((value) => h('option', { value: `=${value}` }, value)));
  select.addEventListener('change', () => view.keep(key, select.value === '' ? null : select.value.slice(1)));
  return h('label', { class: 'filter' }, label, select);
}

/** How often each verdict was given, in proportion; a click keeps only those rows. */
function verdict_tally(block: TableBlock, view: TableView): HTMLElement | null {
  const column = block.columns.find(({ type }) => type === 'verdict');
  if (column === undefined || block.rows.length === 0) return null;
  const counts = Object.keys(verdicts).map((verdict) =>
    ({ verdict, count: block.rows.filter((row) => row[column.key] === verdict).length })).filter(({ count }) => count > 0);
  let chosen: string | null = null;
  const buttons = counts.map(({ verdict, count }) => {
    const button = h('button', { type: 'button', 'aria-pressed': 'false', title: 'Show only these rows' },
      h('b', {}, count), verdict_chip(verdict));
    button.addEventListener('click', () => {
      chosen = chosen === verdict ? null : verdict;
      counts.forEach((entry, i) => buttons[i]!.setAttribute('aria-pressed', String(entry.verdict === chosen)));
      view.keep(column.key, chosen);
    });
    return button;
  });
  const bar = h('div', { class: 'tally-bar', 'aria-hidden': 'true' }, ...counts.map(({ verdict, count }) => {
    const part = h('i', { class: verdict });
    part.style.flexGrow = String(count);
    return part;
  }));
  return h('div', { class: 'tally' }, bar, h('div', { class: 'tally-buttons' }, ...buttons));
}

export function table(block: TableBlock, id: string, number: string, palette: Palette): HTMLElement {
  const view = table_body(block, block.title || number, palette);
  const name = slug(block.title || id);
  const total = block.rows.length;
  const count = h('span', { class: 'row-count', role: 'status' }, `${fixed(total, 0)} rows`);
  view.changed((shown) => {
    count.textContent = shown === total ? `${fixed(total, 0)} rows` : `${fixed(shown, 0)} of ${fixed(total, 0)} rows`;
  });
  const actions = h('div', { class: 'actions' },
    action_button('Copy', 'Copy the rows shown as CSV', 'copied', () => copy_text(to_csv(block, view.rows()))),
    action_button('CSV', 'Save the rows shown as CSV', 'saved', () => save_text(`${name}.csv`, 'text/csv', to_csv(block, view.rows()))),
    action_button('LaTeX', 'Save the rows shown as a LaTeX table', 'saved',
      () => save_text(`${name}.tex`, 'text/x-tex', to_latex(block, view.rows(), name))));
  const filters = block.filter.map((key) => filter_box(block, key, view));
  return h('figure', { class: 'table', id },
    h('div', { class: 'head' },
      h('figcaption', {}, h('a', { class: 'ref', href: `#${id}` }, number), h('span', { class: 'title' }, block.title)), actions),
    verdict_tally(block, view),
    filters.length === 0 ? null : h('div', { class: 'filters' }, ...filters, count),
    view.element,
    block.note === '' ? null : h('p', { class: 'note-text' }, block.note));
}
