// SPDX-License-Identifier: Apache-2.0
// Names under the vehicles: all of a few; of many, those that are chosen, pointed at, followed or nearest.
import { Group, Vector3, type Camera } from 'three';
import { series_colour } from '../../../common/colour';
import type { Scene } from '../../model';
import type { Label } from '../labels';
import type { Now, Part } from '../part';

const few = 12;
const nearest_of_many = 5;

/** Under a hull as the camera sees it, that near ones are not written over. */
function below(at: Vector3, camera: Camera, by_m: number): Vector3 {
  return new Vector3(0, -1, 0).transformDirection(camera.matrixWorld).multiplyScalar(by_m).add(at);
}

export class Names implements Part {
  readonly object = new Group();
  hovered: number | null = null;
  followed = 0;
  private now: Now | null = null;

  constructor(private readonly scene: Scene) {}

  show(now: Now): void {
    this.now = now;
  }

  labels_from(camera: Camera): Label[] {
    const { now } = this;
    if (now === null || !this.object.visible) return [];
    const away = now.poses.positions.map((p) => p.distanceToSquared(camera.position));
    const by_distance = away.map((_, v) => v).sort((a, b) => away[a]! - away[b]!);
    const shown = new Set(by_distance.slice(0, this.scene.vehicles.length <= few ? few : nearest_of_many));
    for (const v of [...now.chosen, this.followed]) shown.add(v);
    if (this.hovered !== null) shown.add(this.hovered);
    const places = new Map(by_distance.map((v, place) => [v, place]));
    return [...shown].flatMap((v) => {
      const spec = this.scene.vehicles[v];
      if (spec === undefined) return [];
      const at = below(now.poses.positions[v]!, camera, 0.3 * spec.length_m);
      return [{ text: spec.name, at, kind: 'name' as const, colour: series_colour(v), rank: this.rank(v, places.get(v)!, now) }];
    });
  }

  private rank(vehicle: number, place: number, now: Now): number {
    if (vehicle === this.hovered) return 200;
    if (now.chosen.has(vehicle)) return now.chosen.size <= few ? 150 : 90;
    return (vehicle === this.followed ? 80 : 70) - place / this.scene.vehicles.length;
  }
}
