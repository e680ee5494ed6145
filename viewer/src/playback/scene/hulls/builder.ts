// SPDX-License-Identifier: Apache-2.0
// A hull from primitives, in the body's forward, starboard and up. Its accents take the colour of the vehicle.
import {
  BoxGeometry, BufferAttribute, Color, CylinderGeometry, LatheGeometry, Quaternion, TorusGeometry, Vector2, Vector3, type BufferGeometry,
} from 'three';
import { mergeGeometries } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import { body } from '../axes';

export interface Hull {
  /** With a colour per vertex. */
  painted: BufferGeometry;
  accent: BufferGeometry;
}

const paint = { yellow: '#f0bd27', black: '#333c45', grey: '#8d99a3', pale: '#dfe4e7', orange: '#e8833a', brass: '#b98e3f' } as const;
export type Paint = keyof typeof paint | 'accent';

/** Forward, starboard, up [m]. */
export type Place = readonly [forward: number, starboard: number, up: number];
const up = new Vector3(0, 1, 0);

export class HullBuilder {
  private readonly painted: BufferGeometry[] = [];
  private readonly accent: BufferGeometry[] = [];
  /** Where the next primitives belong: for vehicles put together from several. */
  private readonly shift = new Vector3();
  private yaw = 0;

  /** Further primitives are placed in a part at `at`, turned to starboard. */
  in_part(at: Place, yaw_rad: number): this {
    body(...at, this.shift);
    this.yaw = yaw_rad;
    return this;
  }

  /** Turned about the axis ahead: pairs of [forward, radius] from stern to bow. */
  turned(colour: Paint, profile: (readonly [number, number])[], at: Place = [0, 0, 0], sides = 20): this {
    const points = profile.map(([forward, radius]) => new Vector2(Math.max(radius, 1e-4), forward));
    return this.put(colour, new LatheGeometry(points, sides).rotateX(-Math.PI / 2), at);
  }

  box(colour: Paint, size: Place, at: Place, roll = 0): this {
    return this.put(colour, new BoxGeometry(size[1], size[2], size[0]).rotateZ(-roll), at);
  }

  /** Between two places. */
  rod(colour: Paint, from: Place, to: Place, radius: number, radius_to = radius, sides = 10): this {
    const a = body(...from);
    const b = body(...to);
    const along = b.clone().sub(a);
    const rod = new CylinderGeometry(radius_to, radius, along.length(), sides);
    rod.applyQuaternion(new Quaternion().setFromUnitVectors(up, along.normalize()));
    const middle = a.add(b).multiplyScalar(0.5);
    return this.put(colour, rod.translate(middle.x, middle.y, middle.z), [0, 0, 0]);
  }

  /** A ring about the axis ahead, or about the one upwards. */
  ring(colour: Paint, radius: number, thickness: number, at: Place, about: 'ahead' | 'up' = 'ahead'): this {
    const ring = new TorusGeometry(radius, thickness, 8, 24);
    return this.put(colour, about === 'up' ? ring.rotateX(Math.PI / 2) : ring, at);
  }

  /** A thruster in its duct, pushing ahead or upwards. */
  thruster(colour: Paint, radius: number, at: Place, about: 'ahead' | 'up' = 'ahead'): this {
    const half = 0.55 * radius;
    const end = (s: number): Place => (about === 'up' ? [at[0], at[1], at[2] + s * half] : [at[0] + s * half, at[1], at[2]]);
    return this.ring(colour, radius, 0.24 * radius, at, about).rod('black', end(-1.6), end(1), 0.3 * radius);
  }

  build(): Hull {
    const merged = (parts: BufferGeometry[]): BufferGeometry => mergeGeometries(parts, false);
    const hull = { painted: merged(this.painted), accent: merged(this.accent) };
    for (const part of [...this.painted, ...this.accent]) part.dispose();
    return hull;
  }

  private put(colour: Paint, geometry: BufferGeometry, at: Place): this {
    const offset = body(...at);
    geometry.translate(offset.x, offset.y, offset.z).rotateY(-this.yaw).translate(this.shift.x, this.shift.y, this.shift.z);
    const plain = geometry.index ? geometry.toNonIndexed() : geometry;
    plain.deleteAttribute('uv');
    if (colour === 'accent') {
      this.accent.push(plain);
      return this;
    }
    const { r, g, b } = new Color(paint[colour]);
    const count = plain.getAttribute('position').count;
    const colours = new Float32Array(3 * count);
    for (let i = 0; i < count; ++i) colours.set([r, g, b], 3 * i);
    plain.setAttribute('color', new BufferAttribute(colours, 3));
    this.painted.push(plain);
    return this;
  }
}
