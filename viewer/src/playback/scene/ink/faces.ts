// SPDX-License-Identifier: Apache-2.0
// Flat translucent faces, all of them in one draw call.
import {
  BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, Mesh, MeshBasicMaterial, ShapeUtils, Vector2, type Color, type Vector3,
} from 'three';

export class Faces {
  readonly object: Mesh<BufferGeometry, MeshBasicMaterial>;
  private capacity = 0;
  private count = 0;

  constructor(render_order: number) {
    const material = new MeshBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false, side: DoubleSide });
    this.object = new Mesh(new BufferGeometry(), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = render_order;
    this.reserve(96);
    this.commit();
  }

  clear(): void {
    this.count = 0;
  }
  triangle(a: Vector3, b: Vector3, c: Vector3, colour: Color, alpha: number): void {
    if (this.count + 3 > this.capacity) this.reserve(2 * this.capacity);
    for (const p of [a, b, c]) {
      this.attribute('position').setXYZ(this.count, p.x, p.y, p.z);
      this.attribute('color').setXYZW(this.count, colour.r, colour.g, colour.b, alpha);
      ++this.count;
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
  /** Sends what was added since `clear` to the next picture. */
  commit(): void {
    this.object.visible = this.count > 0;
    this.object.geometry.setDrawRange(0, this.count);
    for (const name of ['position', 'color'] as const) this.attribute(name).needsUpdate = true;
  }

  private attribute(name: 'position' | 'color'): BufferAttribute {
    return this.object.geometry.getAttribute(name) as BufferAttribute;
  }

  private reserve(capacity: number): void {
    const { geometry } = this.object;
    if (this.capacity > 0) geometry.dispose();
    for (const [name, width] of [['position', 3], ['color', 4]] as const) {
      const array = new Float32Array(capacity * width);
      if (this.capacity > 0) array.set(this.attribute(name).array as Float32Array);
      geometry.setAttribute(name, new BufferAttribute(array, width).setUsage(DynamicDrawUsage));
    }
    this.capacity = capacity;
  }
}
