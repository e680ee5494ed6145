// SPDX-License-Identifier: Apache-2.0
// The runs behind a mark or a row: what each came to, the command that makes it alone, its playback.
import { h } from '../common/dom';
import { short } from '../common/format';
import { action_button, copy_text } from '../common/save';
import { hide_tip } from '../common/tooltip';
import type { Made, Run } from './model';

interface Entry {
  run: Run;
  value: number | null;
  /** Which of a run's several values, or null where it has one. */
  vehicle: number | null;
}

type Order = 'given' | 'smallest' | 'largest';
const orders: Record<Order, string> = { given: 'In order', smallest: 'Smallest first', largest: 'Largest first' };

/** So many are drawn at a time. */
const page_size = 200;

export function count_of({ runs }: Made): string {
  return runs.length === 1 ? 'its run' : `its ${runs.length} runs`;
}

function entries_of({ runs, values }: Made): Entry[] {
  const each = values.length / runs.length;
  if (each === 0) return runs.map((run) => ({ run, value: null, vehicle: null }));
  return values.map((value, i) =>
    ({ run: runs[Math.floor(i / each)]!, value, vehicle: each > 1 ? i % each : null }));
}

/** Those without a value come last either way. */
function sorted(entries: Entry[], order: Order): Entry[] {
  if (order === 'given') return entries;
  const sign = order === 'smallest' ? 1 : -1;
  return entries.toSorted((a, b) => a.value === null || b.value === null
    ? Number(a.value === null) - Number(b.value === null) : sign * (a.value - b.value));
}

function entry_element({ run, value, vehicle }: Entry, valued: boolean): HTMLElement {
  const link = run.playback === null ? null : h('a', { href: run.playback }, 'Playback');
  const head = h('div', { class: 'run-head' },
    valued ? h('b', { class: 'run-value' }, value === null ? '–' : short(value)) : null,
    vehicle === null ? null : h('span', {}, `vehicle ${vehicle}`),
    h('span', { class: 'run-label' }, run.label), h('span', {}, `seed ${run.seed}`), link);
  const command = run.command === '' ? h('p', { class: 'run-unknown' }, 'The command that makes this run is not known.')
    : h('div', { class: 'command' }, h('code', {}, run.command),
      action_button('Copy', 'Copy the command', 'copied', () => copy_text(run.command)));
  return h('li', {}, head, command);
}

/** The list, a part at a time. */
function fill(list: HTMLElement, entries: Entry[], valued: boolean): void {
  const more = h('button', { type: 'button', class: 'action' }, '');
  const last = h('li', { class: 'run-more' }, more);
  let drawn = 0;
  const draw = (): void => {
    last.remove();
    list.append(...entries.slice(drawn, drawn + page_size).map((entry) => entry_element(entry, valued)));
    drawn = Math.min(entries.length, drawn + page_size);
    more.textContent = `${entries.length - drawn} more`;
    if (drawn < entries.length) list.append(last);
  };
  more.addEventListener('click', draw);
  list.replaceChildren();
  list.scrollTop = 0;
  draw();
}

function order_buttons(list: HTMLElement, entries: Entry[]): HTMLElement {
  const buttons = (Object.keys(orders) as Order[]).map((order) => {
    const button = h('button', { type: 'button', 'aria-pressed': String(order === 'given') }, orders[order]);
    button.addEventListener('click', () => {
      for (const other of buttons) other.setAttribute('aria-pressed', String(other === button));
      fill(list, sorted(entries, order), true);
    });
    return button;
  });
  return h('div', { class: 'segments', role: 'group', 'aria-label': 'Order' }, ...buttons);
}

/** A link to the figure of that title, which closes the list. */
function figure_link(title: string, close: () => void): HTMLElement | null {
  const figure = [...document.querySelectorAll<HTMLElement>('figure')].find((each) => each.querySelector('figcaption .title')?.textContent === title);
  if (figure === undefined) return null;
  const link = h('a', { href: `#${figure.id}` }, `See ${title}`);
  link.addEventListener('click', close);
  return link;
}

/** Opens the list over the page; Escape, the button and a click beside it close it again. `see` is the title of a figure to lead on to. */
export function show_runs(title: string, made: Made, see = ''): void {
  hide_tip();
  const entries = entries_of(made);
  const valued = made.values.length > 0;
  const list = h('ol', { class: 'run-list', tabindex: 0, 'aria-label': 'Runs' });
  const close = h('button', { type: 'button', class: 'action', 'aria-label': 'Close' }, 'Close');
  const counted = made.runs.length === 1 ? '1 run' : `${made.runs.length} runs`;
  const measured = valued && made.values_label !== '' ? ', each with its ' : '';
  const dialog: HTMLDialogElement = h('dialog', { class: 'runs', 'aria-labelledby': 'runs-title' },
    h('div', { class: 'runs-bar' }, h('h2', { id: 'runs-title' }, title), close),
    h('div', { class: 'runs-bar' },
      h('span', { class: 'run-count' }, counted + measured, measured === '' ? null : h('b', {}, made.values_label)),
      see === '' ? null : figure_link(see, () => dialog.close()),
      valued && entries.length > 1 ? order_buttons(list, entries) : null),
    list);
  fill(list, entries, valued);
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  list.focus();
}
