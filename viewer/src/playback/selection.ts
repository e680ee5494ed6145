// SPDX-License-Identifier: Apache-2.0
// What the reader chose to see: vehicles, camera, layers. Tells the picture, and whoever listens.
import type { CameraKind, Layer, StageView } from './scene/stage_view';
import { layers } from './scene/stage_view';

export class Selection {
  chosen: ReadonlySet<number> = new Set();
  followed = 0;
  camera: CameraKind = 'orbit';
  private readonly hidden = new Set<Layer>();
  private readonly listeners: (() => void)[] = [];

  constructor(private readonly stage: StageView, private readonly vehicles: number) {
    for (const layer of layers) stage.set_layer(layer, true);
    stage.set_camera(this.camera);
    stage.on_pick((vehicle, adding) => this.pick(vehicle, adding));
  }

  on_change(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** As a click does: alone, or `adding` to those chosen; again takes it out. On nothing: nobody. */
  pick(vehicle: number | null, adding: boolean): void {
    if (vehicle === null) {
      if (!adding) this.choose([]);
      return;
    }
    const chosen = new Set(adding ? this.chosen : []);
    if (this.chosen.has(vehicle) && (adding || this.chosen.size === 1)) chosen.delete(vehicle);
    else chosen.add(vehicle);
    this.choose(chosen);
  }

  choose(vehicles: Iterable<number>): void {
    this.chosen = new Set([...vehicles].filter((vehicle) => this.exists(vehicle)));
    this.stage.choose(this.chosen);
    this.tell();
  }

  /** Chooses it, and the camera goes along with it. */
  follow(vehicle: number): void {
    if (!this.exists(vehicle)) return;
    this.followed = vehicle;
    this.stage.follow(vehicle);
    this.choose([vehicle]);
    this.set_camera('follow');
  }

  set_camera(kind: CameraKind): void {
    if (kind === 'follow' && this.chosen.size > 0 && !this.chosen.has(this.followed)) {
      this.followed = [...this.chosen][0]!;
      this.stage.follow(this.followed);
    }
    this.camera = kind;
    this.stage.set_camera(kind);
    this.tell();
  }

  shows(layer: Layer): boolean {
    return !this.hidden.has(layer);
  }

  set_layer(layer: Layer, shown: boolean): void {
    if (shown) this.hidden.delete(layer);
    else this.hidden.add(layer);
    this.stage.set_layer(layer, shown);
    this.tell();
  }

  private exists(vehicle: number): boolean {
    return Number.isInteger(vehicle) && vehicle >= 0 && vehicle < this.vehicles;
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}
