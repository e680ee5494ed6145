// SPDX-License-Identifier: Apache-2.0
// Where each vehicle is bound for on its present leg.
import { Vector3 } from 'three';
import type { Film } from '../../film';
import { Dots } from '../ink/dots';
import { Lines } from '../ink/lines';
import { Drawn, order, type Now } from '../part';
import { vector_at } from '../poses';

const goal = new Vector3();

export class Goals extends Drawn {
  private readonly marks = this.ink(new Dots(order.dots));
  private readonly ways = this.ink(new Lines(1, order.lines));

  constructor(private readonly film: Film) {
    super();
  }

  protected draw(now: Now): void {
    for (let v = 0; v < this.film.vehicles && this.film.count > 0; ++v) {
      vector_at(this.film, 'goal_m', now.moment.index, v, goal);
      if (!Number.isFinite(goal.x + goal.y + goal.z)) continue;
      const colour = now.colours.vehicle(v);
      const stands_out = now.chosen.has(v);
      this.marks.add(goal, 'target', stands_out ? 20 : 15, colour, now.chosen.size === 0 || stands_out ? 0.95 : 0.4);
      if (stands_out) this.ways.add(now.poses.positions[v]!, goal, colour, 0.55);
    }
  }
}
