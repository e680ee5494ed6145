// SPDX-License-Identifier: Apache-2.0
// Ranges and meanings of a scenario's keys, as the simulator's JSON schema has them.
import type { Parameter } from './module';

interface Node {
  description?: string;
  type?: string;
  properties?: Record<string, Node>;
  items?: Node;
  anyOf?: Node[];
  oneOf?: Node[];
  minimum?: number;
  exclusiveMinimum?: number;
  maximum?: number;
  exclusiveMaximum?: number;
}

/** The first key of this name at or below a node. */
function found_below(node: Node, name: string): Node | null {
  const own = node.properties?.[name];
  if (own !== undefined) return own;
  const below = [...Object.values(node.properties ?? {}), ...(node.anyOf ?? []), ...(node.oneOf ?? []), ...(node.items === undefined ? [] : [node.items])];
  for (const each of below) {
    const found = found_below(each, name);
    if (found !== null) return found;
  }
  return null;
}

/** Of a key that may be drawn, or that is a list, the number in it. */
function number_in(node: Node): Node {
  if (node.items !== undefined) return number_in(node.items);
  return node.anyOf?.find(({ type }) => type === 'number') ?? node;
}

const unit_of = (name: string): string => ({ mps: 'm/s', s: 's', m: 'm' })[/_([a-z]+)$/.exec(name)?.[1] ?? ''] ?? '';

/** The number of this name below the keys `within`; throws where the format has none. */
export function key_of(schema: unknown, within: string[], name: string): Parameter {
  let node: Node | null = schema as Node;
  for (const key of within) node = node && found_below(node, key);
  const key = node && found_below(node, name);
  if (key === null) throw new Error(`the format has no key ${[...within, name].join('.')}`);
  const { minimum, exclusiveMinimum, maximum, exclusiveMaximum, type } = number_in(key);
  return {
    name, type: type ?? 'number', default: 0, unit: unit_of(name), meaning: (key.description ?? '').replace(/\.$/, ''),
    range: [minimum ?? exclusiveMinimum ?? null, maximum ?? exclusiveMaximum ?? null],
  };
}
