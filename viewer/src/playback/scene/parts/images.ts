// SPDX-License-Identifier: Apache-2.0
// Pictures over velocities, lying about the vehicle that drew them.
import {
  DataTexture, DoubleSide, Group, LinearFilter, Mesh, MeshBasicMaterial, PlaneGeometry, SRGBColorSpace, Vector3, type BufferGeometry,
} from 'three';
import { from_base64 } from '../../film';
import { image_width, type ImageStroke as Image } from '../../model';

/** What is black is forbidden: it darkens what is below and hides it no more than it must. */
const alpha_of = (red: number, green: number, blue: number): number => (red + green + blue === 0 ? 90 : 215);

/** Rows from the top, as a texture has them from the bottom. */
function texture_of({ side, rgb }: Image): DataTexture {
  const bytes = from_base64(rgb);
  if (bytes.length !== 3 * side * side) throw new Error(`an image of ${side} x ${side} pixels has ${bytes.length} bytes`);
  const pixels = new Uint8Array(4 * side * side);
  for (let row = 0; row < side; ++row) {
    for (let column = 0; column < side; ++column) {
      const from = 3 * (row * side + column);
      const [red, green, blue] = [bytes[from]!, bytes[from + 1]!, bytes[from + 2]!];
      pixels.set([red, green, blue, alpha_of(red, green, blue)], 4 * ((side - 1 - row) * side + column));
    }
  }
  const texture = new DataTexture(pixels, side, side);
  texture.colorSpace = SRGBColorSpace;
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

export class Images {
  readonly object = new Group();
  private readonly lying: BufferGeometry = new PlaneGeometry(2, 2).rotateX(-Math.PI / 2);
  private shown = new Map<Image, Mesh<BufferGeometry, MeshBasicMaterial>>();
  private before = new Map<Image, Mesh<BufferGeometry, MeshBasicMaterial>>();

  constructor(private readonly render_order: number) {}

  begin(): void {
    this.before = this.shown;
    this.shown = new Map();
  }

  add(image: Image, at: Vector3, seconds: number): void {
    const mesh = this.before.get(image) ?? this.make(image);
    this.before.delete(image);
    this.shown.set(image, mesh);
    const half = (image_width(image) / 2) * seconds;
    mesh.position.copy(at);
    mesh.rotation.set(0, -image.yaw, 0);
    mesh.scale.set(half, 1, half);
  }

  end(): void {
    for (const mesh of this.before.values()) {
      this.object.remove(mesh);
      mesh.material.map?.dispose();
      mesh.material.dispose();
    }
    this.before.clear();
  }

  private make(image: Image): Mesh<BufferGeometry, MeshBasicMaterial> {
    const material = new MeshBasicMaterial({ map: texture_of(image), transparent: true, depthWrite: false, side: DoubleSide });
    const mesh = new Mesh(this.lying, material);
    mesh.renderOrder = this.render_order;
    this.object.add(mesh);
    return mesh;
  }
}
