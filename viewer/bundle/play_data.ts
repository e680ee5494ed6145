// SPDX-License-Identifier: Apache-2.0
// What play.html holds beside its scripts: the simulator, the playback's page, and the shipped scenarios.
import { readdirSync, readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

/** JSON as it may stand in a page; src/play/data.ts reads it. `root` is the repository's, with a slash. */
export function play_data(root: string): string {
  const text = (path: string): string => readFileSync(root + path, 'utf8');
  const scenarios: Record<string, string> = {};
  for (const folder of ['scenarios', 'scenarios/failures']) {
    for (const name of readdirSync(root + folder).filter((file) => file.endsWith('.yaml')).sort()) {
      scenarios[`${folder}/${name}`] = text(`${folder}/${name}`);
    }
  }
  const packed = (bytes: Uint8Array): string => gzipSync(bytes, { level: 9 }).toString('base64');
  return JSON.stringify({
    module: packed(readFileSync(`${root}build/web/fairway.wasm`)),
    playback: packed(Buffer.from(text('fairway/view/template.html'))),
    scenarios,
  });
}
