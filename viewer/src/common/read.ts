// SPDX-License-Identifier: Apache-2.0
// Reads a page's data strictly. A reader is declared once: it checks a value, and its result is the type of what it read.
// Whatever is not as it should be is said with the path that leads to it.
import { reason_of } from './reason';

/** What is wrong with the document, and where. */
export class DataError extends Error {}

/** Checks the value at a path of the document; throws DataError if it is something else. */
export type Read<T> = (value: unknown, path: string) => T;
/** What a reader, or one that a function makes, gives. */
export type Of<R> = R extends Read<infer T> ? T : never;

function name_of(value: unknown): string {
  if (value === undefined) return 'nothing';
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'a list';
  return typeof value === 'object' ? 'an object' : `the ${typeof value} ${JSON.stringify(value)}`.slice(0, 60);
}

export function fail(value: unknown, path: string, expected: string): never {
  throw new DataError(`${path || 'the document'}: expected ${expected}, found ${name_of(value)}`);
}

const absent = (value: unknown): value is null | undefined => value === undefined || value === null;

export const text: Read<string> = (value, path) => typeof value === 'string' ? value : fail(value, path, 'text');
export const number: Read<number> = (value, path) =>
  typeof value === 'number' && Number.isFinite(value) ? value : fail(value, path, 'a number');
export const positive: Read<number> = (value, path) => {
  const size = number(value, path);
  return size > 0 ? size : fail(value, path, 'a number above 0');
};
export const flag: Read<boolean> = (value, path) => typeof value === 'boolean' ? value : fail(value, path, 'true or false');

export const whole = (least: number, most = Number.MAX_SAFE_INTEGER): Read<number> => (value, path) => {
  const found = number(value, path);
  return Number.isInteger(found) && found >= least && found <= most ? found
    : fail(value, path, `a whole number from ${least} to ${most}`);
};
export const one_of = <const T extends string>(choices: readonly T[]): Read<T> => (value, path) =>
  choices.find((choice) => choice === value) ?? fail(value, path, `one of ${choices.join(', ')}`);

/** What is absent or null is `otherwise`. */
export const optional = <T, U>(read: Read<T>, otherwise: U): Read<T | U> => (value, path) =>
  absent(value) ? otherwise : read(value, path);
export const or_null = <T>(read: Read<T>): Read<T | null> => optional(read, null);

export const list = <T>(read: Read<T>): Read<T[]> => (value, path) =>
  Array.isArray(value) ? value.map((entry, i) => read(entry, `${path}[${i}]`)) : fail(value, path, 'a list');
/** A list, empty where it is absent. */
export const some = <T>(read: Read<T>): Read<T[]> => optional(list(read), []);
/** A list of exactly so many entries. */
export const list_for = <T>(count: number, of: string, read: Read<T>): Read<T[]> => (value, path) => {
  const entries = list(read)(value, path);
  if (entries.length !== count) throw new DataError(`${path}: ${entries.length} entries for ${count} ${of}`);
  return entries;
};
export const pair = (of: string): Read<readonly [number, number]> => (value, path) =>
  list_for(2, of, number)(value, path) as [number, number] & number[];
export const triple: Read<readonly [number, number, number]> = (value, path) =>
  list_for(3, 'coordinates', number)(value, path) as [number, number, number] & number[];

export function fields(value: unknown, path: string): Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value) ? value as Record<string, unknown>
    : fail(value, path, 'an object');
}

/** An object, of which each key named here is read by its own reader. */
export function record<S extends Record<string, Read<unknown>>>(shape: S): Read<{ [K in keyof S]: Of<S[K]> }> {
  return (value, path) => {
    const found = fields(value, path);
    const at = (key: string): string => path === '' ? key : `${path}.${key}`;
    return Object.fromEntries(Object.entries(shape).map(([key, read]) => [key, read(found[key], at(key))])) as
      { [K in keyof S]: Of<S[K]> };
  };
}

/** The whole of a document; throws DataError with the first thing that is wrong with it. */
export function read_json<T>(json: string, read: Read<T>): T {
  let value: unknown;
  try {
    value = JSON.parse(json);
  } catch (error) {
    throw new DataError(`the data are not JSON: ${reason_of(error)}`);
  }
  return read(value, '');
}
