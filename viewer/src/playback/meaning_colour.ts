// SPDX-License-Identifier: Apache-2.0
// One colour per meaning over the whole film, in the picture and in the plane: fixed for what every method draws, else by the words.
import { colour_count, series_colour } from '../common/colour';

const known: (readonly [RegExp, string])[] = [
  [/^(chosen|after the safety filter|force|command|commanded)$/, '--ink'],
  [/^(preferred|desired|before the safety filter|attraction)$/, '--c2'],
  [/^(repulsion)$/, '--bad'],
  [/velocity obstacle|protective|range/, '--bad'],
  [/^allowed by an obstacle$/, '--c7'],
  [/^allowed/, '--c0'],
  [/^particle$/, '--c3'],
  [/tree/, '--ink-3'],
  [/another class/, '--c7'],
  [/^(trajectory|path|band|foreseen|way round)$/, '--c6'],
  [/^(velocity|own velocity)$/, '--ink-3'],
];

/** The name of a custom property of the page. */
export function meaning_colour(meaning: string): string {
  const found = known.find(([pattern]) => pattern.test(meaning));
  if (found) return found[1];
  let hash = 0;
  for (let i = 0; i < meaning.length; ++i) hash = (hash * 31 + meaning.charCodeAt(i)) >>> 0;
  return series_colour(hash % colour_count);
}
