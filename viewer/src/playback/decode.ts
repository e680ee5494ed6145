// SPDX-License-Identifier: Apache-2.0
// The document from JSON text. Whatever is not as model.ts says throws DataError with the key that is wrong.
import { DataError, Reader } from '../common/reader';
import type {
  ColumnSpec, ColumnType, Document, EventKind, Explanation, Obstacle, Part, RunEvent, Scene, Shape, Vec2, Vec3, VehicleSpec, Wave,
} from './model';

const shapes: readonly Shape[] = ['auv', 'torpedo', 'rov', 'transport', 'catamaran', 'point'];
const event_kinds: readonly EventKind[] = ['detected', 'collision', 'avoided', 'collided', 'arrived', 'stuck'];
const most_vehicles = 10_000;
const largest_count = Number.MAX_SAFE_INTEGER;

// What the page draws with; a film may have further columns.
const needed: Record<string, { type: ColumnType; per: ColumnSpec['per']; width: number }> = {
  time_s: { type: 'f64', per: 'frame', width: 1 },
  position_m: { type: 'f64', per: 'vehicle', width: 3 },
  attitude: { type: 'f32', per: 'vehicle', width: 4 },
  velocity_mps: { type: 'f32', per: 'vehicle', width: 3 },
  command_mps: { type: 'f32', per: 'vehicle', width: 3 },
  goal_m: { type: 'f32', per: 'vehicle', width: 3 },
  force_n: { type: 'f32', per: 'vehicle', width: 3 },
  power_w: { type: 'f32', per: 'vehicle', width: 1 },
  mode: { type: 'u8', per: 'vehicle', width: 1 },
  phase: { type: 'u8', per: 'vehicle', width: 1 },
  alert: { type: 'u8', per: 'vehicle', width: 1 },
  shortfall: { type: 'u8', per: 'vehicle', width: 1 },
  progress: { type: 'u8', per: 'vehicle', width: 1 },
  no_progress_s: { type: 'f32', per: 'vehicle', width: 1 },
  progress_with: { type: 'f32', per: 'vehicle', width: 1 },
};

function positive(at: Reader): number {
  const value = at.number();
  return value > 0 ? value : at.fail('a number above 0');
}

function vec3(at: Reader): Vec3 {
  const [n, e, d] = at.list_for(3, 'coordinates', (entry) => entry.number());
  return [n!, e!, d!];
}

function vec2(at: Reader): Vec2 {
  const [n, e] = at.list_for(2, 'coordinates', (entry) => entry.number());
  return [n!, e!];
}

function vehicle(at: Reader): VehicleSpec {
  return {
    id: at.at('id').whole_number(0, largest_count),
    name: at.at('name').text(),
    model: at.at('model').text(),
    avoider: at.at('avoider').text(),
    shape: at.at('shape').one_of(shapes),
    length_m: positive(at.at('length_m')),
    beam_m: positive(at.at('beam_m')),
    radius_m: at.at('radius_m').number(),
    cooperative: at.at('cooperative').flag(),
    parts: at.at('parts').list((part) => ({
      x_m: part.at('x_m').number(), y_m: part.at('y_m').number(), z_m: part.at('z_m').number(), yaw_rad: part.at('yaw_rad').number(),
    })),
  };
}

function obstacle(at: Reader): Obstacle {
  return {
    kind: at.at('kind').one_of(['sphere', 'segment', 'polygon']),
    charted: at.at('charted').flag(),
    position: vec3(at.at('position')),
    radius: at.at('radius').number(),
    velocity: vec3(at.at('velocity')),
    from: vec3(at.at('from')),
    to: vec3(at.at('to')),
    vertices: at.at('vertices').list(vec3),
  };
}

function wave(at: Reader): Wave {
  return {
    amplitude_m: at.at('amplitude_m').number(),
    frequency_radps: at.at('frequency_radps').number(),
    number_radpm: at.at('number_radpm').number(),
    phase_rad: at.at('phase_rad').number(),
    direction: vec2(at.at('direction')),
  };
}

function sonar(at: Reader): Scene['sonar'] {
  if (at.absent) return null;
  return {
    min_range_m: at.at('min_range_m').number(),
    max_range_m: positive(at.at('max_range_m')),
    half_field_rad: at.at('half_field_rad').number(),
    half_aperture_rad: at.at('half_aperture_rad').number(),
  };
}

function scene(at: Reader): Scene {
  const vehicles = at.at('vehicles').list(vehicle);
  if (vehicles.length === 0 || vehicles.length > most_vehicles) at.at('vehicles').fail(`1 to ${most_vehicles} vehicles`);
  const exam = at.at('exam');
  return {
    vehicles,
    obstacles: at.at('obstacles').list(obstacle),
    exam: { crit_dist_m: exam.at('crit_dist_m').number(), safety_distance_m: exam.at('safety_distance_m').number() },
    waves: at.at('waves').list(wave),
    current_depths_m: at.at('current_depths_m').list((entry) => entry.number()),
    sonar: sonar(at.at('sonar')),
  };
}

function columns(at: Reader, depths: number): ColumnSpec[] {
  const found = at.list((entry): ColumnSpec => ({
    name: entry.at('name').text(),
    type: entry.at('type').one_of(['f64', 'f32', 'u8']),
    per: entry.at('per').one_of(['frame', 'vehicle']),
    width: entry.at('width').whole_number(0, 1000),
  }));
  const wanted = depths === 0 ? needed : { ...needed, current_mps: { type: 'f32', per: 'frame', width: 2 * depths } as const };
  for (const [name, { type, per, width }] of Object.entries(wanted)) {
    const column = found.find((spec) => spec.name === name);
    if (column === undefined) throw new DataError(`${at.path}: the column ${name} is missing`);
    if (column.type !== type || column.per !== per || column.width !== width) {
      throw new DataError(`${at.path}: the column ${name} has ${column.width} ${column.type} per ${column.per}, expected ${width} ${type} per ${per}`);
    }
  }
  return found;
}

function event(at: Reader, vehicles: number): RunEvent {
  const other = at.at('other');
  return {
    time_s: at.at('time_s').number(),
    vehicle: at.at('vehicle').whole_number(0, vehicles - 1),
    other: other.absent ? null : other.whole_number(0, vehicles - 1),
    kind: at.at('kind').one_of(event_kinds),
  };
}

/** A stretch of the film; `at` may be null, as where a live run has nothing new. */
export function decode_part(at: Reader, vehicles: number): Part | null {
  if (at.absent) return null;
  return {
    first: at.at('first').whole_number(0, largest_count),
    count: at.at('count').whole_number(0, largest_count),
    stride: at.at('stride').whole_number(1, largest_count),
    generation: at.at('generation').whole_number(0, largest_count),
    data: at.at('data').text(),
    compression: at.at('compression').one_of(['none', 'zstd']),
    events: at.at('events').list((entry) => event(entry, vehicles)),
    thoughts: at.at('thoughts').text(''),
  };
}

function explanation(at: Reader, vehicles: number): Explanation | null {
  if (at.absent) return null;
  const table = (entry: Reader): Explanation['sections'][number]['table'] => {
    if (entry.absent) return null;
    const names = entry.at('columns').list((name) => name.text());
    const cell = (value: Reader): string | number => (typeof value.value === 'number' ? value.number() : value.text());
    return { columns: names, rows: entry.at('rows').list((row) => row.list_for(names.length, 'columns', cell)) };
  };
  return {
    vehicle: at.at('vehicle').whole_number(0, vehicles - 1),
    time_s: at.at('time_s').number(),
    headline: at.at('headline').text(),
    sections: at.at('sections').list((entry) => ({
      title: entry.at('title').text(), lines: entry.at('lines').list((line) => line.text()), table: table(entry.at('table')),
    })),
  };
}

/** Throws DataError with the first thing that keeps the document from being shown. */
export function decode(json: string): Document {
  const at = Reader.of_json(json);
  const title = at.at('title').text();
  const seen = scene(at.at('scene'));
  return {
    title,
    summary: at.at('summary').text(''),
    version: at.at('version').text(''),
    command: at.at('command').text(''),
    seed: at.at('seed').text(''),
    period_s: positive(at.at('period_s')),
    duration_s: at.at('duration_s').number(),
    scene: seen,
    columns: columns(at.at('columns'), seen.current_depths_m.length),
    film: decode_part(at.at('film'), seen.vehicles.length),
    notice: at.at('notice').text(''),
    divergence: at.at('divergence').text(''),
    explanation: explanation(at.at('explanation'), seen.vehicles.length),
  };
}
