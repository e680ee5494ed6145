// SPDX-License-Identifier: Apache-2.0
// The picture in three dimensions: what the page asks of it.
import type { Film, Moment } from '../film';
import type { Scene, Vec3 } from '../model';

export const cameras = ['orbit', 'follow', 'top', 'side'] as const;
export type CameraKind = (typeof cameras)[number];
export const layers = [
  'trails', 'spheres', 'goals', 'obstacles', 'grid', 'surface', 'current', 'sketch', 'tracks', 'sonar', 'messages', 'names',
] as const;
export type Layer = (typeof layers)[number];

export interface StageView {
  /** Shows the film at a moment; vehicles lie between frames, colours are those of the frame at or before it. */
  show(moment: Moment): void;
  /** Chosen vehicles stand out; sketches, tracks and the sonar are those of the chosen ones. None: all alike. */
  choose(vehicles: ReadonlySet<number>): void;
  /** The vehicle that the camera keeps to. */
  follow(vehicle: number): void;
  set_camera(kind: CameraKind): void;
  set_layer(layer: Layer, shown: boolean): void;
  /** Fits everything that happens into the picture again. */
  fit(): void;
  /** Colours follow the page's theme. */
  restyle(): void;
  /** Where a vehicle is in the picture [px], for tests and labels; null behind the camera. */
  place_of(vehicle: number): { x: number; y: number } | null;
  /** Likewise any place. */
  point_of(place: Vec3): { x: number; y: number } | null;
  /** The place under a point of the picture [px] that is as deep as `at`; with `depth`, the one above or below `at`. Null: none. */
  place_under(x: number, y: number, at: Vec3, depth: boolean): Vec3 | null;
  /** Hears of every picture. */
  on_draw(listener: () => void): void;
  on_pick(listener: (vehicle: number | null, adding: boolean) => void): void;
  /** A picture of what is shown, PNG. */
  picture(): Promise<Blob>;
  readonly frames_per_second: number;
}

/** Makes the picture inside `host` and keeps to its size. Throws where the browser has no WebGL. */
export type MakeStage = (host: HTMLElement, scene: Scene, film: Film) => StageView;
