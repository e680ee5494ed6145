// SPDX-License-Identifier: Apache-2.0
// What the picture is made of: parts that draw themselves at a moment.
import { Group, type Object3D } from 'three';
import type { Moment } from '../film';
import type { Colours } from './colours';
import type { Ink } from './ink/instances';
import type { Label } from './labels';
import type { Poses } from './poses';

/** What every part is told of the instant to show. */
export interface Now {
  moment: Moment;
  poses: Poses;
  chosen: ReadonlySet<number>;
  /** Whose thoughts are shown: the chosen ones, else the followed one. */
  thinkers: readonly number[];
  colours: Colours;
}

/** A line of the key: a colour and what it stands for. */
export interface KeyLine {
  colour: string;
  text: string;
}

export interface Part {
  readonly object: Object3D;
  show(now: Now): void;
  /** What is written beside it, placed anew with every camera. */
  labels?(): Label[];
  key?(): KeyLine[];
}

/** A part whose inks are drawn with anew at every moment. */
export abstract class Drawn implements Part {
  readonly object = new Group();
  private readonly inks: Ink[] = [];

  protected ink<I extends Ink>(ink: I): I {
    this.inks.push(ink);
    this.object.add(ink.object);
    return ink;
  }

  show(now: Now): void {
    for (const ink of this.inks) ink.clear();
    this.draw(now);
    for (const ink of this.inks) ink.commit();
  }

  protected abstract draw(now: Now): void;
}

/** Translucent things are drawn in this order, whatever their distance. */
export const order = { grid: 1, walls: 2, trails: 3, outer: 4, inner: 5, ghosts: 6, fans: 7, sketch: 8, lines: 9, surface: 10, dots: 11 } as const;
