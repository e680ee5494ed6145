// SPDX-License-Identifier: Apache-2.0
// What is inside the page: the simulator, the playback's page, the shipped scenarios.
import { embedded_text } from '../common/problem';
import { fields, read_json, record, text } from '../common/read';

const held = record({ module: text, playback: text, scenarios: fields });

async function unpacked(base64: string): Promise<Response> {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')));
}

export interface Held {
  module: WebAssembly.Module;
  playback: string;
  /** YAML by path, as "scenarios/head_on.yaml". */
  scenarios: Record<string, string>;
}

export async function held_data(): Promise<Held> {
  const data = read_json(embedded_text('simulator'), held);
  const [module, playback] = await Promise.all([
    unpacked(data.module).then((response) => response.arrayBuffer()).then((bytes) => WebAssembly.compile(bytes)),
    unpacked(data.playback).then((response) => response.text()),
  ]);
  return { module, playback, scenarios: data.scenarios as Record<string, string> };
}
