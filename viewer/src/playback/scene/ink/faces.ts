// SPDX-License-Identifier: Apache-2.0
// Flat translucent faces, all of them in one draw call.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial, ShapeUtils, Vector2, Vector3, type Color } from 'three';

export class Faces {
  readonly object: Mesh<BufferGeometry, MeshBasicMaterial>;
  private points: number[] = [];
  private tints: number[] = [];

  constructor(render_order: number) {
    const material = new MeshBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false, side: DoubleSide });
    this.object = new Mesh(new BufferGeometry(), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = render_order;
    this.object.visible = false;
  }

  clear(): void {
    this.points = [];
    this.tints = [];
  }
  triangle(a: Vector3, b: Vector3, c: Vector3, colour: Color, alpha: number): void {
    for (const p of [a, b, c]) {
      this.points.push(p.x, p.y, p.z);
      this.tints.push(colour.r, colour.g, colour.b, alpha);
    }
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
  commit(): void {
    this.object.geometry.dispose();
    this.object.geometry = new BufferGeometry();
    this.object.visible = this.points.length > 0;
    if (!this.object.visible) return;
    this.object.geometry.setAttribute('position', new BufferAttribute(new Float32Array(this.points), 3));
    this.object.geometry.setAttribute('color', new BufferAttribute(new Float32Array(this.tints), 4));
  }
}
