// SPDX-License-Identifier: Apache-2.0
// Flat translucent faces, all of them in one draw call.
import { BufferAttribute, BufferGeometry, DoubleSide, ShapeUtils, Vector2, type Color, type Vector3 } from 'three';
import { Instances, plain_fragment } from './instances';

/** Each corner takes its place from the attribute of which it is the unit. */
const corners = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 1]), 3));

const vertex = `
attribute vec3 a;
attribute vec3 b;
attribute vec3 c;
attribute vec4 tint;
varying vec4 v_tint;
void main() {
  v_tint = vec4(tint.rgb * tint.rgb, tint.a);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position.x * a + position.y * b + position.z * c, 1.0);
}`;

export class Faces extends Instances {
  constructor(render_order: number) {
    super(corners, [['a', 3], ['b', 3], ['c', 3]], render_order, { vertexShader: vertex, fragmentShader: plain_fragment, side: DoubleSide });
  }

  triangle(a: Vector3, b: Vector3, c: Vector3, colour: Color, alpha: number): void {
    this.put([...a, ...b, ...c], colour, alpha);
  }
  quad(a: Vector3, b: Vector3, c: Vector3, d: Vector3, colour: Color, alpha: number): void {
    this.triangle(a, b, c, colour, alpha);
    this.triangle(a, c, d, colour, alpha);
  }
  /** Of any simple outline that is not vertical. */
  polygon(outline: Vector3[], colour: Color, alpha: number): void {
    if (outline.length < 3) return;
    const seen_from_above = outline.map((p) => new Vector2(p.x, p.z));
    for (const [a, b, c] of ShapeUtils.triangulateShape(seen_from_above, [])) {
      this.triangle(outline[a!]!, outline[b!]!, outline[c!]!, colour, alpha);
    }
  }
  fan(centre: Vector3, outline: Vector3[], colour: Color, alpha: number): void {
    for (let i = 0; i + 1 < outline.length; ++i) this.triangle(centre, outline[i]!, outline[i + 1]!, colour, alpha);
  }
}
