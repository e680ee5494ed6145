// SPDX-License-Identifier: Apache-2.0
// The only place that knows both frames: the run's north-east-down and three.js' x = east, y = up, z = south.
import { Quaternion, Vector3 } from 'three';
import type { Vec3 } from '../model';

/** A point or direction [n, e, d] in the axes of the picture. */
export function place(n: number, e: number, d: number, out = new Vector3()): Vector3 {
  return out.set(e, -d, -n);
}

export function place_of(v: Vec3, out = new Vector3()): Vector3 {
  return place(v[0], v[1], v[2], out);
}

/** The rotation of q_nb (w x y z) for models that look along -z with starboard along +x. */
export function turn(w: number, x: number, y: number, z: number, out = new Quaternion()): Quaternion {
  return out.set(y, -z, -x, w).normalize();
}

/** Forward, starboard and up of a body, in the axes of its model. */
export function body(forward: number, starboard: number, up: number, out = new Vector3()): Vector3 {
  return out.set(starboard, up, -forward);
}
