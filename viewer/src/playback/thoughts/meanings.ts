// SPDX-License-Identifier: Apache-2.0
// How each meaning looks, and which of them the reader wants to see.
import { h, s } from '../../common/dom';
import type { Stroke } from '../model';

export type Mark = 'arrow' | 'ring' | 'dot' | 'diamond' | 'edge' | 'area' | 'image';
export interface Look {
  mark: Mark;
  colour: string;
  dash: string;
}

export const own_velocity = 'own velocity';
export const commanded = 'commanded';

const looks: Record<string, Look> = {
  [own_velocity]: { mark: 'arrow', colour: 'var(--ink)', dash: '' },
  [commanded]: { mark: 'diamond', colour: 'var(--ink)', dash: '' },
  chosen: { mark: 'arrow', colour: 'var(--c2)', dash: '' },
  'after the safety filter': { mark: 'arrow', colour: 'var(--c2)', dash: '' },
  preferred: { mark: 'arrow', colour: 'var(--c0)', dash: '5 3' },
  desired: { mark: 'arrow', colour: 'var(--c0)', dash: '5 3' },
  'before the safety filter': { mark: 'arrow', colour: 'var(--c0)', dash: '5 3' },
  particle: { mark: 'dot', colour: 'var(--c6)', dash: '' },
  'allowed by a neighbour': { mark: 'edge', colour: 'var(--c1)', dash: '' },
};
const further = ['var(--c3)', 'var(--c6)', 'var(--c1)', 'var(--c7)', 'var(--c5)', 'var(--c4)'];

/** The same colour for the same words, in every run. */
function colour_of(meaning: string): string {
  let sum = 0;
  for (const letter of meaning) sum = (sum * 31 + letter.charCodeAt(0)) >>> 0;
  return further[sum % further.length]!;
}

export function look_of(kind: Stroke['kind'], meaning: string): Look {
  const known = looks[meaning];
  if (known !== undefined) return known;
  const mark: Mark = kind === 'half_space' ? 'edge' : kind === 'region' ? 'area' : kind === 'image' ? 'image' : 'ring';
  return { mark, colour: kind === 'region' ? 'var(--c1)' : colour_of(meaning), dash: '' };
}

export function glyph(look: Look): SVGSVGElement {
  const sign = s('svg', { class: 'chart glyph', viewBox: '0 0 18 12', width: 18, height: 12, 'aria-hidden': 'true' });
  sign.append(...glyph_marks(look));
  return sign;
}

/** The sign of a look in a field of 18 by 12. */
export function glyph_marks({ mark, colour, dash }: Look): SVGElement[] {
  switch (mark) {
    case 'arrow': return [
      s('line', { class: 'arrow', colour, x1: 1, x2: 11, y1: 6, y2: 6, 'stroke-dasharray': dash ? '3 2' : undefined }),
      s('path', { class: 'head', colour, d: 'M17 6L10 2.4V9.6Z' })];
    case 'ring': return [s('circle', { class: 'ring', colour, cx: 9, cy: 6, r: 4 })];
    case 'dot': return [s('circle', { class: 'particle', colour, cx: 5, cy: 7, r: 2 }), s('circle', { class: 'particle', colour, cx: 12, cy: 5, r: 2 })];
    case 'diamond': return [s('path', { class: 'ring', colour, d: 'M9 1L14 6L9 11L4 6Z' })];
    case 'edge': return [
      s('rect', { class: 'forbidden', colour, x: 1, y: 6, width: 16, height: 6 }),
      s('line', { class: 'edge', colour, x1: 1, x2: 17, y1: 6, y2: 6 })];
    case 'area': return [s('rect', { class: 'region', colour, x: 2, y: 1.5, width: 14, height: 9, rx: 1 })];
    case 'image': return [0, 1, 2, 3].map((k) => s('rect', { class: 'pixel', x: 3 + 6 * (k % 2), y: 6 * Math.floor(k / 2), width: 6, height: 6,
      opacity: [0.75, 0.35, 0.2, 0.55][k]! }));
  }
}

export interface Entry {
  meaning: string;
  kind: Stroke['kind'];
  count: number;
}

const in_plane = new Set<Stroke['kind']>(['velocity', 'half_space', 'region', 'image']);
const key_of = (kind: string, meaning: string): string => `${kind}:${meaning}`;

/** What of the strokes is of the plane, by meaning, and what the picture in three dimensions shows. */
export function entries_of(strokes: readonly Stroke[]): { plane: Entry[]; picture: Entry[] } {
  const found = new Map<string, Entry>();
  for (const { kind, meaning } of strokes) {
    const entry = found.get(key_of(kind, meaning)) ?? { meaning, kind, count: 0 };
    ++entry.count;
    found.set(key_of(kind, meaning), entry);
  }
  const entries = [...found.values()];
  return { plane: entries.filter(({ kind }) => in_plane.has(kind)), picture: entries.filter(({ kind }) => !in_plane.has(kind)) };
}

/** What the reader has hidden. Of several images, which would cover each other, one is shown. */
export class Wanted {
  private readonly hidden = new Set<string>();
  private image: string | null | undefined;

  shows({ kind, meaning }: { kind: Stroke['kind']; meaning: string }, all: readonly Entry[]): boolean {
    if (kind !== 'image') return !this.hidden.has(key_of(kind, meaning));
    if (this.image === null) return false;
    const images = all.filter((entry) => entry.kind === 'image');
    const shown = images.find((entry) => entry.meaning === this.image) ?? images[0];
    return shown?.meaning === meaning;
  }

  toggle(entry: Entry, all: readonly Entry[]): void {
    const shown = this.shows(entry, all);
    if (entry.kind === 'image') this.image = shown ? null : entry.meaning;
    else if (shown) this.hidden.add(key_of(entry.kind, entry.meaning));
    else this.hidden.delete(key_of(entry.kind, entry.meaning));
  }
}

/** The legend: a click on a meaning hides and shows it. */
export function meaning_key(entries: readonly Entry[], wanted: Wanted, changed: () => void): HTMLElement {
  return h('ul', { class: 'meaning-key', 'aria-label': 'What is drawn' }, ...entries.map((entry) => {
    const label = entry.count > 1 ? `${entry.meaning} (${entry.count})` : entry.meaning;
    const button = h('button', { type: 'button', 'aria-pressed': String(wanted.shows(entry, entries)), title: 'Show or hide' },
      glyph(look_of(entry.kind, entry.meaning)), label);
    button.addEventListener('click', () => {
      wanted.toggle(entry, entries);
      changed();
    });
    return h('li', {}, button);
  }));
}
