// SPDX-License-Identifier: Apache-2.0
// Where a vehicle believes others to be, how fast, and how sure of it it is.
import { Vector3 } from 'three';
import type { Film } from '../../film';
import { place_of } from '../axes';
import type { Extent } from '../extent';
import { Bubbles } from '../ink/bubbles';
import { Lines } from '../ink/lines';
import { Drawn, order, type KeyLine, type Now } from '../part';

const at = new Vector3();
const led = new Vector3();

export class Tracks extends Drawn {
  private readonly ghosts = this.ink(new Bubbles({ fill: 0.03, rim: 0.5, circles: 0.45, hatch: 5 }, order.ghosts));
  private readonly halos = this.ink(new Bubbles({ fill: 0, rim: 0.3, circles: 0 }, order.ghosts));
  private readonly velocities = this.ink(new Lines(1.6, order.lines));
  private seconds = 5;
  private any = false;

  constructor(private readonly film: Film) {
    super();
  }

  set_extent(extent: Extent): void {
    this.seconds = extent.seconds;
  }

  protected draw(now: Now): void {
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
  }

  key(): KeyLine[] {
    return this.any ? [{ colour: '--ink-3', text: 'ghosts: where it believes others to be, with one sigma' }] : [];
  }
}
