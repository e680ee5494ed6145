// SPDX-License-Identifier: Apache-2.0
// One card per vehicle: who it is and, of the frame that is shown, where it is and how it fares.
import { h, swatch } from '../common/dom';
import { fixed, finite } from '../common/format';
import type { Selection } from './selection';
import type { Film, Moment } from './film';
import { icon_button } from './icons';
import type { Scene } from './model';
import type { Panel } from './panel';
import { alert_text, goal_distance, mode_text, phase_text, position_texts, progress_text, seconds, shortfall_text, vehicle_colour } from './printed';

/** Of more vehicles than these, only the chosen ones show their numbers. */
const most_in_full = 4;

interface Card {
  element: HTMLElement;
  show(index: number): void;
  choose(): void;
}

function value_row(label: string, unit: string): { row: HTMLElement; value: HTMLElement } {
  const value = h('b', {});
  return { row: h('span', { class: 'value' }, h('i', {}, label), value, h('i', {}, unit)), value };
}

// Untouched texts cost nothing; a page with fifty cards would otherwise spend its time in layout.
function set_text(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

function make_card(vehicle: number, scene: Scene, film: Film, choice: Selection, brief: boolean): Card {
  const spec = scene.vehicles[vehicle]!;
  const dot = h('span', { class: 'alert-dot' });
  const status = h('span', { class: 'status' });
  const shortfall = h('span', { class: 'shortfall', hidden: true });
  const progress = h('span', { class: 'progress', hidden: true });
  const places = ['n', 'e', 'd'].map((axis) => value_row(axis, ''));
  const speed = value_row('speed', 'm/s');
  const goal = value_row('to goal', 'm');
  const main = h('button', {
    type: 'button', class: 'vehicle', 'aria-pressed': 'false', title: 'Choose; shift-click adds, double-click follows',
    click: (event) => choice.pick(vehicle, event instanceof MouseEvent && (event.shiftKey || event.ctrlKey || event.metaKey)),
    dblclick: () => choice.follow(vehicle),
  },
  h('span', { class: 'who' }, swatch(vehicle_colour(vehicle)), h('span', { class: 'name' }, spec.name), dot, status),
  h('span', { class: 'what' }, [spec.model, spec.avoider === '' ? 'no avoidance' : spec.avoider,
    spec.cooperative ? '' : 'not cooperative'].filter((word) => word !== '').join(' · ')),
  shortfall,
  progress,
  h('span', { class: 'values place' }, ...places.map(({ row }) => row), h('i', {}, 'm')),
  h('span', { class: 'values' }, speed.row, goal.row));
  const follow = icon_button('follow', `Follow ${spec.name}`, vehicle < 9 ? String(vehicle + 1) : '', () => choice.follow(vehicle));
  const element = h('li', { class: brief ? 'brief' : '' }, main, follow);

  let shown = false;
  let state = '';
  return {
    element,
    show(index) {
      const alert = alert_text(film, index, vehicle);
      const now = `${phase_text(film, index, vehicle)} · ${mode_text(film, index, vehicle)} · ${alert}`;
      if (now !== state) {
        state = now;
        status.textContent = now;
        dot.dataset['alert'] = alert;
      }
      const beyond = shortfall_text(film, index, vehicle);
      shortfall.hidden = beyond === '';
      set_text(shortfall, beyond === '' ? '' : `commanded ${beyond}`);
      const standing = progress_text(film, index, vehicle, scene);
      progress.hidden = standing === '';
      set_text(progress, standing);
      if (brief && !shown) return;
      position_texts(film, index, vehicle).forEach((text, k) => set_text(places[k]!.value, text));
      set_text(speed.value, fixed(film.length('velocity_mps', index, vehicle), 3));
      const distance = goal_distance(film, index, vehicle);
      set_text(goal.value, finite(distance) ? fixed(distance, 3) : '–');
    },
    choose() {
      shown = choice.chosen.has(vehicle);
      element.classList.toggle('chosen', shown);
      main.setAttribute('aria-pressed', String(shown));
      follow.classList.toggle('on', choice.camera === 'follow' && choice.followed === vehicle);
    },
  };
}

export function make_vehicle_list(scene: Scene, film: Film, choice: Selection): Panel {
  const brief = scene.vehicles.length > most_in_full;
  const cards = scene.vehicles.map((_, vehicle) => make_card(vehicle, scene, film, choice, brief));
  const time = h('output', { class: 'at-time' });
  const element = h('div', {}, h('p', { class: 'remark' }, 'In the frame at ', time, ' s: north, east, down'),
    h('ul', { class: 'vehicles' }, ...cards.map((card) => card.element)));
  let index = -1;
  const show = (next: number): void => {
    index = next;
    set_text(time, seconds(film.time(index)));
    for (const card of cards) card.show(index);
  };
  // The camera matters too: it follows one of them.
  choice.on_change(() => {
    for (const card of cards) card.choose();
    if (index >= 0) show(index);
  });
  return {
    element,
    show(moment: Moment) {
      if (moment.index !== index) show(moment.index);
    },
    grown: () => { index = -1; },
  };
}
