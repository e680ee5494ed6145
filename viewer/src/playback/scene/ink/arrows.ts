// SPDX-License-Identifier: Apache-2.0
// Arrows: a line some pixels wide and a cone, two draw calls for all of them.
import { ConeGeometry, Group, Mesh, Quaternion, ShaderMaterial, Vector3, type Color } from 'three';
import { Instances } from './instances';
import { Lines } from './lines';

const vertex = `
attribute vec3 tip;
attribute vec4 turn;
attribute float size;
attribute vec4 tint;
varying vec4 v_tint;
void main() {
  vec3 local = size * position;
  vec3 turned = local + 2.0 * cross(turn.xyz, cross(turn.xyz, local) + turn.w * local);
  v_tint = vec4(tint.rgb * tint.rgb, tint.a);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(tip + turned, 1.0);
}`;
const fragment = `
varying vec4 v_tint;
void main() {
  gl_FragColor = v_tint;
  #include <colorspace_fragment>
}`;

const up = new Vector3(0, 1, 0);
const along = new Vector3();
const neck = new Vector3();
const turn = new Quaternion();

export class Arrows {
  readonly object = new Group();
  private readonly shafts: Lines;
  private readonly heads: Instances;
  private readonly cones: Mesh<Instances['geometry'], ShaderMaterial>;

  /** Heads are as long as `head_m`, but never more than half of their arrow. */
  constructor(width_px: number, private readonly head_m: number, render_order: number) {
    this.shafts = new Lines(width_px, render_order);
    const cone = new ConeGeometry(0.3, 1, 14).translate(0, -0.5, 0);
    this.heads = new Instances(cone, [['tip', 3], ['turn', 4], ['size', 1]]);
    const material = new ShaderMaterial({ vertexShader: vertex, fragmentShader: fragment, transparent: true, depthWrite: false });
    this.cones = new Mesh(this.heads.geometry, material);
    this.cones.frustumCulled = false;
    this.cones.renderOrder = render_order;
    this.object.add(this.shafts.object, this.cones);
  }

  dispose(): void {
    this.shafts.dispose();
    this.cones.geometry.dispose();
    this.cones.material.dispose();
  }

  clear(): void {
    this.shafts.clear();
    this.heads.clear();
  }
  add(from: Vector3, to: Vector3, colour: Color, alpha = 1): void {
    along.subVectors(to, from);
    const length = along.length();
    if (length < 1e-4) return;
    const head = Math.min(this.head_m, 0.5 * length);
    turn.setFromUnitVectors(up, along.divideScalar(length));
    this.shafts.add(from, neck.copy(to).addScaledVector(along, -head), colour, alpha);
    this.heads.add([to.x, to.y, to.z, turn.x, turn.y, turn.z, turn.w, head], colour, alpha);
  }
  commit(): void {
    this.shafts.commit();
    this.heads.commit();
  }
}
