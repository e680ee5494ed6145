// SPDX-License-Identifier: Apache-2.0
// What vehicles drew when they decided. Velocities are drawn about the vehicle, where they lead in a stated time.
import { Vector3 } from 'three';
import type { Film } from '../../film';
import type { SketchRecord, Stroke, Vec3 } from '../../model';
import { meaning_colour } from '../../meaning_colour';
import { place, place_of } from '../axes';
import { Arrows } from '../ink/arrows';
import { Dots } from '../ink/dots';
import { Faces } from '../ink/faces';
import { Lines } from '../ink/lines';
import type { Extent } from '../extent';
import type { Label } from '../labels';
import { Drawn, order, type KeyLine, type Now } from '../part';
import { vector_at } from '../poses';
import { Images } from './images';

/** More velocities of one meaning than these are dots, not arrows. */
const most_arrows = 6;
const circle_points = 40;

const a = new Vector3();
const b = new Vector3();

/** What the key says for one of several neighbours. */
const of_all = (meaning: string): string => meaning.replace(/ (vehicle|contact|drifter) \d+$/, ' each $1');

/** Two directions across `normal`, the first level. */
function across(normal: Vector3): [Vector3, Vector3] {
  const level = new Vector3(-normal.z, 0, normal.x);
  if (level.lengthSq() < 1e-9) level.set(1, 0, 0);
  level.normalize();
  return [level, new Vector3().crossVectors(normal, level).normalize()];
}

function circle(centre: Vector3, u: Vector3, v: Vector3, radius: number): Vector3[] {
  return Array.from({ length: circle_points + 1 }, (_, k) => {
    const angle = (2 * Math.PI * k) / circle_points;
    return centre.clone().addScaledVector(u, radius * Math.cos(angle)).addScaledVector(v, radius * Math.sin(angle));
  });
}

/** Where a stroke stands among those of its decision. */
interface Among {
  many: boolean;
  first: boolean;
  first_image: boolean;
}

export class Sketches extends Drawn {
  private readonly lines = this.ink(new Lines(1.6, order.sketch));
  private readonly thin = this.ink(new Lines(1, order.sketch));
  private readonly faces = this.ink(new Faces(order.sketch));
  private readonly dots = this.ink(new Dots(order.sketch));
  private readonly images = new Images(order.fans);
  private readonly arrows = this.ink(new Arrows(2.4, order.sketch));
  private seconds = 5;
  private plane_radius = 1;
  private written: Label[] = [];
  private meanings = new Map<string, string>();
  private velocities = false;
  /** What stands on the page: nothing is built again while it and the place of the vehicle are the same. */
  private shown = '';

  constructor(private readonly film: Film) {
    super();
    this.object.add(this.images.object);
  }

  set_extent(extent: Extent): void {
    this.seconds = extent.seconds;
    this.plane_radius = 0.3 * extent.step;
    this.shown = '';
  }

  override show(now: Now): void {
    const shown = [now.moment.time, now.colours.deep.getHex(), this.film.count, this.film.generation, ...now.thinkers].join();
    if (shown === this.shown) return;
    this.shown = shown;
    super.show(now);
  }

  protected draw(now: Now): void {
    this.images.begin();
    this.written = [];
    this.meanings = new Map();
    this.velocities = false;
    for (const vehicle of now.thinkers) this.draw_vehicle(vehicle, this.film.sketches.at(vehicle, now.moment.time), now);
    this.images.end();
  }

  private draw_vehicle(vehicle: number, record: SketchRecord | null, now: Now): void {
    if (this.film.count === 0) return;
    const at = now.poses.positions[vehicle]!;
    const is_chosen = now.chosen.has(vehicle);
    if (record !== null || is_chosen) this.arrow(at, vector_at(this.film, 'velocity_mps', now.moment.index, vehicle, a), 'velocity', now, true);
    if (record === null) {
      if (is_chosen) this.arrow(at, vector_at(this.film, 'command_mps', now.moment.index, vehicle, a), 'command', now, true);
      return;
    }
    const counts = new Map<string, number>();
    for (const s of record.strokes) counts.set(s.meaning, (counts.get(s.meaning) ?? 0) + 1);
    const named = new Set<string>();
    let imaged = false;
    for (const stroke of record.strokes) {
      const many = counts.get(stroke.meaning)! > most_arrows;
      this.draw_stroke(stroke, at, { many, first: !named.has(stroke.meaning), first_image: !imaged }, now);
      named.add(stroke.meaning);
      imaged ||= stroke.kind === 'image';
    }
  }

  private draw_stroke(stroke: Stroke, at: Vector3, { many, first, first_image }: Among, now: Now): void {
    const name = meaning_colour(stroke.meaning);
    const colour = now.colours.of(name);
    // The first of several images lies in the scene; the plane of velocities beside it has them all.
    if (stroke.kind === 'image' && !first_image) return;
    if (stroke.kind !== 'velocity') this.meanings.set(of_all(stroke.meaning), name);
    switch (stroke.kind) {
      case 'velocity': {
        if (!many) return this.arrow(at, place_of(stroke.points[0], a), stroke.meaning, now, first);
        this.meanings.set(stroke.meaning, name);
        this.velocities = true;
        return this.dots.add(this.led(at, place_of(stroke.points[0], a)), 'disc', 5, colour, 0.8);
      }
      case 'half_space': return this.plane(at, stroke.points, colour);
      case 'region': return this.region(at, stroke.points, colour);
      case 'path': return this.polyline(stroke.points.map((p) => place_of(p, new Vector3())), this.lines, colour, 0.95);
      case 'tree':
        for (let k = 0; k + 1 < stroke.points.length; k += 2) this.thin.add(place_of(stroke.points[k]!, a), place_of(stroke.points[k + 1]!, b), colour, 0.35);
        return;
      case 'sphere': return this.wire(place_of(stroke.points[0], new Vector3()), stroke.radius, colour);
      case 'image':
        this.velocities = true;
        return this.images.add(stroke, at, this.seconds);
    }
  }

  /** Where a velocity leads. */
  private led(at: Vector3, velocity: Vector3): Vector3 {
    this.velocities = true;
    return at.clone().addScaledVector(velocity, this.seconds);
  }

  private arrow(at: Vector3, velocity: Vector3, meaning: string, now: Now, first: boolean): void {
    const name = meaning_colour(meaning);
    const tip = this.led(at, velocity);
    this.meanings.set(meaning, name);
    this.arrows.add(at, tip, now.colours.of(name), meaning === 'velocity' ? 0.6 : 0.95);
    if (first && meaning !== 'velocity') this.written.push({ text: meaning, at: tip, kind: 'meaning', colour: name, rank: 40, beside_px: 7 });
  }

  private plane(at: Vector3, [point, direction]: readonly [Vec3, Vec3], colour: Now['colours']['ink']): void {
    const centre = this.led(at, place_of(point, a));
    const normal = place_of(direction, new Vector3()).normalize();
    const [u, v] = across(normal);
    const outline = circle(centre, u, v, this.plane_radius);
    this.faces.fan(centre, outline, colour, 0.16);
    this.polyline(outline, this.thin, colour, 0.8);
    // The tick stands on the side of the velocities that are allowed.
    this.lines.add(centre, b.copy(centre).addScaledVector(normal, 0.45 * this.plane_radius), colour);
  }

  private region(at: Vector3, outline: readonly Vec3[], colour: Now['colours']['ink']): void {
    const points = outline.map((v) => this.led(at, place_of(v, a)));
    if (points.length === 0) return;
    this.faces.polygon(points, colour, 0.22);
    this.polyline([...points, points[0]!], this.thin, colour, 0.9);
  }

  private polyline(points: Vector3[], ink: Lines, colour: Now['colours']['ink'], alpha: number): void {
    for (let k = 0; k + 1 < points.length; ++k) ink.add(points[k]!, points[k + 1]!, colour, alpha);
  }

  private wire(centre: Vector3, radius: number, colour: Now['colours']['ink']): void {
    const axes = [place(1, 0, 0), place(0, 1, 0), place(0, 0, 1)] as const;
    for (let k = 0; k < 3; ++k) this.polyline(circle(centre, axes[k]!, axes[(k + 1) % 3]!, radius), this.thin, colour, 0.7);
  }

  labels(): Label[] {
    return this.written;
  }

  key(): KeyLine[] {
    const lines = [...this.meanings].map(([text, colour]) => ({ colour, text }));
    return this.velocities ? [...lines, { colour: '', text: `velocities: where they lead in ${this.seconds} s` }] : lines;
  }
}
