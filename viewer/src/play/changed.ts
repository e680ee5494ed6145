// SPDX-License-Identifier: Apache-2.0
// What is changed in the scenario, from the beginning and on the way, each to be taken back.
import { h } from '../common/dom';
import { fixed } from '../common/format';
import type { State } from './state';

function entry(when: string, text: string, undo: () => void): HTMLElement {
  return h('li', {}, when === '' ? null : h('span', { class: 'when' }, when), h('code', {}, text),
    h('button', { type: 'button', class: 'undo', 'aria-label': `Take back ${text}`, title: 'Take this back', click: undo }, '×'));
}

/** `set` hears of the state without one of them. */
export function make_changed(state: State, set: (state: State) => void): HTMLElement {
  const rest = <T>(of: readonly T[], i: number): T[] => of.filter((_, k) => k !== i);
  const beginning = state.set.map(([path, value], i) => entry('', `${path}=${value}`, () => set({ ...state, set: rest(state.set, i) })));
  const later = state.changes.flatMap(({ at_s, set: changes }, i) => changes.map(([path, value], k) =>
    entry(`from ${fixed(at_s, 2)} s`, `${path}=${value}`, () => {
      const left = rest(changes, k);
      set({ ...state, changes: left.length === 0 ? rest(state.changes, i) : state.changes.with(i, { at_s, set: left }) });
    })));
  const all = [...beginning, ...later];
  return h('ul', { class: 'changed', hidden: all.length === 0, 'aria-label': 'What is changed' }, ...all);
}
