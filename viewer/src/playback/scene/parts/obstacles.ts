// SPDX-License-Identifier: Apache-2.0
// Spheres that stay or drift, walls and prisms; hatched where no chart shows them.
import { Group, Vector3 } from 'three';
import type { Obstacle, Scene } from '../../model';
import { place_of } from '../axes';
import type { Extent } from '../extent';
import { Bubbles } from '../ink/bubbles';
import { Faces } from '../ink/faces';
import { Lines } from '../ink/lines';
import { order, type Now, type Part } from '../part';

const at = new Vector3();

export class Obstacles implements Part {
  readonly object = new Group();
  private readonly charted = new Bubbles({ fill: 0.62, rim: 0.3, circles: 0.85 }, order.walls);
  private readonly uncharted = new Bubbles({ fill: 0.5, rim: 0.35, circles: 0.7, hatch: 9 }, order.walls);
  private readonly walls = new Faces(order.walls);
  private readonly edges = new Lines(1.4, order.walls);

  constructor(private readonly scene: Scene) {
    this.object.add(this.charted.object, this.uncharted.object, this.walls.object, this.edges.object);
  }

  show(now: Now): void {
    this.charted.clear();
    this.uncharted.clear();
    for (const o of this.scene.obstacles) {
      if (o.kind !== 'sphere') continue;
      const [n, e, d] = o.position.map((x, k) => x + o.velocity[k]! * now.moment.time);
      place_of([n!, e!, d!], at);
      (o.charted ? this.charted : this.uncharted).add(at, o.radius, now.colours.ink_3);
    }
    this.charted.commit();
    this.uncharted.commit();
  }

  /** What reaches through every depth: from the top of the frame to its bottom. */
  restyle(colours: Now['colours'], extent: Extent): void {
    this.walls.clear();
    this.edges.clear();
    const top = extent.surface ? Math.max(0, extent.frame.max.y - extent.depth_step) : extent.frame.max.y;
    const span: [number, number] = [extent.frame.min.y, top];
    for (const o of this.scene.obstacles) {
      if (o.kind === 'segment') this.wall([o.from, o.to], false, o, span, colours);
      if (o.kind === 'polygon') this.wall(o.vertices, true, o, span, colours);
    }
    this.walls.commit();
    this.edges.commit();
  }

  private wall(points: Obstacle['vertices'], closed: boolean, o: Obstacle, [bottom, top]: [number, number], colours: Now['colours']): void {
    const alpha = o.charted ? 0.3 : 0.13;
    const high = points.map((p) => place_of(p, new Vector3()).setY(top));
    const low = high.map((p) => p.clone().setY(bottom));
    const sides = closed ? points.length : points.length - 1;
    for (let i = 0; i < sides; ++i) {
      const j = (i + 1) % points.length;
      this.walls.quad(low[i]!, low[j]!, high[j]!, high[i]!, colours.ink_3, alpha);
      for (const ring of [low, high]) this.edges.add(ring[i]!, ring[j]!, colours.ink_3, 3 * alpha);
    }
    high.forEach((p, i) => this.edges.add(p, low[i]!, colours.ink_3, 2.4 * alpha));
    if (closed) this.walls.polygon(high, colours.ink_3, 0.8 * alpha);
  }
}
