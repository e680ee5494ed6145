// SPDX-License-Identifier: Apache-2.0
import { csv_text } from '../common/csv';
import type { Film } from './film';
import { alerts, modes, phases, progresses, shortfalls, type ColumnSpec, type Scene } from './model';

const headings: Record<string, string[]> = {
  position_m: ['n_m', 'e_m', 'd_m'],
  attitude: ['q_w', 'q_x', 'q_y', 'q_z'],
  velocity_mps: ['v_n_mps', 'v_e_mps', 'v_d_mps'],
  command_mps: ['command_n_mps', 'command_e_mps', 'command_d_mps'],
  goal_m: ['goal_n_m', 'goal_e_m', 'goal_d_m'],
  force_n: ['surge_n', 'sway_n', 'heave_n'],
};
const names: Record<string, readonly string[]> = { mode: modes, phase: phases, alert: alerts, shortfall: shortfalls, progress: progresses };

/** The shortest text that reads as the same number again, for single precision too. */
function exact(value: number, single: boolean): string {
  if (single) {
    for (let digits = 6; digits <= 9; ++digits) {
      const short = Number(value.toPrecision(digits));
      if (Math.fround(short) === value) return String(short);
    }
  }
  return String(value);
}

function headings_of({ name, width }: ColumnSpec): string[] {
  if (width === 1) return [name];
  return headings[name] ?? Array.from({ length: width }, (_, k) => `${name}_${k}`);
}

/** The film, a line per frame and vehicle, with full precision. */
export function frames_csv(scene: Scene, columns: ColumnSpec[], film: Film): string {
  const shown = columns.filter(({ per }) => per === 'vehicle');
  const rows: (string | number)[][] = [['time_s', 'vehicle', 'name', ...shown.flatMap(headings_of)]];
  for (let i = 0; i < film.count; ++i) {
    for (let vehicle = 0; vehicle < film.vehicles; ++vehicle) {
      const fields: (string | number)[] = [film.time(i), vehicle, scene.vehicles[vehicle]!.name];
      for (const { name, width, type } of shown) {
        for (let k = 0; k < width; ++k) {
          const value = film.value(name, i, vehicle, k);
          fields.push(names[name]?.[value] ?? exact(value, type === 'f32'));
        }
      }
      rows.push(fields);
    }
  }
  return csv_text(rows);
}
