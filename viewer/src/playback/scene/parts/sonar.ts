// SPDX-License-Identifier: Apache-2.0
// The sonar's fan as it turns with the hull, and the echoes of the last ping where they were heard.
import { Vector3 } from 'three';
import { moment_at, type Film } from '../../film';
import type { Scene } from '../../model';
import { body } from '../axes';
import { Dots } from '../ink/dots';
import { Faces } from '../ink/faces';
import { Lines } from '../ink/lines';
import { Drawn, order, type Now } from '../part';
import { attitude_at, position_at } from '../poses';

const arcs = 24;

/** At a range, clockwise from ahead, above the plane of the hull; in body axes of the picture. */
function spot(range: number, bearing: number, elevation: number, out = new Vector3()): Vector3 {
  return body(range * Math.cos(bearing) * Math.cos(elevation), range * Math.sin(bearing) * Math.cos(elevation), range * Math.sin(elevation), out);
}

export class SonarFan extends Drawn {
  private readonly face = this.ink(new Faces(order.fans));
  private readonly edges = this.ink(new Lines(1, order.fans));
  private readonly echoes = this.ink(new Dots(order.dots));

  constructor(private readonly scene: Scene, private readonly film: Film) {
    super();
  }

  protected draw(now: Now): void {
    for (const vehicle of now.thinkers) {
      if (this.film.echoes.at(vehicle, now.moment.time) === null) continue;
      this.fan(vehicle, now);
      this.heard(vehicle, now);
    }
  }

  private fan(vehicle: number, now: Now): void {
    const { sonar } = this.scene;
    if (sonar === null) return;
    const { accent } = now.colours;
    const put = (v: Vector3): Vector3 => v.applyQuaternion(now.poses.attitudes[vehicle]!).add(now.poses.positions[vehicle]!);
    const arc = (range: number, elevation: number): Vector3[] =>
      Array.from({ length: arcs + 1 }, (_, k) => put(spot(range, sonar.half_field_rad * ((2 * k) / arcs - 1), elevation)));
    const near = arc(sonar.min_range_m, 0);
    const far = arc(sonar.max_range_m, 0);
    const rims = [far, near, arc(sonar.max_range_m, sonar.half_aperture_rad), arc(sonar.max_range_m, -sonar.half_aperture_rad)];
    for (let k = 0; k < arcs; ++k) {
      this.face.quad(near[k]!, near[k + 1]!, far[k + 1]!, far[k]!, accent, 0.06);
      for (const rim of rims) this.edges.add(rim[k]!, rim[k + 1]!, accent, 0.5);
    }
    for (const k of [0, arcs]) {
      this.edges.add(near[k]!, far[k]!, accent, 0.5);
      this.edges.add(rims[2]![k]!, rims[3]![k]!, accent, 0.5);
    }
  }

  private heard(vehicle: number, now: Now): void {
    const record = this.film.echoes.at(vehicle, now.moment.time)!;
    const then = moment_at(this.film, record.time_s);
    const from = position_at(this.film, then, vehicle);
    const turned = attitude_at(this.film, then, vehicle);
    for (const [range, bearing] of record.echoes) {
      this.echoes.add(spot(range, bearing, 0).applyQuaternion(turned).add(from), 'disc', 7, now.colours.of('--sign-detected'), 0.95);
    }
  }
}
