// SPDX-License-Identifier: Apache-2.0
// Which vehicle is meant by a click, a tap or the pointer's place.
import type { Camera, Vector3 } from 'three';
import { project } from './labels';

/** A finger is wider than a vehicle far away. */
const reach_px = 18;
/** A press that moves further than this turns the camera instead. */
const still_px = 6;

export interface Sight {
  camera: Camera;
  positions: readonly Vector3[];
  /** Half lengths of the hulls [m]. */
  radii: readonly number[];
  width: number;
  height: number;
}

/** The vehicle nearest to a point of the picture, among those within reach the one that is in front. */
export function vehicle_at(x: number, y: number, { camera, positions, radii, width, height }: Sight): number | null {
  let best: { vehicle: number; score: number } | null = null;
  positions.forEach((at, vehicle) => {
    const point = project(at, camera, width, height);
    if (point === null) return;
    const edge = project(at.clone().addScaledVector(at.clone().set(1, 0, 0).transformDirection(camera.matrixWorld), radii[vehicle]!), camera, width, height);
    const reach = Math.max(reach_px, edge ? Math.hypot(edge.x - point.x, edge.y - point.y) : 0);
    const away = Math.hypot(point.x - x, point.y - y);
    if (away > reach) return;
    const score = away / reach + point.depth;
    if (best === null || score < best.score) best = { vehicle, score };
  });
  return (best as { vehicle: number } | null)?.vehicle ?? null;
}

/** Tells presses that stay in place from those that move the camera. */
export function watch_pointer(canvas: HTMLElement, pressed: (x: number, y: number, adding: boolean) => void,
  moved: (x: number, y: number) => void): void {
  let down: { id: number; x: number; y: number } | null = null;
  const place = (event: PointerEvent): [number, number] => {
    const { left, top } = canvas.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  canvas.addEventListener('pointerdown', (event) => {
    // A second finger makes it a gesture.
    down = event.isPrimary && event.button === 0 ? { id: event.pointerId, x: event.clientX, y: event.clientY } : null;
  });
  canvas.addEventListener('pointerup', (event) => {
    if (down?.id === event.pointerId && Math.hypot(event.clientX - down.x, event.clientY - down.y) < still_px) {
      pressed(...place(event), event.shiftKey || event.ctrlKey || event.metaKey);
    }
    down = null;
  });
  canvas.addEventListener('pointermove', (event) => {
    if (event.pointerType === 'mouse' && event.buttons === 0) moved(...place(event));
  });
  canvas.addEventListener('pointerleave', () => moved(Number.NaN, Number.NaN));
}
