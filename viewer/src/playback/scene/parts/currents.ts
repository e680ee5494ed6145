// SPDX-License-Identifier: Apache-2.0
// The current at its depths, on a coarse lattice; how fast it is stands beside it.
import { Vector3 } from 'three';
import type { Film } from '../../film';
import type { Scene } from '../../model';
import { place } from '../axes';
import { round_up, type Extent } from '../extent';
import { Arrows } from '../ink/arrows';
import type { Label } from '../labels';
import { Drawn, order, type Now } from '../part';

const most_depths = 5;
const per_side = 4;
const at = new Vector3();
const tip = new Vector3();
const flow = new Vector3();

export class Currents extends Drawn {
  private readonly arrows = this.ink(new Arrows(1.6, order.ghosts));
  private extent: Extent | null = null;
  private depths: number[] = [];
  private metres_per_mps = 1;
  private written: Label[] = [];

  constructor(private readonly scene: Scene, private readonly film: Film) {
    super();
  }

  set_extent(extent: Extent): void {
    this.extent = extent;
    this.depths = this.shown_depths();
    const spacing = Math.max(extent.frame.max.x - extent.frame.min.x, extent.frame.max.z - extent.frame.min.z) / per_side;
    this.metres_per_mps = (0.6 * spacing) / round_up(this.fastest());
  }

  /** Indices of the depths within the frame, thinned to a few; the nearest one where none is. */
  private shown_depths(): number[] {
    const { min, max } = this.extent!.frame;
    const all = this.scene.current_depths_m.map((_, k) => k);
    const inside = all.filter((k) => this.height(k) >= min.y - 1e-6 && this.height(k) <= Math.max(max.y, 0) + 1e-6);
    const outside = (k: number): number => Math.max(min.y - this.height(k), this.height(k) - max.y);
    const nearest = [...all].sort((a, b) => outside(a) - outside(b)).slice(0, 1);
    const some = inside.length > 0 ? inside : nearest;
    const step = Math.ceil(some.length / most_depths);
    return some.filter((_, i) => i % step === 0);
  }

  private height(k: number): number {
    return -this.scene.current_depths_m[k]!;
  }

  private flow_at(frame: number, k: number): Vector3 {
    return place(this.film.value('current_mps', frame, 0, 2 * k), this.film.value('current_mps', frame, 0, 2 * k + 1), 0, flow);
  }

  private fastest(): number {
    let fastest = 0.05;
    const step = Math.max(1, Math.floor(this.film.count / 100));
    for (let i = 0; i < this.film.count; i += step) {
      for (const k of this.depths) fastest = Math.max(fastest, this.flow_at(i, k).length());
    }
    return fastest;
  }

  protected draw(now: Now): void {
    const { min, max } = this.extent!.frame;
    this.written = [];
    if (this.film.count === 0) return;
    for (const k of this.depths) {
      const speed = this.flow_at(now.moment.index, k).length();
      const y = Math.min(Math.max(this.height(k), min.y), Math.max(max.y, 0));
      if (speed < 0.005) continue;
      for (let i = 0; i < per_side * per_side; ++i) {
        at.set(min.x + ((i % per_side) + 0.5) * (max.x - min.x) / per_side, y, min.z + (Math.floor(i / per_side) + 0.5) * (max.z - min.z) / per_side);
        tip.copy(at).addScaledVector(flow, this.metres_per_mps);
        this.arrows.add(at, tip, now.colours.water, 0.6);
      }
      const text = `current ${speed.toFixed(2)} m/s at ${-this.height(k)} m`;
      this.written.push({ text, at: this.corner(y), kind: 'scale', colour: '--water', rank: 25 });
    }
  }

  /** Of the lattice's first arrow. */
  private corner(y: number): Vector3 {
    const { min, max } = this.extent!.frame;
    return new Vector3(min.x + (0.5 / per_side) * (max.x - min.x), y, min.z + (0.5 / per_side) * (max.z - min.z));
  }

  labels(): Label[] {
    return this.written;
  }
}
