// SPDX-License-Identifier: Apache-2.0
// What is drawn anew at every moment: meshes of one entry per instance that grow by doubling, so that a picture of many things is
// one draw call.
import {
  DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial, Vector2,
  type BufferGeometry, type Color, type Object3D, type ShaderMaterialParameters,
} from 'three';

/** Everything of one kind that a part draws: `clear`, then whatever there is, then `commit`, which shows it. */
export interface Ink {
  readonly object: Object3D;
  clear(): void;
  commit(): void;
}

/** The drawing buffer's size and pixel ratio, shared by everything that is measured in pixels. */
export const viewport = { size: { value: new Vector2(1, 1) }, ratio: { value: 1 } };

/** Of a shader whose colour needs nothing but `v_tint`. */
export const plain_fragment = `
varying vec4 v_tint;
void main() {
  gl_FragColor = v_tint;
  #include <colorspace_fragment>
}`;

interface Field {
  name: string;
  width: number;
  attribute: InstancedBufferAttribute;
}

function tint_bytes(colour: Color, alpha: number, out: Uint8Array, at: number): void {
  // Linear bytes would show bands in dark colours; the square root is undone in the shaders.
  out[at] = Math.round(255 * Math.sqrt(colour.r));
  out[at + 1] = Math.round(255 * Math.sqrt(colour.g));
  out[at + 2] = Math.round(255 * Math.sqrt(colour.b));
  out[at + 3] = Math.round(255 * Math.min(Math.max(alpha, 0), 1));
}

/** Translucent instances of `shape`: floats by name, and a colour with opacity called `tint` (colour as its square root). */
export class Instances implements Ink {
  readonly object: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  count = 0;
  private capacity = 0;
  private readonly fields: Field[] = [];

  constructor(shape: BufferGeometry, private readonly widths: readonly (readonly [string, number])[], render_order: number,
              { uniforms, ...material }: ShaderMaterialParameters, capacity = 64) {
    this.object = new Mesh(new InstancedBufferGeometry(),
      new ShaderMaterial({ transparent: true, depthWrite: false, ...material, uniforms: { ...viewport, ...uniforms } }));
    this.object.frustumCulled = false;
    this.object.renderOrder = render_order;
    this.geometry.setAttribute('position', shape.getAttribute('position'));
    this.geometry.setIndex(shape.getIndex());
    this.reserve(capacity);
    this.geometry.instanceCount = 0;
  }

  clear(): void {
    this.count = 0;
  }

  /** Adds an instance: its floats in the order of the widths. */
  put(floats: readonly number[], colour: Color, alpha: number): void {
    if (this.count === this.capacity) this.reserve(2 * this.capacity);
    let k = 0;
    for (const { width, attribute } of this.fields) {
      const array = attribute.array as Float32Array;
      for (let i = 0; i < width; ++i) array[this.count * width + i] = floats[k++]!;
    }
    tint_bytes(colour, alpha, this.tint.array as Uint8Array, 4 * this.count);
    ++this.count;
  }

  tint_at(i: number, colour: Color, alpha: number): void {
    tint_bytes(colour, alpha, this.tint.array as Uint8Array, 4 * i);
  }

  commit(): void {
    this.geometry.instanceCount = this.count;
    for (const { attribute } of this.fields) attribute.needsUpdate = true;
    this.commit_tint();
  }

  commit_tint(): void {
    this.tint.needsUpdate = true;
  }

  private get geometry(): InstancedBufferGeometry {
    return this.object.geometry;
  }

  private get tint(): InstancedBufferAttribute {
    return this.geometry.getAttribute('tint') as InstancedBufferAttribute;
  }

  private reserve(capacity: number): void {
    const old_tint = this.capacity > 0 ? (this.tint.array as Uint8Array) : null;
    const old = this.fields.splice(0);
    if (this.capacity > 0) this.geometry.dispose();
    this.capacity = capacity;
    this.widths.forEach(([name, width], k) => {
      const array = new Float32Array(capacity * width);
      if (old[k]) array.set(old[k].attribute.array as Float32Array);
      const attribute = new InstancedBufferAttribute(array, width).setUsage(DynamicDrawUsage);
      this.fields.push({ name, width, attribute });
      this.geometry.setAttribute(name, attribute);
    });
    const tints = new Uint8Array(4 * capacity);
    if (old_tint) tints.set(old_tint);
    this.geometry.setAttribute('tint', new InstancedBufferAttribute(tints, 4, true).setUsage(DynamicDrawUsage));
  }
}
