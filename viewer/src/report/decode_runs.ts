// SPDX-License-Identifier: Apache-2.0
// The document's runs, and the references of marks and rows to them.
import type { Made, Run } from './model';
import { DataError, type Reader } from '../common/reader';

/** A page beside the report or below it, never a place elsewhere or a script. */
function playback(at: Reader): string {
  const path = at.text();
  const beside = /^[\w.+=-]+(\/[\w.+=-]+)*\.html$/.test(path) && !path.split('/').includes('..');
  return beside ? path : at.fail('the path of a page below this one');
}

function seed(at: Reader): string {
  return typeof at.value === 'number' ? String(at.whole_number(0, Number.MAX_SAFE_INTEGER)) : at.text();
}

/** One entry stands for all runs that differ in their seeds alone; the seed ends the command. */
function runs_of(at: Reader): Run[] {
  const label = at.at('label').text('');
  const command = at.at('command').text('');
  const seeds = at.at('seeds').list(seed);
  const playbacks = at.at('playbacks');
  const pages = new Map(playbacks.absent ? [] : playbacks.keys().map((key) => {
    if (seeds[Number(key)] === undefined) throw new DataError(`${playbacks.path}: no seed stands at ${key}`);
    return [Number(key), playback(playbacks.at(key))] as const;
  }));
  return seeds.map((seed, i) =>
    ({ label, seed, command: command === '' ? '' : command + seed, playback: pages.get(i) ?? null }));
}

export function decode_runs(at: Reader): Run[] {
  return at.list(runs_of, true).flat();
}

/** `runs` is a list of places and of [first, last] places, `values` has one or more numbers for each run. */
export function decode_made(runs: Reader, values: Reader, all: readonly Run[]): Made | null {
  if (runs.absent) return null;
  const place = (at: Reader): number => all.length === 0 ? at.fail('nothing, for the document lists no runs')
    : at.whole_number(0, all.length - 1);
  const made = runs.list((entry) => {
    if (!Array.isArray(entry.value)) return [all[place(entry)]!];
    const [first, last] = entry.list_for(2, 'ends', place);
    if (last! < first!) throw new DataError(`${entry.path}: ${last} comes before ${first}`);
    return all.slice(first, last! + 1);
  }).flat();
  if (made.length === 0) return null;
  const numbers = values.list((value) => value.number_or_null(), true);
  if (numbers.length % made.length !== 0) {
    throw new DataError(`${values.path}: ${numbers.length} entries for ${made.length} runs`);
  }
  return { runs: made, values: numbers };
}
