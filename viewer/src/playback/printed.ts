// SPDX-License-Identifier: Apache-2.0
// The film's values as the page prints them.
import { series_colour } from '../common/colour';
import { fixed } from '../common/format';
import type { Film } from './film';
import { alerts, modes, phases, progresses, shortfalls, type RunEvent, type Scene } from './model';

/** Decimals of times [s] and positions [m]. */
const digits = 3;

export const seconds = (time: number): string => fixed(time, digits);
export const vehicle_colour = (vehicle: number): string => `var(${series_colour(vehicle)})`;

/** North, east and down [m]. */
export function position_texts(film: Film, index: number, vehicle: number): string[] {
  return film.vector('position_m', index, vehicle).map((coordinate) => fixed(coordinate, digits));
}

/** From the vehicle to its goal [m]. */
export function goal_distance(film: Film, index: number, vehicle: number): number {
  return Math.hypot(...[0, 1, 2].map((k) => film.value('goal_m', index, vehicle, k) - film.value('position_m', index, vehicle, k)));
}

const words = (code: string | undefined): string => (code ?? 'unknown').replace('_', ' ');
export const phase_text = (film: Film, index: number, vehicle: number): string => words(phases[film.value('phase', index, vehicle)]);
export const mode_text = (film: Film, index: number, vehicle: number): string => words(modes[film.value('mode', index, vehicle)]);
export const alert_text = (film: Film, index: number, vehicle: number): string => words(alerts[film.value('alert', index, vehicle)]);

const beyond: Record<(typeof shortfalls)[number], string> = {
  none: '', too_slow: 'slower than it can go', astern: 'astern, which it cannot go', sideways: 'sideways, which it cannot go',
};
/** What it is commanded and cannot carry out; empty if it can. */
export const shortfall_text = (film: Film, index: number, vehicle: number): string =>
  beyond[shortfalls[film.value('shortfall', index, vehicle)] ?? 'none'];

/** That it makes no progress, for how long, how and with whom; empty if it does, or is not meant to. */
export function progress_text(film: Film, index: number, vehicle: number, scene: Scene): string {
  const state = progresses[film.value('progress', index, vehicle)] ?? 'making';
  if (state === 'making' || state === 'holding') return '';
  const since = `no progress for ${fixed(film.value('no_progress_s', index, vehicle), 1)} s: `;
  const with_index = film.value('progress_with', index, vehicle);
  const vehicles = scene.vehicles.length;
  const who = with_index < vehicles ? scene.vehicles[with_index]?.name : `obstacle ${with_index - vehicles}`;
  if (state === 'trapped') return `${since}trapped`;
  if (who === undefined) return `${since}it holds on purpose`;
  return `${since}${state === 'waiting' ? 'waiting for' : 'deadlocked with'} ${who}`;
}

/** What happened, for a list or a tip. */
export function event_text(event: RunEvent, scene: Scene): string {
  const name = (vehicle: number | null): string => (vehicle === null ? 'an obstacle' : scene.vehicles[vehicle]!.name);
  const who = name(event.vehicle);
  switch (event.kind) {
    case 'detected': return `${who} detects ${name(event.other)}`;
    case 'collision': return `${who} collides with ${name(event.other)}`;
    case 'avoided': return `${who} has avoided ${name(event.other)}`;
    case 'collided': return `${who} is clear of ${name(event.other)}, collision counted`;
    case 'arrived': return `${who} arrives`;
    case 'stuck': return `${who} is stuck`;
  }
}
