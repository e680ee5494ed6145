// SPDX-License-Identifier: Apache-2.0
// The playback document, as C++ writes it: each part is declared by its reader, and its type follows. viewer/README.md describes
// each key. Everything is in metres, seconds, radians and north-east-down; only scene/ turns it into what three.js draws.
import {
  DataError, fail, flag, list, list_for, number, one_of, optional, or_null, pair, positive, read_json, record, text, triple, whole,
  type Of, type Read,
} from '../common/read';

export type Vec3 = readonly [n: number, e: number, d: number];
export type Vec2 = readonly [n: number, e: number];
const vec3: Read<Vec3> = triple;
const vec2: Read<Vec2> = pair('coordinates');

const shapes = ['auv', 'torpedo', 'rov', 'transport', 'catamaran', 'point'] as const;
export type Shape = (typeof shapes)[number];
const vehicle = record({
  id: whole(0),
  name: text,
  model: text,
  avoider: text,
  shape: one_of(shapes),
  /** Of the hull, from bow to stern, and from side to side. */
  length_m: positive,
  beam_m: positive,
  /** Of the sphere that others keep clear of. */
  radius_m: number,
  cooperative: flag,
  /** Of a composite vehicle: its hulls, in body axes. */
  parts: list(record({ x_m: number, y_m: number, z_m: number, yaw_rad: number })),
});
export type VehicleSpec = Of<typeof vehicle>;

const obstacle = record({
  kind: one_of(['sphere', 'segment', 'polygon']),
  charted: flag,
  position: vec3,
  radius: number,
  /** Of a sphere that drifts. */
  velocity: vec3,
  /** Of a segment. */
  from: vec3,
  to: vec3,
  /** Of a polygon, a vertical prism through every depth. */
  vertices: list(vec3),
});
export type Obstacle = Of<typeof obstacle>;

/** Elevation A cos(k d.(n, e) - omega t + phase), upwards. */
const wave = record({ amplitude_m: number, frequency_radps: number, number_radpm: number, phase_rad: number, direction: vec2 });
export type Wave = Of<typeof wave>;

const most_vehicles = 100_000;
const scene = record({
  vehicles: (value, path) => {
    const all = list(vehicle)(value, path);
    return all.length > 0 && all.length <= most_vehicles ? all : fail(value, path, `1 to ${most_vehicles} vehicles`);
  },
  obstacles: list(obstacle),
  /** By the metric's rule: detected when centres are this near, collided when that near. */
  exam: record({ crit_dist_m: number, safety_distance_m: number }),
  waves: list(wave),
  /** Where the currents of the column `current_mps` run; empty in still water. */
  current_depths_m: list(number),
  sonar: or_null(record({ min_range_m: number, max_range_m: positive, half_field_rad: number, half_aperture_rad: number })),
});
export type Scene = Of<typeof scene>;

/** One value of this width per frame, or per vehicle of a frame. */
const column = record({ name: text, type: one_of(['f64', 'f32', 'u8']), per: one_of(['frame', 'vehicle']), width: whole(0, 1000) });
export type ColumnSpec = Of<typeof column>;
export type ColumnType = ColumnSpec['type'];

// What the page draws with, a film may have further columns.
const needed: Record<string, string> = {
  time_s: '1 f64 per frame', position_m: '3 f64 per vehicle', attitude: '4 f32 per vehicle', velocity_mps: '3 f32 per vehicle',
  command_mps: '3 f32 per vehicle', goal_m: '3 f32 per vehicle', force_n: '3 f32 per vehicle', power_w: '1 f32 per vehicle',
  mode: '1 u8 per vehicle', phase: '1 u8 per vehicle', alert: '1 u8 per vehicle', shortfall: '1 u8 per vehicle',
  progress: '1 u8 per vehicle', no_progress_s: '1 f32 per vehicle', progress_with: '1 f32 per vehicle',
};

const columns = (depths: number): Read<ColumnSpec[]> => (value, path) => {
  const found = list(column)(value, path);
  const wanted = depths === 0 ? needed : { ...needed, current_mps: `${2 * depths} f32 per frame` };
  for (const [name, kind] of Object.entries(wanted)) {
    const spec = found.find((each) => each.name === name);
    if (spec === undefined) throw new DataError(`${path}: the column ${name} is missing`);
    const is = `${spec.width} ${spec.type} per ${spec.per}`;
    if (is !== kind) throw new DataError(`${path}: the column ${name} has ${is}, expected ${kind}`);
  }
  return found;
};

/** `detected` and `collision` begin, `avoided` and `collided` are counted as the neighbour leaves. */
const event = (vehicles: number) => record({
  time_s: number,
  vehicle: whole(0, vehicles - 1),
  other: or_null(whole(0, vehicles - 1)),
  kind: one_of(['detected', 'collision', 'avoided', 'collided', 'arrived', 'stuck']),
});
export type RunEvent = Of<ReturnType<typeof event>>;

/** A stretch of the film: its frames, column after column, and what was thought, told and counted in it. */
export const part = (vehicles: number) => record({
  first: whole(0),
  count: whole(0),
  stride: whole(1),
  generation: whole(0),
  /** The columns' bytes, one after the other, little-endian: themselves from a page around, else in base64. */
  data: (value, path) => (value instanceof Uint8Array ? value as Uint8Array<ArrayBuffer> : text(value, path)),
  compression: one_of(['none', 'zstd']),
  events: list(event(vehicles)),
  /** Base64 of `Thoughts` as JSON, or empty. */
  thoughts: optional(text, ''),
  /** They are from the beginning, and of those vehicles that think now: in place of all before. */
  thoughts_anew: optional(flag, false),
});
export type Part = Of<ReturnType<typeof part>>;

const table: Read<{ columns: string[]; rows: (string | number)[][] }> = (value, path) => {
  const { columns: names } = record({ columns: list(text) })(value, path);
  const cell: Read<string | number> = (entry, at) => (typeof entry === 'number' ? number : text)(entry, at);
  return { columns: names, ...record({ rows: list(list_for(names.length, 'columns', cell)) })(value, path) };
};
/** Why one decision was made, as `fairway explain` found it. */
const explanation = (vehicles: number) => record({
  vehicle: whole(0, vehicles - 1),
  time_s: number,
  headline: text,
  sections: list(record({ title: text, lines: list(text), table: or_null(table) })),
});
export type Explanation = Of<ReturnType<typeof explanation>>;

const document = ({ vehicles, current_depths_m: depths }: Scene) => record({
  title: text,
  summary: optional(text, ''),
  version: optional(text, ''),
  command: optional(text, ''),
  seed: optional(text, ''),
  /** Between frames of the run, not of the film. */
  period_s: positive,
  /** Where the run ends at the latest. */
  duration_s: number,
  scene,
  columns: columns(depths.length),
  /** Null on a live page, which asks for parts. */
  film: or_null(part(vehicles.length)),
  /** Whom a live page asks: the server that it came from, or the page around it. */
  live: optional(one_of(['server', 'page']), 'server'),
  /** Whether the page around it lets starts, goals and obstacles be moved. */
  movable: optional(flag, false),
  notice: optional(text, ''),
  /** How the run broke behind its last frame, in a line; empty if it is whole. */
  divergence: optional(text, ''),
  explanation: or_null(explanation(vehicles.length)),
});
export type Document = Of<ReturnType<typeof document>>;

/** Throws DataError with the first thing that keeps the document from being shown. */
export function decode(json: string): Document {
  return read_json(json, (value, path) => document(record({ scene })(value, path).scene)(value, path));
}

export interface Thoughts {
  sketches: SketchRecord[];
  tracks: TracksRecord[];
  echoes: EchoesRecord[];
  words: WordRecord[];
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
/** What a vehicle's method said of its own in a turn: it stands until the next one. Flights of its sender and `sent_s` are on their way with it. */
export interface WordRecord {
  time_s: number;
  vehicle: number;
  /** `text` is a line whose subject is who said it; `awaited` are those whose words that one waits for. */
  word: { sent_s: number; text: string; awaited: number[] };
}
/** A message on its way: indices of vehicles; sound leaves at sent_s and has all arrived at arrives_s. It is `unheard` where the receiver transmits
 *  meanwhile, or another message is in its way there. */
export interface Flight {
  from: number;
  to: number;
  sent_s: number;
  begins_s: number;
  arrives_s: number;
  unheard: boolean;
}

export const modes = ['cruise', 'avoid', 'hold', 'infeasible'] as const;
export const phases = ['deploying', 'waiting', 'under_way', 'stuck', 'arrived'] as const;
/** As the metric sees a vehicle: nobody near; somebody detected; a collision, until that one has left. */
export const alerts = ['clear', 'detected', 'collided'] as const;
/** Whether a vehicle gets on, judged over a window of time. */
export const progresses = ['making', 'holding', 'waiting', 'deadlocked', 'trapped'] as const;
/** What of a command is beyond the vehicle. */
export const shortfalls = ['none', 'too_slow', 'astern', 'sideways'] as const;
