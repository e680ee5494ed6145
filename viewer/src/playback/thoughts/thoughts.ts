// SPDX-License-Identifier: Apache-2.0
// What a vehicle thought when it decided: the plane of velocities, and what it knew.
import './thoughts.css';
import { h, slug } from '../../common/dom';
import { fixed } from '../../common/format';
import { action_button, save_text } from '../../common/save';
import { hide_tip, show_tip } from '../../common/tooltip';
import type { Film, Moment } from '../film';
import type { ImageStroke, Scene, SketchRecord, Stroke } from '../model';
import type { Panel } from '../panel';
import { entries_of, meaning_key, told, Wanted } from './key';
import { commanded, Meanings, own_velocity } from './meanings';
import { Perceived } from './perceived';
import { draw_plane, velocity_words, type Plane, type Spot } from './plane';
import { planes_svg } from './saved';
import { horizontal_slice, round_reach, vertical_slice, type Slice } from './slice';

const redraw_every_ms = 60;
const largest_plane = 440;
const saved_size = 420;
const side_by_side = 560;
const pick_range = 14;

/** All that one decision has in its planes. */
interface Decision {
  record: SketchRecord;
  strokes: Stroke[];
  horizontal: Slice;
  /** Where anything goes up or down. */
  vertical: Slice | null;
  reach: number;
  down: number;
}

class Thoughts implements Panel {
  readonly element = h('div', { class: 'thoughts' });
  private readonly title = h('h3', {});
  private readonly when = h('span', { class: 'when' });
  private readonly planes = h('div', { class: 'planes' });
  private readonly key = h('div', {});
  private readonly elsewhere = h('p', { class: 'elsewhere' });
  private readonly hint = h('p', { class: 'hint' });
  private readonly drawn = h('div', {});
  private readonly perceived: Perceived;
  private readonly meanings: Meanings;
  private readonly wanted: Wanted;
  private vehicle: number | null;
  private record: SketchRecord | null = null;
  private time = 0;
  private width = 0;
  private drawn_at = -Infinity;
  private perceived_at = -Infinity;
  private pending = 0;

  constructor(private readonly scene: Scene, private readonly film: Film) {
    this.perceived = new Perceived(scene, film);
    this.meanings = new Meanings(scene.vehicles);
    this.wanted = new Wanted(this.meanings);
    this.vehicle = scene.vehicles.length === 1 ? 0 : null;
    const save = action_button('SVG', 'Save the planes of velocities as SVG', 'saved', () => this.save());
    this.drawn.append(h('div', { class: 'thoughts-head' }, this.when, h('span', { class: 'panel-actions' }, save)),
      this.planes, this.key, this.elsewhere);
    this.element.append(this.title, this.hint, this.drawn, this.perceived.element);
    this.planes.addEventListener('pointerleave', hide_tip);
    new ResizeObserver(() => {
      if (this.title.clientWidth !== this.width) this.restyle();
    }).observe(this.element);
  }

  show({ time }: Moment): void {
    this.time = time;
    if (this.width === 0 || this.pending !== 0) return;
    const now = performance.now();
    const record = this.standing();
    const wait = Math.min(record === this.record ? Infinity : this.drawn_at + redraw_every_ms - now,
      this.perceived_at + 4 * redraw_every_ms - now);
    if (wait <= 0) this.update(record);
    // What is skipped while the run rushes past is caught up with when it stops.
    else if (wait < Infinity) this.pending = window.setTimeout(() => {
      this.pending = 0;
      this.update(this.standing());
    }, wait);
  }

  choose(vehicles: ReadonlySet<number>): void {
    const [first] = vehicles;
    this.vehicle = first ?? (this.scene.vehicles.length === 1 ? 0 : null);
    this.perceived.forget();
    this.restyle();
  }

  grown(): void {
    const record = this.standing();
    if (record === null || record !== this.record) this.restyle();
  }

  restyle(): void {
    this.width = this.title.clientWidth;
    if (this.width > 0) this.draw(this.standing());
  }

  /** The decision that stands at the moment. */
  private standing(): SketchRecord | null {
    return this.vehicle === null ? null : this.film.sketches.at(this.vehicle, this.time);
  }

  private update(record: SketchRecord | null): void {
    if (record !== this.record) this.draw(record);
    this.perceived_at = performance.now();
    if (this.vehicle !== null) this.perceived.show(this.vehicle, this.time);
  }

  private draw(record: SketchRecord | null): void {
    this.record = record;
    this.drawn_at = performance.now();
    hide_tip();
    const spec = this.vehicle === null ? undefined : this.scene.vehicles[this.vehicle];
    this.title.replaceChildren(spec === undefined ? 'Thoughts' : spec.name, h('small', {}, spec === undefined ? '' : ` ${spec.avoider}`));
    this.drawn.hidden = record === null;
    this.hint.hidden = record !== null;
    if (record === null) this.hint.replaceChildren(...this.advice());
    else this.draw_decision(this.decision(record));
    if (this.vehicle !== null) this.perceived.show(this.vehicle, this.time);
  }

  private advice(): (Node | string)[] {
    if (!this.film.sketches.any) {
      return ['What the vehicles thought was not kept in this film. ', h('code', {}, 'fairway run --sketch'),
        ' keeps it while a run is recorded, ', h('code', {}, 'fairway view --sketch'), ' asks the decisions of a recording again.'];
    }
    if (this.vehicle === null) return ['Choose a vehicle to see which velocities it weighed.'];
    return ['It has drawn nothing up to this moment: it has not decided yet, or nobody was near.'];
  }

  private decision(record: SketchRecord): Decision {
    const i = this.film.index_at(record.time_s);
    const velocity = this.film.vector('velocity_mps', i, record.vehicle);
    const command = this.film.vector('command_mps', i, record.vehicle);
    const strokes: Stroke[] = [{ kind: 'velocity', meaning: own_velocity, points: [velocity] }, ...record.strokes,
      { kind: 'velocity', meaning: commanded, points: [command] }];
    const velocities = strokes.flatMap((stroke) => (stroke.kind === 'velocity' ? stroke.points : []));
    const chosen = strokes.flatMap((stroke) => (stroke.kind === 'velocity' && stroke.meaning === 'chosen' ? stroke.points : []))
      .at(-1) ?? command;
    const speeds = velocities.map((v) => Math.hypot(...v));
    const images = strokes.filter((stroke) => stroke.kind === 'image').map(({ reach }) => reach);
    // A method of the plane draws nothing upwards, whatever the vehicle itself does.
    const is_steep = record.strokes.some((stroke) => (stroke.kind === 'half_space' && Math.abs(stroke.points[1][2]) > 1e-3) ||
      (stroke.kind === 'velocity' && Math.abs(stroke.points[0][2]) > 0.01 * Math.max(...speeds)));
    const along = Math.hypot(chosen[0], chosen[1]) > 1e-3 ? chosen : velocity;
    return {
      record, strokes, down: chosen[2],
      horizontal: horizontal_slice(chosen[2]),
      vertical: is_steep ? vertical_slice(Math.atan2(along[1], along[0]), chosen) : null,
      reach: round_reach(Math.max(1.15 * Math.max(...speeds), ...images)),
    };
  }

  private draw_decision(decision: Decision): void {
    const { record, strokes } = decision;
    const { plane, picture } = entries_of(strokes, this.meanings);
    this.when.replaceChildren(`decided at t = ${fixed(record.time_s, 2)} s`);
    const beside = decision.vertical !== null && this.width >= side_by_side;
    const size = Math.floor(Math.min(this.width, largest_plane, beside ? this.width * 0.62 : Infinity));
    const small = Math.floor(beside ? Math.min(this.width - size - 16, size * 0.72) : Math.min(size, 260));
    const shown = strokes.filter((stroke) => this.wanted.shows(stroke, plane));
    this.planes.replaceChildren(...this.parts(decision, shown, size, small).map(({ drawn, caption }) => {
      const host = h('div', { class: 'plane-host' }, drawn.svg);
      host.addEventListener('pointermove', (event) => point_at(drawn, host, event));
      return h('figure', {}, host, h('figcaption', {}, caption));
    }));
    this.key.replaceChildren(meaning_key(plane, this.wanted, () => this.restyle()));
    this.elsewhere.textContent = record.strokes.length === 0 ? 'It drew nothing in this decision.'
      : picture.length === 0 ? '' : `In the picture: ${picture.map(told).join(', ')}.`;
  }

  private parts({ horizontal, vertical, reach, down }: Decision, shown: readonly Stroke[], size: number, small: number):
      { drawn: Plane; caption: string }[] {
    const image = shown.find((stroke): stroke is ImageStroke => stroke.kind === 'image') ?? null;
    const forbidden = shown.some(({ kind }) => kind === 'half_space' || kind === 'region') ? '; shaded ones are forbidden' : '';
    const level = Math.abs(down) < 5e-4 ? '' : `, all at ${fixed(Math.abs(down), 2)} m/s ${down > 0 ? 'down' : 'up'}`;
    const parts = [{
      drawn: draw_plane(shown, { slice: horizontal, reach, size, up: 'north', right: 'east', regions: true, meanings: this.meanings, image }),
      caption: vertical === null ? `Horizontal velocities${image === null ? '' : ` over their ${image.meaning}`}${forbidden}.`
        : `Horizontal cut through the chosen velocity${level}${forbidden}.`,
    }];
    if (vertical === null) return parts;
    return [...parts, {
      drawn: draw_plane(shown, { slice: vertical, reach, size: small, up: 'up', right: 'on course', regions: false, meanings: this.meanings, image: null }),
      caption: 'Vertical cut through the chosen velocity, along its course.',
    }];
  }

  private save(): boolean {
    if (this.record === null) return false;
    const decision = this.decision(this.record);
    const { plane } = entries_of(decision.strokes, this.meanings);
    const entries = plane.filter((entry) => this.wanted.shows(entry, plane));
    const shown = decision.strokes.filter((stroke) => this.wanted.shows(stroke, plane));
    const parts = this.parts(decision, shown, saved_size, 0.72 * saved_size);
    const name = this.scene.vehicles[decision.record.vehicle]!.name;
    const title = `${name}, decided at t = ${fixed(decision.record.time_s, 2)} s`;
    save_text(`${slug(`${name} ${decision.record.time_s}`)}.svg`, 'image/svg+xml',
      planes_svg(title, parts.map(({ drawn, caption }) => ({ svg: drawn.svg, caption })), entries));
    return true;
  }
}

/** Says which velocity is under the pointer. */
function point_at({ spots }: Plane, host: HTMLElement, event: PointerEvent): void {
  const frame = host.getBoundingClientRect();
  const away = (spot: Spot): number => Math.hypot(spot.x - event.clientX + frame.left, spot.y - event.clientY + frame.top);
  const nearest = spots.reduce<Spot | null>((best, spot) => (best === null || away(spot) < away(best) ? spot : best), null);
  if (nearest === null || away(nearest) > pick_range) hide_tip();
  else show_tip({ title: nearest.meaning, rows: velocity_words(nearest.velocity) }, event.clientX, event.clientY);
}

/** The plane of velocities and what was known, of the chosen vehicle. */
export function make_thoughts(scene: Scene, film: Film): Panel {
  return new Thoughts(scene, film);
}
