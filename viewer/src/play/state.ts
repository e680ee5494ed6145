// SPDX-License-Identifier: Apache-2.0
// What is played, and the address that says it: #play=, then packed JSON.
import { list, list_for, number, optional, or_null, record, some, text, type Of, type Read } from '../common/read';

const version = 2;
/** Links of version 1 say nothing of changes on the way. */
const readable = [1, version];

const change = list_for(2, 'path and value', text) as Read<[path: string, value: string]>;

const state = record({
  version: number,
  /** The path of a shipped scenario. */
  scenario: text,
  /** What was typed or opened instead of it; null as shipped. */
  yaml: or_null(text),
  /** Of the file that was opened; null: none was. */
  file: optional(or_null(text), null),
  seed: or_null(text),
  /** As --set makes them: path and value. */
  set: list(change),
  /** Of a second run beside it, with the same seed; null: none. */
  beside: optional(or_null(list(change)), null),
  /** From these instants on the first run has further changes; ascending. */
  changes: some(record({ at_s: number, set: list(change) })),
});
export type State = Of<typeof state>;

export const as_shipped = (scenario: string): State => ({ version, scenario, yaml: null, file: null, seed: null, set: [], beside: null, changes: [] });
/** Its name in messages and in the command. */
export const file_of = ({ scenario, yaml, file }: State): string => file ?? (yaml === null ? scenario : 'scenario.yaml');
export const first_state = as_shipped('scenarios/swap_8.yaml');

async function through(bytes: BufferSource, stream: GenericTransformStream): Promise<Uint8Array> {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream as ReadableWritablePair)).arrayBuffer());
}

export async function address_of(of: State): Promise<string> {
  const packed = await through(new TextEncoder().encode(JSON.stringify(of)), new CompressionStream('deflate-raw'));
  const letters = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(''));
  return `#play=${letters.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')}`;
}

const plain_keys = ['scenario', 'set', 'seed'];

/** An address that is written by hand: #scenario=scenarios/swap_8.yaml&set=vehicles[*].avoider=apf&seed=7, in any order. */
function plain_state(address: string): State {
  const words = new URLSearchParams(address.slice(1));
  for (const key of words.keys()) {
    if (!plain_keys.includes(key)) throw new Error(`“${key}” says nothing here; what does is ${plain_keys.join(', ')}, and play of a copied link`);
    if (key !== 'set' && words.getAll(key).length > 1) throw new Error(`“${key}” is given twice`);
  }
  const scenario = words.get('scenario');
  if (scenario === null) throw new Error('it names no scenario');
  const set = words.getAll('set').map((word): [string, string] => {
    const at = word.indexOf('=');
    if (at < 0) throw new Error(`set=${word} has no value`);
    return [word.slice(0, at), word.slice(at + 1)];
  });
  return { ...as_shipped(scenario), seed: words.get('seed'), set };
}

/** As a person reads it, where it can be read so. */
function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** What packed letters hold. */
async function unpacked(letters: string): Promise<unknown> {
  try {
    const bytes = Uint8Array.from(atob(letters.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
    return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(await through(bytes, new DecompressionStream('deflate-raw'))));
  } catch {
    throw new Error('it is cut short, or letters of it are changed');
  }
}

/** Null where the address says nothing. Throws where it says what this page cannot read. */
export async function state_in(address: string): Promise<State | null> {
  if (address === '' || address === '#') return null;
  if (!address.startsWith('#play=')) return plain_state(address);
  const letters = address.slice('#play='.length);
  const stray = /[^\w-]/.exec(decoded(letters))?.[0];
  if (stray !== undefined) throw new Error(`it has “${stray}”, which no copied link has`);
  const value = await unpacked(letters);
  const told = record({ version: number })(value, 'link').version;
  if (!readable.includes(told)) throw new Error(`it is of version ${told} of this page's links, and this page reads versions ${readable.join(' and ')}`);
  return { ...state(value, 'link'), version };
}
