// SPDX-License-Identifier: Apache-2.0
// Reads a page's data strictly: whatever is not as it should be is said with the path that leads to it.

/** What is wrong with the document, and where. */
export class DataError extends Error {}

function name_of(value: unknown): string {
  if (value === undefined) return 'nothing';
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'a list';
  return typeof value === 'object' ? 'an object' : `the ${typeof value} ${JSON.stringify(value)}`.slice(0, 60);
}

/** A value of the document with the path that leads to it, for messages. */
export class Reader {
  /** The whole of a document. */
  static of_json(json: string): Reader {
    try {
      return new Reader(JSON.parse(json), '');
    } catch (error) {
      throw new DataError(`the data are not JSON: ${error instanceof Error ? error.message : String(error)}`);
    }
  }

  constructor(readonly value: unknown, readonly path: string) {}

  fail(expected: string): never {
    throw new DataError(`${this.path || 'the document'}: expected ${expected}, found ${name_of(this.value)}`);
  }
  get absent(): boolean {
    return this.value === undefined || this.value === null;
  }

  at(key: string): Reader {
    if (typeof this.value !== 'object' || this.value === null || Array.isArray(this.value)) this.fail('an object');
    const path = this.path === '' ? key : `${this.path}.${key}`;
    return new Reader((this.value as Record<string, unknown>)[key], path);
  }
  keys(): string[] {
    if (typeof this.value !== 'object' || this.value === null || Array.isArray(this.value)) this.fail('an object');
    return Object.keys(this.value);
  }

  text(otherwise?: string): string {
    if (this.absent && otherwise !== undefined) return otherwise;
    return typeof this.value === 'string' ? this.value : this.fail('text');
  }
  number(): number {
    return typeof this.value === 'number' && Number.isFinite(this.value) ? this.value : this.fail('a number');
  }
  flag(): boolean {
    return typeof this.value === 'boolean' ? this.value : this.fail('true or false');
  }
  number_or_null(): number | null {
    return this.absent ? null : this.number();
  }
  whole_number(least: number, most: number): number {
    const number = this.number();
    return Number.isInteger(number) && number >= least && number <= most ? number
      : this.fail(`a whole number from ${least} to ${most}`);
  }
  one_of<T extends string>(choices: readonly T[]): T {
    const found = choices.find((choice) => choice === this.value);
    return found ?? this.fail(`one of ${choices.join(', ')}`);
  }

  /** Each entry read by `read`; an absent list is empty where `optional`. */
  list<T>(read: (entry: Reader) => T, optional = false): T[] {
    if (optional && this.absent) return [];
    if (!Array.isArray(this.value)) this.fail('a list');
    return this.value.map((entry, i) => read(new Reader(entry, `${this.path}[${i}]`)));
  }
  /** A list of exactly so many entries. */
  list_for<T>(count: number, of: string, read: (entry: Reader) => T): T[] {
    const entries = this.list(read);
    if (entries.length !== count) throw new DataError(`${this.path}: ${entries.length} entries for ${count} ${of}`);
    return entries;
  }
}
