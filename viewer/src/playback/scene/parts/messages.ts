// SPDX-License-Identifier: Apache-2.0
// Messages under way: the stretch of water that the sound fills between the one who speaks and the one who hears.
// And of who stays where it is until it has heard others: a line to each of them.
import { Vector3 } from 'three';
import { first_index } from '../../../common/search';
import { moment_at, type Film } from '../../film';
import { modes, type Flight } from '../../model';
import { Dots } from '../ink/dots';
import { Lines } from '../ink/lines';
import { Drawn, order, type KeyLine, type Now } from '../part';
import { position_at } from '../poses';

/** Of more vehicles than these only the messages of the thinkers are shown. */
const most_vehicles = 12;
/** How far along the way to who is awaited the line is thick, which says from whom it is. */
const reach = 0.2;
const hold = modes.indexOf('hold');
const from = new Vector3();
const to = new Vector3();
const a = new Vector3();
const b = new Vector3();

export class Messages extends Drawn {
  private readonly ways = this.ink(new Lines(1, order.lines));
  private readonly pulses = this.ink(new Lines(3.2, order.lines));
  private readonly fronts = this.ink(new Dots(order.dots));
  private readonly waits = this.ink(new Lines(1, order.lines));
  private readonly waiters = this.ink(new Lines(2.6, order.lines));
  private any_waits = false;
  /** In the whole run, so that the key keeps still. */
  private any_heard = false;
  private any_unheard = false;
  /** By when they were sent; the longest tells how far back to look. */
  private ordered: Flight[] = [];
  private known = '';
  private longest_s = 0;

  constructor(private readonly film: Film) {
    super();
  }

  protected draw(now: Now): void {
    this.take_flights();
    const { time } = now.moment;
    const all = now.chosen.size === 0 && this.film.vehicles <= most_vehicles;
    this.draw_waits(now, all);
    const first = first_index(this.ordered.length, (i) => this.ordered[i]!.sent_s >= time - this.longest_s);
    for (let k = first; k < this.ordered.length && this.ordered[k]!.sent_s <= time; ++k) {
      const flight = this.ordered[k]!;
      if (time <= flight.arrives_s && (all || now.thinkers.includes(flight.from) || now.thinkers.includes(flight.to))) this.draw_flight(flight, now);
    }
  }

  key(): KeyLine[] {
    return [
      ...(this.any_heard ? [{ colour: '--accent', text: 'a message under way' }] : []),
      ...(this.any_unheard ? [{ colour: '--bad', text: 'one that is not heard: its receiver transmits, or another is in its way' }] : []),
      ...(this.any_waits ? [{ colour: '--ink-3', text: 'thin lines: from who waits to whose word it waits for, as it last said' }] : []),
    ];
  }

  private draw_waits(now: Now, all: boolean): void {
    this.any_waits = false;
    for (const vehicle of all ? Array(this.film.vehicles).keys() : now.thinkers) {
      const awaited = this.film.words.at(vehicle, now.moment.time)?.word.awaited ?? [];
      if (awaited.length === 0 || this.film.value('mode', now.moment.index, vehicle) !== hold) continue;
      this.any_waits = true;
      const colour = now.colours.vehicle(vehicle);
      position_at(this.film, now.moment, vehicle, from);
      for (const other of awaited) {
        position_at(this.film, now.moment, other, to);
        this.waits.add(from, to, colour, 0.45);
        this.waiters.add(from, a.lerpVectors(from, to, reach), colour, 0.8);
      }
    }
  }

  private take_flights(): void {
    const known = `${this.film.generation}/${this.film.flights.length}`;
    if (known === this.known) return;
    this.known = known;
    this.ordered = [...this.film.flights].sort((x, y) => x.sent_s - y.sent_s);
    this.any_heard = this.ordered.some((flight) => !flight.unheard);
    this.any_unheard = this.ordered.some((flight) => flight.unheard);
    this.longest_s = this.ordered.reduce((longest, f) => Math.max(longest, f.arrives_s - f.sent_s), 0);
  }

  private draw_flight(flight: Flight, now: Now): void {
    const { time } = now.moment;
    const colour = flight.unheard ? now.colours.bad : now.colours.accent;
    position_at(this.film, moment_at(this.film, flight.sent_s), flight.from, from);
    position_at(this.film, moment_at(this.film, flight.begins_s), flight.to, to);
    // The front travels for begins - sent; the end follows when all of it has been spoken.
    const travel = Math.max(flight.begins_s - flight.sent_s, 1e-6);
    const spoken = flight.arrives_s - flight.begins_s;
    const front = Math.min(1, (time - flight.sent_s) / travel);
    const end = Math.min(1, Math.max(0, (time - flight.sent_s - spoken) / travel));
    this.ways.add(from, to, colour, 0.28);
    this.pulses.add(a.lerpVectors(from, to, end), b.lerpVectors(from, to, front), colour, 0.85);
    this.fronts.add(b, flight.unheard ? 'ring' : 'disc', 8, colour);
  }
}
