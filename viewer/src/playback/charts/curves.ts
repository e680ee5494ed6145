// SPDX-License-Identifier: Apache-2.0
// What each chart shows: its curves, and how they are read off the frames of a film.
import type { Film } from '../film';
import { phases, type Scene } from '../model';

export type Look = 'full' | 'faint' | 'dashed' | 'dotted';
export interface Series {
  label: string;
  /** Whose colour it has. */
  vehicle: number;
  look: Look;
}
export interface Rule {
  label: string;
  value: number;
}
export interface Curves {
  /** What stands beside the vertical axis. */
  axis: string;
  note: string;
  series: Series[];
  rules: Rule[];
  /** Overwrites the values of frame i - 1 (not a number before the first) with those of frame i. */
  read(i: number, values: Float64Array): void;
}
/** Which vehicles the charts show; `alone` when the reader has chosen just one. */
export interface Shown {
  vehicles: number[];
  alone: number | null;
}
export interface ChartKind {
  key: 'separation' | 'speed' | 'heading' | 'depth' | 'force' | 'power';
  title: string;
  unit: string;
  /** Open until the reader decides. */
  open: boolean;
  /** Not offered while this column of the film is all zeros. */
  needs: string | null;
  curves(scene: Scene, film: Film, shown: Shown): Curves;
}

const degrees = 180 / Math.PI;

function one_each(scene: Scene, { vehicles }: Shown): Series[] {
  return vehicles.map((vehicle) => ({ label: scene.vehicles[vehicle]!.name, vehicle, look: 'full' }));
}

function distance2(places: Float64Array, a: number, b: number): number {
  const [i, j] = [3 * a, 3 * b];
  const north = places[i]! - places[j]!;
  const east = places[i + 1]! - places[j + 1]!;
  const down = places[i + 2]! - places[j + 2]!;
  return north * north + east * east + down * down;
}

const under_way = phases.indexOf('under_way');

/** Vehicles may start from one place: nobody is too near before it is under way. */
function has_set_out(film: Film, i: number, vehicle: number): boolean {
  return film.value('phase', i, vehicle) >= under_way;
}

function separation(scene: Scene, film: Film, shown: Shown): Curves {
  const count = scene.vehicles.length;
  const places = new Float64Array(3 * count);
  const locate = (i: number): void => {
    for (let k = 0; k < 3 * count; ++k) places[k] = film.value('position_m', i, 0, k);
  };
  const common = {
    axis: 'separation [m]',
    rules: [{ label: 'detected', value: scene.exam.crit_dist_m }, { label: 'collided', value: scene.exam.safety_distance_m }],
  };
  if (shown.alone !== null) {
    const own = shown.alone;
    const others = scene.vehicles.map((_, k) => k).filter((k) => k !== own);
    return {
      ...common,
      note: `from ${scene.vehicles[own]!.name} to each neighbour, once under way`,
      series: others.map((vehicle) => ({ label: scene.vehicles[vehicle]!.name, vehicle, look: 'full' })),
      read(i, values) {
        locate(i);
        others.forEach((other, k) => {
          values[k] = has_set_out(film, i, own) ? Math.sqrt(distance2(places, own, other)) : Number.NaN;
        });
      },
    };
  }
  return {
    ...common,
    note: 'of each vehicle from its nearest neighbour, once under way',
    series: count < 2 ? [] : one_each(scene, shown),
    read(i, values) {
      locate(i);
      values.forEach((_, k) => {
        const own = shown.vehicles[k]!;
        let least = Infinity;
        for (let other = 0; other < count; ++other) if (other !== own) least = Math.min(least, distance2(places, own, other));
        values[k] = has_set_out(film, i, own) ? Math.sqrt(least) : Number.NaN;
      });
    },
  };
}

/** One curve for each vehicle; `value` may look at that of the frame before. */
function each(axis: string, note: string, scene: Scene, shown: Shown, value: (i: number, vehicle: number, before: number) => number): Curves {
  return {
    axis, note, series: one_each(scene, shown), rules: [],
    read(i, values) {
      shown.vehicles.forEach((vehicle, k) => { values[k] = value(i, vehicle, values[k]!); });
    },
  };
}

function speed(scene: Scene, film: Film, shown: Shown): Curves {
  const { vehicles } = shown;
  return {
    axis: 'speed [m/s]',
    note: 'over ground; commanded: faint',
    series: [
      ...vehicles.map((vehicle): Series => ({ label: `${scene.vehicles[vehicle]!.name}, commanded`, vehicle, look: 'faint' })),
      ...one_each(scene, shown),
    ],
    rules: [],
    read(i, values) {
      vehicles.forEach((vehicle, k) => {
        values[k] = film.length('command_mps', i, vehicle);
        values[vehicles.length + k] = film.length('velocity_mps', i, vehicle);
      });
    },
  };
}

/** Where the bow points [rad], clockwise from north. */
export function yaw_of(film: Film, i: number, vehicle: number): number {
  const [w, x, y, z] = [0, 1, 2, 3].map((k) => film.value('attitude', i, vehicle, k)) as [number, number, number, number];
  return Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

/** The angle [deg] that is `angle` but for full turns and nearest to `before`; in [0, 360) where there is none before. */
export function unwrapped(angle: number, before: number): number {
  if (Number.isNaN(before)) return ((angle % 360) + 360) % 360;
  return angle - 360 * Math.round((angle - before) / 360);
}

function heading(scene: Scene, film: Film, shown: Shown): Curves {
  return each('heading [°]', 'of the bow, clockwise from north', scene, shown,
    (i, vehicle, before) => unwrapped(yaw_of(film, i, vehicle) * degrees, before));
}

function depth(scene: Scene, film: Film, shown: Shown): Curves {
  return each('depth [m]', 'below the mean surface', scene, shown, (i, vehicle) => film.value('position_m', i, vehicle, 2));
}

function power(scene: Scene, film: Film, shown: Shown): Curves {
  return each('power [W]', 'drawn by the thrusters', scene, shown, (i, vehicle) => film.value('power_w', i, vehicle));
}

function force(scene: Scene, film: Film, shown: Shown): Curves {
  const own = shown.alone;
  if (own === null) {
    return each('force [N]', 'amount; choose one vehicle for surge, sway and heave', scene, shown,
      (i, vehicle) => film.length('force_n', i, vehicle));
  }
  return {
    axis: 'force [N]',
    note: 'surge; sway dashed; heave dotted',
    series: (['surge', 'sway', 'heave'] as const).map((label, k) => ({
      label, vehicle: own, look: (['full', 'dashed', 'dotted'] as const)[k]!,
    })),
    rules: [],
    read(i, values) {
      for (let k = 0; k < 3; ++k) values[k] = film.value('force_n', i, own, k);
    },
  };
}

export const chart_kinds: readonly ChartKind[] = [
  { key: 'separation', title: 'Separation', unit: 'm', open: true, needs: null, curves: separation },
  { key: 'speed', title: 'Speed', unit: 'm/s', open: true, needs: null, curves: speed },
  { key: 'heading', title: 'Heading', unit: '°', open: false, needs: null, curves: heading },
  { key: 'depth', title: 'Depth', unit: 'm', open: false, needs: null, curves: depth },
  { key: 'force', title: 'Force', unit: 'N', open: false, needs: 'force_n', curves: force },
  { key: 'power', title: 'Power', unit: 'W', open: false, needs: 'power_w', curves: power },
];
