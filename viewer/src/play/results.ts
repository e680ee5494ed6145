// SPDX-License-Identifier: Apache-2.0
// What the runs came to, side by side, and when they first differ.
import { h } from '../common/dom';
import type { Outcome } from './module';

const shown = ['pair_collision_count', 'min_separation_m', 'min_clearance_m', 'makespan_s', 'arrived_ratio', 'distance_m', 'energy_j', 'deadlocked_count'];

const digits = (value: number | null | undefined): string =>
  value === null || value === undefined ? 'none' : String(Number(value.toPrecision(5)));

/** One column an outcome; null while a run goes on. */
export function results_table(outcomes: readonly (Outcome | null)[]): HTMLElement {
  const known = outcomes.filter((outcome) => outcome !== null);
  if (known.length === 0) return h('p', {}, 'The run goes on.');
  const verdict = known.find((outcome) => outcome.verdict !== undefined)?.verdict;
  if (verdict !== undefined) return h('p', { class: 'verdict' }, `Simulated again here: ${verdict}.`);
  const broken = known.find((outcome) => outcome.outcome === 'diverged');
  if (broken !== undefined) return h('p', {}, `The run ${broken.diverged ?? 'diverged'}.`);
  const names = shown.filter((name) => known.some(({ fleet }) => name in fleet));
  return h('table', { class: 'measures' }, ...names.map((name) =>
    h('tr', {}, h('td', {}, name), ...outcomes.map((outcome) => h('td', {}, outcome === null ? '…' : digits(outcome.fleet[name]))))));
}

/** The first frame whose hashes differ; the shorter length where one run goes on from the other; null where they are alike. */
export function parting(first: readonly string[], second: readonly string[]): number | null {
  const length = Math.min(first.length, second.length);
  for (let i = 0; i < length; ++i) if (first[i] !== second[i]) return i;
  return first.length === second.length ? null : length;
}
