// SPDX-License-Identifier: Apache-2.0
// The playback document, as C++ writes it and decode.ts reads it. viewer/README.md describes each key.
// Everything is in metres, seconds, radians and north-east-down; only scene/ turns it into what three.js draws.

export type Vec3 = readonly [n: number, e: number, d: number];
export type Vec2 = readonly [n: number, e: number];

export interface Document {
  title: string;
  summary: string;
  version: string;
  command: string;
  seed: string;
  /** Between frames of the run, not of the film. */
  period_s: number;
  /** Where the run ends at the latest. */
  duration_s: number;
  scene: Scene;
  columns: ColumnSpec[];
  /** Null on a live page, which asks for parts. */
  film: Part | null;
  notice: string;
  /** How the run broke behind its last frame, in a line; empty if it is whole. */
  divergence: string;
  explanation: Explanation | null;
}

export type Shape = 'auv' | 'torpedo' | 'rov' | 'transport' | 'catamaran' | 'point';
export interface VehicleSpec {
  id: number;
  name: string;
  model: string;
  avoider: string;
  shape: Shape;
  /** Of the hull, from bow to stern, and from side to side. */
  length_m: number;
  beam_m: number;
  /** Of the sphere that others keep clear of. */
  radius_m: number;
  cooperative: boolean;
  /** Of a composite vehicle: its hulls, in body axes. */
  parts: { x_m: number; y_m: number; z_m: number; yaw_rad: number }[];
}
export interface Obstacle {
  kind: 'sphere' | 'segment' | 'polygon';
  charted: boolean;
  position: Vec3;
  radius: number;
  /** Of a sphere that drifts. */
  velocity: Vec3;
  /** Of a segment. */
  from: Vec3;
  to: Vec3;
  /** Of a polygon, a vertical prism through every depth. */
  vertices: Vec3[];
}
/** Elevation A cos(k d.(n, e) - omega t + phase), upwards. */
export interface Wave {
  amplitude_m: number;
  frequency_radps: number;
  number_radpm: number;
  phase_rad: number;
  direction: Vec2;
}
export interface Scene {
  vehicles: VehicleSpec[];
  obstacles: Obstacle[];
  /** By the metric's rule: detected when centres are this near, collided when that near. */
  exam: { crit_dist_m: number; safety_distance_m: number };
  waves: Wave[];
  /** Where the currents of the column `current_mps` run; empty in still water. */
  current_depths_m: number[];
  sonar: { min_range_m: number; max_range_m: number; half_field_rad: number; half_aperture_rad: number } | null;
}

export type ColumnType = 'f64' | 'f32' | 'u8';
export interface ColumnSpec {
  name: string;
  type: ColumnType;
  /** One value of this width per frame, or per vehicle of a frame. */
  per: 'frame' | 'vehicle';
  width: number;
}

/** A stretch of the film: its frames, column after column, and what was thought, told and counted in it. */
export interface Part {
  first: number;
  count: number;
  stride: number;
  generation: number;
  /** Base64 of the columns' bytes, one after the other, little-endian. */
  data: string;
  compression: 'none' | 'zstd';
  events: RunEvent[];
  /** Base64 of `Thoughts` as JSON, or empty. */
  thoughts: string;
}

export type EventKind = 'detected' | 'collision' | 'avoided' | 'collided' | 'arrived' | 'stuck';
/** `detected` and `collision` begin, `avoided` and `collided` are counted as the neighbour leaves. */
export interface RunEvent {
  time_s: number;
  vehicle: number;
  other: number | null;
  kind: EventKind;
}

export interface Thoughts {
  sketches: SketchRecord[];
  tracks: TracksRecord[];
  echoes: EchoesRecord[];
  flights: Flight[];
}
/** All that a vehicle drew when it decided; it stands until its next record. `time_s` ascends. */
export interface SketchRecord {
  time_s: number;
  vehicle: number;
  strokes: Stroke[];
}
export type Stroke =
  | { kind: 'velocity'; meaning: string; points: [Vec3] }
  | { kind: 'half_space'; meaning: string; points: [point: Vec3, normal: Vec3] }
  | { kind: 'region'; meaning: string; points: Vec3[] }
  | { kind: 'path'; meaning: string; points: Vec3[] }
  | { kind: 'tree'; meaning: string; points: Vec3[] }
  | { kind: 'sphere'; meaning: string; points: [Vec3]; radius: number }
  | { kind: 'image'; meaning: string; side: number; reach: number; yaw: number; /** Base64, 3 bytes a pixel. */ rgb: string };
export type ImageStroke = Extract<Stroke, { kind: 'image' }>;
/** Between the outer edges of an image [m/s]: `reach` is that of the outermost pixels' middles. */
export function image_width({ side, reach }: ImageStroke): number {
  return side > 1 ? (2 * reach * side) / (side - 1) : 2 * reach;
}
/** What a vehicle knows of others: stands until its next record. */
export interface TracksRecord {
  time_s: number;
  vehicle: number;
  tracks: { id: number; position: Vec3; velocity: Vec3; radius: number; age_s: number; sigma_m: number; reacts: boolean }[];
}
/** Of one ping: range and bearing in the plane of the hull, clockwise from ahead. */
export interface EchoesRecord {
  time_s: number;
  vehicle: number;
  echoes: (readonly [range_m: number, bearing_rad: number])[];
}
/** A message on its way: indices of vehicles; sound leaves at sent_s and has all arrived at arrives_s. */
export interface Flight {
  from: number;
  to: number;
  sent_s: number;
  begins_s: number;
  arrives_s: number;
  drowned: boolean;
}

/** Why one decision was made, as `fairway explain` found it. */
export interface Explanation {
  vehicle: number;
  time_s: number;
  headline: string;
  sections: { title: string; lines: string[]; table: { columns: string[]; rows: (string | number)[][] } | null }[];
}

export const modes = ['cruise', 'avoid', 'hold', 'infeasible'] as const;
export const phases = ['deploying', 'waiting', 'under_way', 'stuck', 'arrived'] as const;
/** As the metric sees a vehicle: nobody near; somebody detected; a collision, until that one has left. */
export const alerts = ['clear', 'detected', 'collided'] as const;
/** Whether a vehicle gets on, judged over a window of time. */
export const progresses = ['making', 'holding', 'waiting', 'deadlocked', 'trapped'] as const;
/** What of a command is beyond the vehicle. */
export const shortfalls = ['none', 'too_slow', 'astern', 'sideways'] as const;
