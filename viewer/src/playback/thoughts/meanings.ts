// SPDX-License-Identifier: Apache-2.0
// How each meaning looks, and how it is told.
import { colour_count } from '../../common/colour';
import { s } from '../../common/dom';
import type { Stroke, VehicleSpec } from '../model';
import { about } from './who';

export type Mark = 'arrow' | 'ring' | 'dot' | 'diamond' | 'edge' | 'area' | 'image';
export interface Look {
  mark: Mark;
  colour: string;
  dash: string;
}

export const own_velocity = 'own velocity';
export const commanded = 'commanded';

const looks: Record<string, Look> = {
  [own_velocity]: { mark: 'arrow', colour: 'var(--ink-3)', dash: '' },
  [commanded]: { mark: 'diamond', colour: 'var(--ink)', dash: '' },
  chosen: { mark: 'arrow', colour: 'var(--ink)', dash: '' },
  'after the safety filter': { mark: 'arrow', colour: 'var(--ink)', dash: '' },
  force: { mark: 'arrow', colour: 'var(--ink)', dash: '' },
  preferred: { mark: 'arrow', colour: 'var(--c2)', dash: '5 3' },
  desired: { mark: 'arrow', colour: 'var(--c2)', dash: '5 3' },
  'before the safety filter': { mark: 'arrow', colour: 'var(--c2)', dash: '5 3' },
  attraction: { mark: 'ring', colour: 'var(--c2)', dash: '' },
  repulsion: { mark: 'ring', colour: 'var(--bad)', dash: '' },
  particle: { mark: 'dot', colour: 'var(--c3)', dash: '' },
};

/** As in the picture; else the same colour for the same words, in every run. */
function colour_of(kind: Stroke['kind'], meaning: string): string {
  if (kind === 'region') return 'var(--bad)';
  if (kind === 'half_space') return 'var(--c0)';
  let sum = 0;
  for (const letter of meaning) sum = (sum * 31 + letter.charCodeAt(0)) >>> 0;
  return `var(--c${sum % colour_count})`;
}

const marks: Record<Stroke['kind'], Mark> = {
  velocity: 'ring', half_space: 'edge', region: 'area', image: 'image', path: 'edge', tree: 'edge', sphere: 'ring',
};

export class Meanings {
  constructor(private readonly vehicles: readonly VehicleSpec[]) {}

  /** What is about a vehicle has that one's colour; about something else, grey. */
  look(kind: Stroke['kind'], meaning: string): Look {
    const known = looks[meaning];
    if (known !== undefined) return known;
    const subject = about(meaning, this.vehicles);
    const colour = subject === null ? colour_of(kind, meaning) : (subject.who.colour ?? 'var(--ink-2)');
    return { mark: marks[kind], colour, dash: '' };
  }

  /** With the name of a vehicle in place of its number. */
  words(meaning: string): string {
    const subject = about(meaning, this.vehicles);
    return subject === null ? meaning : `${subject.what} ${subject.who.name}`;
  }

  /** The same for all that differ in whom they are about only. */
  group(meaning: string): string {
    return about(meaning, this.vehicles)?.what ?? meaning;
  }
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
    case 'dot': return [
      s('circle', { class: 'particle', colour, cx: 5, cy: 7, r: 2 }),
      s('circle', { class: 'particle', colour, cx: 12, cy: 5, r: 2 })];
    case 'diamond': return [s('path', { class: 'ring', colour, d: 'M9 1L14 6L9 11L4 6Z' })];
    case 'edge': return [
      s('rect', { class: 'forbidden', colour, x: 1, y: 6, width: 16, height: 6 }),
      s('line', { class: 'edge', colour, x1: 1, x2: 17, y1: 6, y2: 6 })];
    case 'area': return [s('rect', { class: 'region', colour, x: 2, y: 1.5, width: 14, height: 9, rx: 1 })];
    case 'image': return [0.75, 0.35, 0.2, 0.55].map((opacity, k) =>
      s('rect', { class: 'pixel', x: 3 + 6 * (k % 2), y: 6 * Math.floor(k / 2), width: 6, height: 6, opacity }));
  }
}
