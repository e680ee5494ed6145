// SPDX-License-Identifier: Apache-2.0
// Why a vehicle decided as it did, in words and numbers.
import './explanation.css';
import { h, swatch, type Child } from '../../common/dom';
import { fixed, short } from '../../common/format';
import type { Explanation, Scene } from '../model';
import { vehicle_colour } from '../printed';

type Section = Explanation['sections'][number];
type Table = NonNullable<Section['table']>;

/** `range_m` is read as "range [m]", as the libraries name quantities with their unit. */
const units: Record<string, string> = {
  m: 'm', s: 's', mps: 'm/s', mps2: 'm/s²', rad: 'rad', deg: '°', radps: 'rad/s', n: 'N', w: 'W', hz: 'Hz', ratio: '', count: '',
};

export function heading_of(column: string): string {
  const parts = column.split('_');
  const unit = parts.length > 1 ? units[parts.at(-1)!] : undefined;
  const words = (unit === undefined ? parts : parts.slice(0, -1)).join(' ');
  return unit === undefined || unit === '' ? words : `${words} [${unit}]`;
}

/** Decimals with which a column of numbers lines up and keeps about four digits. */
function decimals(values: (string | number | undefined)[]): number {
  return Math.max(0, ...values.map((value) => (typeof value === 'number' ? (short(value).split('.')[1]?.length ?? 0) : 0)));
}

/** All digits of a number are in its title. */
function cell(value: string | number, digits: number): HTMLTableCellElement {
  if (typeof value !== 'number') return h('td', {}, value);
  return h('td', { class: 'number', title: String(value) }, Number.isFinite(value) ? fixed(value, digits) : '–');
}

function table({ columns, rows }: Table): HTMLElement {
  const is_number = columns.map((_, k) => rows.length > 0 && rows.every((row) => typeof row[k] === 'number'));
  const digits = columns.map((_, k) => decimals(rows.map((row) => row[k])));
  return h('div', { class: 'explanation-table', tabindex: 0, role: 'group' }, h('table', {},
    h('thead', {}, h('tr', {}, ...columns.map((column, k) =>
      h('th', { scope: 'col', class: is_number[k] === true ? 'number' : undefined }, heading_of(column))))),
    h('tbody', {}, ...rows.map((row) => h('tr', {}, ...row.map((value, k) => cell(value, digits[k] ?? 0)))))));
}

function section({ title, lines, table: numbers }: Section): HTMLElement {
  return h('section', {}, h('h3', {}, title), ...lines.map((line): Child => h('p', {}, line)),
    numbers === null ? null : table(numbers));
}

/** What `fairway explain` found; `seek` goes to the moment of the decision. */
export function make_explanation(explanation: Explanation, scene: Scene, seek: (time: number) => void): HTMLElement {
  const { vehicle, time_s, headline, sections } = explanation;
  const name = scene.vehicles[vehicle]?.name ?? `vehicle ${vehicle}`;
  const go = h('button', { type: 'button', class: 'chip', title: 'Show this moment in the picture' }, `Show t = ${fixed(time_s, 2)} s`);
  go.addEventListener('click', () => seek(time_s));
  return h('article', { class: 'explanation' },
    h('header', {}, h('span', { class: 'who' }, swatch(vehicle_colour(vehicle)), `${name}, decided at t = ${fixed(time_s, 2)} s`), go),
    h('h2', {}, headline), ...sections.map(section));
}
