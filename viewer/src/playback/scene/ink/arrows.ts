// SPDX-License-Identifier: Apache-2.0
// Arrows: a line some pixels wide and a cone, two draw calls for all of them.
import { ConeGeometry, Group, Quaternion, Vector3, type Color } from 'three';
import { Instances, plain_fragment, type Ink } from './instances';
import { Lines } from './lines';

const vertex = `
attribute vec3 tip;
attribute vec4 turn;
attribute float reach;
attribute vec4 tint;
uniform vec2 size;
uniform float ratio;
varying vec4 v_tint;
void main() {
  vec4 end = modelViewMatrix * vec4(tip, 1.0);
  float pixels_per_metre = projectionMatrix[1][1] * 0.5 * size.y / ratio / max((projectionMatrix * end).w, 1e-3);
  // Seen from anywhere a head has the size of a letter, but a short arrow a smaller one.
  float head = min(0.4 * reach, clamp(0.3 * reach, 9.0 / pixels_per_metre, 15.0 / pixels_per_metre));
  vec3 local = head * position;
  vec3 turned = local + 2.0 * cross(turn.xyz, cross(turn.xyz, local) + turn.w * local);
  v_tint = vec4(tint.rgb * tint.rgb, tint.a);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(tip + turned, 1.0);
}`;
const up = new Vector3(0, 1, 0);
const along = new Vector3();
const neck = new Vector3();
const turn = new Quaternion();

export class Arrows implements Ink {
  readonly object = new Group();
  private readonly shafts: Lines;
  private readonly heads: Instances;

  constructor(width_px: number, render_order: number) {
    this.shafts = new Lines(width_px, render_order);
    const cone = new ConeGeometry(0.3, 1, 20).translate(0, -0.5, 0);
    this.heads = new Instances(cone, [['tip', 3], ['turn', 4], ['reach', 1]], render_order, { vertexShader: vertex, fragmentShader: plain_fragment });
    this.object.add(this.shafts.object, this.heads.object);
  }

  clear(): void {
    this.shafts.clear();
    this.heads.clear();
  }
  add(from: Vector3, to: Vector3, colour: Color, alpha = 1): void {
    along.subVectors(to, from);
    const length = along.length();
    if (length < 1e-4) return;
    turn.setFromUnitVectors(up, along.divideScalar(length));
    // The line ends within the head, so that it does not blunt the tip.
    this.shafts.add(from, neck.copy(to).addScaledVector(along, -0.04 * length), colour, alpha);
    this.heads.put([...to, ...turn, length], colour, alpha);
  }
  commit(): void {
    this.shafts.commit();
    this.heads.commit();
  }
}
