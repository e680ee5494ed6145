// SPDX-License-Identifier: Apache-2.0
// The spheres by which the metric judges: two outer ones touch where it counts a detection, two inner ones a collision.
import type { Film } from '../../film';
import type { Scene } from '../../model';
import { Bubbles } from '../ink/bubbles';
import { Drawn, order, type Now } from '../part';

export class Alerts extends Drawn {
  private readonly outer: Bubbles;
  private readonly inner: Bubbles;

  constructor(private readonly scene: Scene, private readonly film: Film) {
    super();
    // Many outer ones overlap: the more there are, the fainter.
    const faint = Math.min(1, Math.sqrt(4 / Math.max(1, film.vehicles)));
    this.outer = this.ink(new Bubbles({ fill: 0.03 * faint, rim: 0.26 * faint, circles: 0.36 * faint }, order.outer, film.vehicles));
    this.inner = this.ink(new Bubbles({ fill: 0.1, rim: 0.5, circles: 0.65 }, order.inner, film.vehicles));
  }

  protected draw(now: Now): void {
    const { crit_dist_m, safety_distance_m } = this.scene.exam;
    for (let v = 0; v < this.film.vehicles && this.film.count > 0; ++v) {
      const at = now.poses.positions[v]!;
      const alert = this.film.value('alert', now.moment.index, v);
      const colour = now.colours.alerts[alert] ?? now.colours.alerts[0];
      const shown = now.chosen.size === 0 || now.chosen.has(v) ? 1 : 0.55;
      this.outer.add(at, crit_dist_m / 2, colour, shown);
      this.inner.add(at, safety_distance_m / 2, colour, shown);
    }
  }
}
