// SPDX-License-Identifier: Apache-2.0
// Changes in a scenario, as `fairway run --set` makes them: of every vehicle's method, its parameters, its model, and of anything else.

export type Changes = [path: string, value: string][];

const avoider = 'vehicles[*].avoider';
/** What is chosen by a name alone. */
export const chosen_paths = { model: 'vehicles[*].model', exchange: 'exchange' } as const;
export type Chosen = keyof typeof chosen_paths;
export const method_path = (vehicle: number): string => `vehicles[${vehicle}].avoider`;

export const value_of = (changes: Changes, path: string): string | null => changes.find(([at]) => at === path)?.[1] ?? null;
const without = (changes: Changes, gone: (path: string) => boolean): Changes => changes.filter(([path]) => !gone(path));

/** Null: as the scenario says. */
export const method_of = (changes: Changes): string | null => value_of(changes, avoider);

/** What is set there; null: as the scenario says. What is set inside of it before is gone. */
export function with_value(changes: Changes, path: string, value: string | null): Changes {
  const rest = without(changes, (at) => at === path || at.startsWith(`${path}.`));
  return value === null ? rest : [...rest, [path, value]];
}

/** Of all vehicles. The parameters of another method are not this one's. */
export const with_method = (changes: Changes, name: string | null): Changes =>
  with_value(without(changes, (path) => /^vehicles\[\d+\]\.avoider/.test(path)), avoider, name);

export const with_parameter = (changes: Changes, name: string, value: string | null): Changes => with_value(changes, `${avoider}.${name}`, value);

export function parameters_in(changes: Changes): Map<string, string> {
  const prefix = `${avoider}.`;
  return new Map(changes.filter(([path]) => path.startsWith(prefix)).map(([path, value]) => [path.slice(prefix.length), value]));
}
