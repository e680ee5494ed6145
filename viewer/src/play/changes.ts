// SPDX-License-Identifier: Apache-2.0
// Changes in a scenario, as `fairway run --set` makes them: of every vehicle's method, its parameters, and its model.
import type { State } from './state';

export type Changes = State['set'];

const avoider = 'vehicles[*].avoider';
/** What is chosen by a name alone. */
export const chosen_paths = { model: 'vehicles[*].model', exchange: 'exchange' } as const;
export type Chosen = keyof typeof chosen_paths;

const value_of = (changes: Changes, path: string): string | null => changes.find(([at]) => at === path)?.[1] ?? null;
const without = (changes: Changes, gone: (path: string) => boolean): Changes => changes.filter(([path]) => !gone(path));

/** Null: as the scenario says. */
export const method_of = (changes: Changes): string | null => value_of(changes, avoider);
export const chosen_of = (changes: Changes, what: Chosen): string | null => value_of(changes, chosen_paths[what]);

/** The parameters of another method are not this one's. */
export function with_method(changes: Changes, name: string | null): Changes {
  const rest = without(changes, (path) => path.startsWith(avoider));
  return name === null ? rest : [...rest, [avoider, name]];
}

export function with_chosen(changes: Changes, what: Chosen, name: string | null): Changes {
  const rest = without(changes, (path) => path === chosen_paths[what]);
  return name === null ? rest : [...rest, [chosen_paths[what], name]];
}

/** Null: the default again. */
export function with_parameter(changes: Changes, name: string, value: string | null): Changes {
  const rest = without(changes, (path) => path === `${avoider}.${name}`);
  return value === null ? rest : [...rest, [`${avoider}.${name}`, value]];
}

export function parameters_in(changes: Changes): Map<string, string> {
  const prefix = `${avoider}.`;
  return new Map(changes.filter(([path]) => path.startsWith(prefix)).map(([path, value]) => [path.slice(prefix.length), value]));
}
