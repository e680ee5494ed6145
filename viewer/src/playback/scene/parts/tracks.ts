// SPDX-License-Identifier: Apache-2.0
// Where a vehicle believes others to be, how fast, and how sure of it it is.
import { Group, Vector3 } from 'three';
import type { Film } from '../../film';
import { place_of } from '../axes';
import type { Extent } from '../extent';
import { Bubbles } from '../ink/bubbles';
import { Lines } from '../ink/lines';
import { order, type KeyLine, type Now, type Part } from '../part';

const at = new Vector3();
const led = new Vector3();

export class Tracks implements Part {
  readonly object = new Group();
  private readonly ghosts = new Bubbles({ fill: 0.03, rim: 0.5, circles: 0.45, hatch: 5 }, order.ghosts);
  private readonly halos = new Bubbles({ fill: 0, rim: 0.3, circles: 0 }, order.ghosts);
  private readonly velocities = new Lines(1.6, order.lines);
  private seconds = 5;
  private any = false;

  constructor(private readonly film: Film) {
    this.object.add(this.ghosts.object, this.halos.object, this.velocities.object);
  }

  set_extent(extent: Extent): void {
    this.seconds = extent.seconds;
  }

  show(now: Now): void {
    for (const ink of [this.ghosts, this.halos, this.velocities]) ink.clear();
    this.any = false;
    for (const vehicle of now.thinkers) {
      const colour = now.colours.vehicle(vehicle);
      for (const track of this.film.tracks.at(vehicle, now.moment.time)?.tracks ?? []) {
        this.any = true;
        place_of(track.position, at);
        this.ghosts.add(at, track.radius, colour, 0.8);
        if (track.sigma_m > 0) this.halos.add(at, track.radius + track.sigma_m, colour, 0.8);
        this.velocities.add(at, place_of(track.velocity, led).multiplyScalar(this.seconds).add(at), colour, 0.8);
      }
    }
    for (const ink of [this.ghosts, this.halos, this.velocities]) ink.commit();
  }

  key(): KeyLine[] {
    return this.any ? [{ colour: '--ink-3', text: 'ghosts: where it believes others to be, with one sigma' }] : [];
  }
}
