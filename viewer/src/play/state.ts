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
  /** What was typed instead of it; null as shipped. */
  yaml: or_null(text),
  seed: or_null(text),
  /** As --set makes them: path and value. */
  set: list(change),
  /** Of a second run beside it, with the same seed; null: none. */
  beside: optional(or_null(list(change)), null),
  /** From these instants on the first run has further changes; ascending. */
  changes: some(record({ at_s: number, set: list(change) })),
});
export type State = Of<typeof state>;

const as_shipped = (scenario: string): State => ({ version, scenario, yaml: null, seed: null, set: [], beside: null, changes: [] });
export const first_state = as_shipped('scenarios/swap_8.yaml');

async function through(bytes: BufferSource, stream: GenericTransformStream): Promise<Uint8Array> {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream as ReadableWritablePair)).arrayBuffer());
}

export async function address_of(of: State): Promise<string> {
  const packed = await through(new TextEncoder().encode(JSON.stringify(of)), new CompressionStream('deflate-raw'));
  const letters = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(''));
  return `#play=${letters.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')}`;
}

/** An address that is written by hand: #scenario=scenarios/swap_8.yaml&set=vehicles[*].avoider=apf&seed=7. */
function plain_state(address: string): State | null {
  const words = new URLSearchParams(address.slice(1));
  const scenario = words.get('scenario');
  if (scenario === null) return null;
  const set = words.getAll('set').map((word): [string, string] => {
    const at = word.indexOf('=');
    if (at < 0) throw new Error(`set=${word} has no value`);
    return [word.slice(0, at), word.slice(at + 1)];
  });
  return { ...as_shipped(scenario), seed: words.get('seed'), set };
}

/** Null where the address says nothing. Throws where it says what this page cannot read. */
export async function state_in(address: string): Promise<State | null> {
  if (address.startsWith('#scenario=')) return plain_state(address);
  const packed = /^#play=([\w-]+)$/.exec(address)?.[1];
  if (packed === undefined) return null;
  const letters = atob(packed.replaceAll('-', '+').replaceAll('_', '/'));
  const bytes = await through(Uint8Array.from(letters, (letter) => letter.charCodeAt(0)), new DecompressionStream('deflate-raw'));
  const value: unknown = JSON.parse(new TextDecoder().decode(bytes));
  const told = record({ version: number })(value, 'link').version;
  if (!readable.includes(told)) throw new Error(`it is of version ${told} of this page's links, and this page reads versions ${readable.join(' and ')}`);
  return { ...state(value, 'link'), version };
}
