// SPDX-License-Identifier: Apache-2.0
// What a vehicle knows at a moment: tracks, the last ping, messages under way, and what its method said and heard.
import { h, swatch, type Child } from '../../common/dom';
import { fixed } from '../../common/format';
import { yaw_of } from '../charts/curves';
import type { Film } from '../film';
import type { EchoesRecord, Flight, Scene, TracksRecord, Vec3, WordRecord } from '../model';
import { who_is } from './who';

const most_flights = 8;
const degrees = 180 / Math.PI;
const track_columns = [['track', ''], ['range', 'm'], ['bearing', ''], ['closing', 'm/s'], ['age', 's'], ['σ', 'm']] as const;

type Track = TracksRecord['tracks'][number];

/** Of another, as seen from a vehicle: closing is positive while the range shrinks. */
export interface Sight {
  range_m: number;
  bearing_rad: number;
  closing_mps: number;
}

export function sight_of({ position, velocity }: Track, own: { position: Vec3; velocity: Vec3; yaw: number }): Sight {
  const away = [0, 1, 2].map((k) => position[k]! - own.position[k]!) as [number, number, number];
  const range_m = Math.hypot(...away);
  const opening = [0, 1, 2].reduce((sum, k) => sum + away[k]! * (velocity[k]! - own.velocity[k]!), 0);
  const bearing = Math.atan2(away[1], away[0]) - own.yaw;
  return { range_m, bearing_rad: Math.atan2(Math.sin(bearing), Math.cos(bearing)), closing_mps: range_m > 0 ? -opening / range_m : 0 };
}

/** Off the bow: 34° stbd. */
export function bearing_words(bearing_rad: number): string {
  const angle = Math.round(Math.abs(bearing_rad) * degrees);
  return angle === 0 ? 'ahead' : angle === 180 ? 'astern' : `${angle}° ${bearing_rad > 0 ? 'stbd' : 'port'}`;
}

/** The last word of each of the others that has come in, in their order. Where messages under way were not kept there is none. */
export function words_heard(film: Film, vehicle: number, time: number): WordRecord[] {
  const last = new Map<number, Flight>();
  for (const flight of film.words.any ? film.flights : []) {
    if (flight.to !== vehicle || flight.unheard || flight.arrives_s > time) continue;
    if (flight.sent_s > (last.get(flight.from)?.sent_s ?? -Infinity)) last.set(flight.from, flight);
  }
  return [...last.values()].sort((x, y) => x.from - y.from).flatMap(({ from, sent_s }) => {
    const record = film.words.at(from, sent_s);
    return record?.word.sent_s === sent_s ? [record] : [];
  });
}

export class Perceived {
  readonly element = h('div', { class: 'perceived' });
  private shown = '';

  constructor(private readonly scene: Scene, private readonly film: Film) {}

  /** Says what the vehicle knows; does nothing while that is the same. */
  show(vehicle: number, time: number): void {
    const tracks = this.film.tracks.at(vehicle, time);
    const echoes = this.film.echoes.at(vehicle, time);
    const flights = this.film.flights.filter(({ from, to, sent_s, arrives_s }) =>
      (from === vehicle || to === vehicle) && sent_s <= time && time < arrives_s);
    const said = this.film.words.at(vehicle, time);
    const heard = words_heard(this.film, vehicle, time);
    const key = [vehicle, tracks?.time_s, echoes?.time_s, said?.time_s, ...heard.map((word) => `${word.vehicle}:${word.time_s}`), ...flights.map(({ from, to, sent_s }) => `${from}-${to}-${sent_s}`)].join();
    if (key === this.shown) return;
    this.shown = key;
    this.element.replaceChildren(...[
      tracks === null ? null : this.track_table(tracks),
      echoes === null ? null : h('section', {}, h('h3', {}, 'Sonar'), h('p', {}, echo_words(echoes))),
      said === null && heard.length === 0 ? null : this.word_list(said, heard),
      flights.length === 0 ? null : this.flight_list(vehicle, flights),
    ].filter((part) => part !== null));
  }

  forget(): void {
    this.shown = '';
    this.element.replaceChildren();
  }

  private track_table({ time_s, vehicle, tracks }: TracksRecord): HTMLElement {
    const i = this.film.index_at(time_s);
    const own = {
      position: this.film.vector('position_m', i, vehicle), velocity: this.film.vector('velocity_mps', i, vehicle),
      yaw: yaw_of(this.film, i, vehicle),
    };
    const rows = tracks.map((track) => ({ track, sight: sight_of(track, own) })).sort((a, b) => a.sight.range_m - b.sight.range_m);
    const title = h('h3', {}, 'Perceived ', h('small', {}, `at t = ${fixed(time_s, 2)} s, nearest first`));
    if (rows.length === 0) return h('section', {}, title, h('p', {}, 'Nobody.'));
    return h('section', {}, title, h('div', { class: 'perceived-table', tabindex: 0, role: 'group' }, h('table', {},
      h('thead', {}, h('tr', {}, ...track_columns.map(([label, unit]) =>
        h('th', { scope: 'col' }, label, unit === '' ? null : h('small', {}, ` ${unit}`))))),
      h('tbody', {}, ...rows.map(({ track, sight }) => h('tr', {},
        h('th', { scope: 'row' }, ...this.who(track)), h('td', {}, fixed(sight.range_m, 1)), h('td', {}, bearing_words(sight.bearing_rad)),
        h('td', {}, fixed(sight.closing_mps, 2)), h('td', {}, fixed(track.age_s, 1)), h('td', {}, fixed(track.sigma_m, 2))))))));
  }

  private who({ id, reacts }: Track): Child[] {
    const { name, colour } = who_is(id, this.scene.vehicles);
    return [swatch(colour), name, reacts ? null : h('small', {}, ' does not react')];
  }

  private word_list(said: WordRecord | null, heard: WordRecord[]): HTMLElement {
    const awaited = said?.word.awaited ?? [];
    const line = (who: string, { word }: WordRecord): HTMLElement =>
      h('li', {}, h('b', {}, who), ` at ${fixed(word.sent_s, 2)} s: ${word.text}`);
    return h('section', { class: 'words' }, h('h3', {}, 'Words'), h('ul', {},
      said === null ? null : line('It said', said),
      awaited.length === 0 ? null : h('li', {}, `So it waits for words of ${awaited.map((k) => this.name(k)).join(', ')}`),
      ...heard.map((word) => line(this.name(word.vehicle), word))));
  }

  private name(vehicle: number): string {
    return this.scene.vehicles[vehicle]?.name ?? `vehicle ${vehicle}`;
  }

  private flight_list(vehicle: number, flights: Flight[]): HTMLElement {
    const items = flights.slice(0, most_flights).map(({ from, to, sent_s, arrives_s, unheard }) => h('li', {},
      from === vehicle ? `to ${this.name(to)}` : `from ${this.name(from)}`,
      `, sent at ${fixed(sent_s, 2)} s, ${unheard ? 'not heard: the receiver transmits, or another message is in its way' : `there at ${fixed(arrives_s, 2)} s`}`));
    if (flights.length > most_flights) items.push(h('li', {}, `and ${flights.length - most_flights} more`));
    return h('section', {}, h('h3', {}, 'Messages under way ', h('small', {}, String(flights.length))), h('ul', {}, ...items));
  }
}

function echo_words({ time_s, echoes }: EchoesRecord): string {
  const ping = `Last ping at t = ${fixed(time_s, 2)} s: `;
  if (echoes.length === 0) return `${ping}no echo.`;
  const [range, bearing] = echoes.reduce((nearest, echo) => (echo[0] < nearest[0] ? echo : nearest));
  return `${ping}${echoes.length} ${echoes.length === 1 ? 'echo' : 'echoes'}, the nearest at ${fixed(range, 1)} m, ${bearing_words(bearing)}.`;
}
