// SPDX-License-Identifier: Apache-2.0
// What happened, in order; a click goes there.
import { h } from '../common/dom';
import type { Film, Moment } from './film';
import type { RunEvent, Scene } from './model';
import type { Panel } from './panel';
import { event_text, seconds } from './printed';

/** A longer list is no longer read; choosing vehicles shortens it. */
const most_shown = 300;

export function make_event_list(scene: Scene, film: Film, go_to: (event: RunEvent) => void): Panel {
  const list = h('ol', { class: 'events' });
  const note = h('p', { class: 'remark' });
  const element = h('div', {}, note, list);
  let chosen: ReadonlySet<number> = new Set();
  let shown: { event: RunEvent; button: HTMLButtonElement }[] = [];
  let current = -1;
  let known = 0;

  const fill = (): void => {
    known = film.events.length;
    const concerns = (event: RunEvent): boolean =>
      chosen.size === 0 || chosen.has(event.vehicle) || (event.other !== null && chosen.has(event.other));
    const all = film.events.filter(concerns);
    shown = all.slice(0, most_shown).map((event) => ({
      event,
      button: h('button', { type: 'button', click: () => go_to(event) },
        h('span', { class: 'when' }, seconds(event.time_s)), h('i', { class: `mark ${event.kind}`, 'aria-hidden': 'true' }), event_text(event, scene)),
    }));
    list.replaceChildren(...shown.map(({ button }) => h('li', {}, button)));
    const of = chosen.size === 0 ? '' : ' of the chosen vehicles';
    note.textContent = all.length === 0 ? `Nothing has happened${of}.` : all.length > most_shown
      ? `The first ${most_shown} of ${all.length} events${of}; choose vehicles to see theirs.` : `${all.length} events${of}, times in s.`;
    current = -1;
  };
  fill();
  return {
    element,
    show({ time }: Moment) {
      const last = shown.findLastIndex(({ event }) => event.time_s <= time + 1e-6);
      if (last === current) return;
      shown[current]?.button.removeAttribute('aria-current');
      shown[last]?.button.setAttribute('aria-current', 'true');
      current = last;
    },
    choose(vehicles) {
      chosen = vehicles;
      fill();
    },
    // Buttons that were replaced twenty times a second could not be clicked.
    grown() {
      if (film.events.length !== known) fill();
    },
  };
}
