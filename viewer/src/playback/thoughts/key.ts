// SPDX-License-Identifier: Apache-2.0
// The legend of a decision, and what of it the reader wants to see.
import { h } from '../../common/dom';
import type { Stroke } from '../model';
import { glyph, type Look, type Meanings } from './meanings';

const most_alike = 8;

type Named = Pick<Stroke, 'kind' | 'meaning'>;
export interface Entry extends Named {
  label: string;
  look: Look;
  count: number;
}

const in_plane = new Set<Stroke['kind']>(['velocity', 'half_space', 'region', 'image']);
const key_of = (kind: string, meaning: string): string => `${kind}:${meaning}`;

/** Strokes by meaning; those about many different vehicles are one entry. */
function grouped(strokes: readonly Stroke[], meanings: Meanings): Entry[] {
  const alike = new Map<string, Set<string>>();
  for (const { kind, meaning } of strokes) {
    const group = key_of(kind, meanings.group(meaning));
    alike.set(group, (alike.get(group) ?? new Set()).add(meaning));
  }
  const entries = new Map<string, Entry>();
  for (const { kind, meaning } of strokes) {
    const group = meanings.group(meaning);
    const is_crowd = alike.get(key_of(kind, group))!.size > most_alike;
    const shown = is_crowd ? group : meaning;
    const look = meanings.look(kind, meaning);
    const entry = entries.get(key_of(kind, shown)) ?? (is_crowd
      ? { kind, meaning: shown, label: `${group} …`, look: { ...look, colour: 'var(--ink-2)' }, count: 0 }
      : { kind, meaning: shown, label: meanings.words(meaning), look, count: 0 });
    ++entry.count;
    entries.set(key_of(kind, shown), entry);
  }
  return [...entries.values()];
}

/** What of the strokes is of the plane, by meaning, and what the picture in three dimensions shows. */
export function entries_of(strokes: readonly Stroke[], meanings: Meanings): { plane: Entry[]; picture: Entry[] } {
  const entries = grouped(strokes, meanings);
  return { plane: entries.filter(({ kind }) => in_plane.has(kind)), picture: entries.filter(({ kind }) => !in_plane.has(kind)) };
}

export function told(entry: Entry): string {
  return entry.count > 1 ? `${entry.label} (${entry.count})` : entry.label;
}

/** What the reader has hidden. Of several images, which would cover each other, one is shown. */
export class Wanted {
  private readonly hidden = new Set<string>();
  /** Undefined until the reader decides: the first; null: none. */
  private image: string | null | undefined;

  constructor(private readonly meanings: Meanings) {}

  shows({ kind, meaning }: Named, all: readonly Entry[]): boolean {
    if (kind !== 'image') {
      return !this.hidden.has(key_of(kind, meaning)) && !this.hidden.has(key_of(kind, this.meanings.group(meaning)));
    }
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

/** A click on a meaning hides and shows it. */
export function meaning_key(entries: readonly Entry[], wanted: Wanted, changed: () => void): HTMLElement {
  return h('ul', { class: 'meaning-key', 'aria-label': 'What is drawn' }, ...entries.map((entry) => {
    const button = h('button', { type: 'button', 'aria-pressed': String(wanted.shows(entry, entries)), title: 'Show or hide' },
      glyph(entry.look), told(entry));
    button.addEventListener('click', () => {
      wanted.toggle(entry, entries);
      changed();
    });
    return h('li', {}, button);
  }));
}
