// SPDX-License-Identifier: Apache-2.0
// The frame of reference: a grid below everything, a depth scale in the corner that is out of the way, and plumb lines.
import { Group, Vector3, type Camera } from 'three';
import { round_up, type Extent } from '../extent';
import { Dots } from '../ink/dots';
import { Lines } from '../ink/lines';
import type { Label } from '../labels';
import { order, type Now, type Part } from '../part';

type Corner = readonly [x: number, z: number];

const a = new Vector3();
const b = new Vector3();

/** A number of metres as it is said: no more digits than the step needs. */
function metres(value: number, step: number): string {
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return (Math.abs(value) < step / 2 ? 0 : value).toFixed(digits).replace('-', '−');
}

export class DepthGrid implements Part {
  readonly object = new Group();
  private readonly grid = new Lines(1, order.grid);
  private readonly scale = new Lines(1.5, order.grid);
  private readonly plumb = new Lines(1, order.grid);
  private readonly feet = new Dots(order.grid);
  private extent: Extent | null = null;
  private corner = -1;
  private faced = '';
  private written: Label[] = [];
  private colours: Now['colours'] | null = null;

  constructor() {
    this.object.add(this.grid.object, this.scale.object, this.plumb.object, this.feet.object);
  }

  restyle(colours: Now['colours'], extent: Extent): void {
    this.extent = extent;
    this.colours = colours;
    this.corner = -1;
    this.faced = '';
    const { min, max } = extent.frame;
    this.grid.clear();
    for (let x = min.x; x <= max.x + 1e-6; x += extent.step) this.rule(x, min.z, x, max.z, Math.abs(x) < 1e-6);
    for (let z = min.z; z <= max.z + 1e-6; z += extent.step) this.rule(min.x, z, max.x, z, Math.abs(z) < 1e-6);
    this.grid.commit();
  }

  private rule(x0: number, z0: number, x1: number, z1: number, through_origin: boolean): void {
    const { y } = this.extent!.frame.min;
    this.grid.add(a.set(x0, y, z0), b.set(x1, y, z1), through_origin ? this.colours!.ink_3 : this.colours!.line, 0.8);
  }

  show(now: Now): void {
    const y = this.extent!.frame.min.y;
    this.plumb.clear();
    this.feet.clear();
    now.poses.positions.forEach((p, v) => {
      const stands_out = now.chosen.size === 0 || now.chosen.has(v);
      const colour = now.colours.vehicle(v);
      this.plumb.add(p, a.set(p.x, y, p.z), colour, stands_out ? 0.35 : 0.12);
      this.feet.add(a, 'disc', 6, colour, stands_out ? 0.5 : 0.2);
    });
    this.plumb.commit();
    this.feet.commit();
  }

  /** Puts the scale into the corner that the camera sees furthest to the left, and numbers along the edges near it. */
  face(camera: Camera): void {
    const { min, max } = this.extent!.frame;
    const corners = [[min.x, min.z], [max.x, min.z], [max.x, max.z], [min.x, max.z]] as const;
    const across = corners.map(([x, z]) => a.set(x, min.y, z).applyMatrix4(camera.matrixWorldInverse).x);
    let corner = across.indexOf(Math.min(...across));
    // Between two that are about as far to the left, it stays where it is.
    if (this.corner >= 0 && across[this.corner]! - across[corner]! < 0.02 * (max.x - min.x)) corner = this.corner;
    const back = a.setFromMatrixColumn(camera.matrixWorld, 2);
    // What is seen from its end would lie on one spot.
    const view = { x: back.x > 0.01 ? max.x : min.x, z: back.z > -0.01 ? max.z : min.z, scale: back.y < 0.995,
      east: Math.abs(back.z) > 0.02 || Math.abs(back.y) > 0.02, north: Math.abs(back.x) > 0.02 || Math.abs(back.y) > 0.02 };
    const faced = JSON.stringify([corner, view]);
    if (faced === this.faced) return;
    this.faced = faced;
    this.corner = corner;
    this.written = [];
    this.draw_scale(corners[corner]!, corners[(corner + 1) % 4]!, corners[(corner + 3) % 4]!, view.scale);
    this.write_edges(view);
  }

  private draw_scale([x, z]: Corner, one: Corner, other: Corner, numbered: boolean): void {
    const { frame: { min, max }, depth_step, surface, step } = this.extent!;
    const top = surface ? Math.min(0, max.y) : max.y;
    const { ink_3 } = this.colours!;
    this.scale.clear();
    this.scale.add(a.set(x, min.y, z), b.set(x, top, z), ink_3, 0.9);
    for (let y = Math.floor(top / depth_step + 1e-6) * depth_step; y >= min.y - 1e-6; y -= depth_step) {
      this.scale.add(a.set(x, y, z), b.set(x + 0.12 * Math.sign(one[0] + other[0] - 2 * x) * step, y, z), ink_3, 0.9);
      if (numbered) this.write(`${metres(-y, depth_step)} m`, a.set(x, y, z), 30, -6);
    }
    this.scale.commit();
  }

  private write_edges({ x: at_x, z: at_z, east, north }: { x: number; z: number; east: boolean; north: boolean }): void {
    const { frame: { min, max }, step } = this.extent!;
    const every = round_up(Math.max(max.x - min.x, max.z - min.z) / 6);
    const outside = (at: number, low: number, high: number): number => at + Math.sign(at - (low + high) / 2) * 0.2 * step;
    for (let x = Math.ceil(min.x / every) * every; east && x <= max.x + 1e-6; x += every) {
      this.write(`${metres(x, step)} m E`, a.set(x, min.y, outside(at_z, min.z, max.z)), 10);
    }
    for (let z = Math.ceil(min.z / every) * every; north && z <= max.z + 1e-6; z += every) {
      this.write(`${metres(-z, step)} m N`, a.set(outside(at_x, min.x, max.x), min.y, z), 9);
    }
  }

  private write(text: string, at: Vector3, rank: number, beside_px?: number): void {
    this.written.push({ text, at: at.clone(), kind: 'scale', rank, ...(beside_px === undefined ? {} : { beside_px }) });
  }

  labels(): Label[] {
    return this.written;
  }
}
