// SPDX-License-Identifier: Apache-2.0
// One of several, by name.
import { h } from '../common/dom';
import type { Names } from './module';

export const as_given = 'as the scenario says';

export type Choice = [value: string, label: string, group?: string];

function make_select(label: string, choices: readonly Choice[], value: string, change: (value: string) => void): HTMLSelectElement {
  const select = h('select', { 'aria-label': label });
  for (const [name, text, group] of choices) {
    const option = h('option', { value: name, selected: name === value }, text);
    const last = select.lastElementChild;
    if (group === undefined) select.append(option);
    else if (last instanceof HTMLOptGroupElement && last.label === group) last.append(option);
    else select.append(h('optgroup', { label: group }, option));
  }
  select.addEventListener('change', () => change(select.value));
  return select;
}

export function chooser(label: string, choices: readonly Choice[], value: string, change: (value: string) => void): HTMLElement {
  return h('label', {}, label, make_select(label, choices, value, change));
}

/** Likewise, or null: as the scenario says. */
export function chooser_or(label: string, choices: readonly Choice[], value: string | null, change: (value: string | null) => void): HTMLElement {
  return chooser(label, [['', as_given], ...choices], value ?? '', (chosen) => change(chosen === '' ? null : chosen));
}

export function method_choices({ algorithms }: Names): Choice[] {
  const base = algorithms.filter(({ wraps }) => !wraps);
  const around = algorithms.filter(({ wraps }) => wraps);
  return [
    ...base.map(({ name, title }): Choice => [name, `${name}: ${title}`, 'Methods']),
    ...around.map(({ name, title }): Choice => [`orca3d+${name}`, `orca3d+${name}: ${title}`, 'A strategy around a method']),
  ];
}
