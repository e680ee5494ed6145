// SPDX-License-Identifier: Apache-2.0
// How each meaning looks, and how it is told.
import { s } from '../../common/dom';
import { meaning_colour } from '../meaning_colour';
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

/** Velocities that every method draws; the others are rings. */
const looks: Record<string, Omit<Look, 'colour'>> = {
  [own_velocity]: { mark: 'arrow', dash: '' },
  [commanded]: { mark: 'diamond', dash: '' },
  chosen: { mark: 'arrow', dash: '' },
  'after the safety filter': { mark: 'arrow', dash: '' },
  force: { mark: 'arrow', dash: '' },
  preferred: { mark: 'arrow', dash: '5 3' },
  desired: { mark: 'arrow', dash: '5 3' },
  'before the safety filter': { mark: 'arrow', dash: '5 3' },
  particle: { mark: 'dot', dash: '' },
};

const marks: Record<Stroke['kind'], Mark> = {
  velocity: 'ring', half_space: 'edge', region: 'area', image: 'image', path: 'edge', tree: 'edge', sphere: 'ring',
};

export class Meanings {
  constructor(private readonly vehicles: readonly VehicleSpec[]) {}

  /** What is about a vehicle has that one's colour; about something else, grey; the rest, that of the picture. */
  look(kind: Stroke['kind'], meaning: string): Look {
    const subject = about(meaning, this.vehicles);
    const colour = subject === null ? `var(${meaning_colour(meaning)})` : (subject.who.colour ?? 'var(--ink-2)');
    return { ...(looks[meaning] ?? { mark: marks[kind], dash: '' }), colour };
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
