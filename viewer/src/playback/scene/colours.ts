// SPDX-License-Identifier: Apache-2.0
// The page's colours, read from its style sheets whenever the theme changes.
import { Color } from 'three';
import { colour_count } from '../../common/colour';

export interface Colours {
  /** Of vehicles, by index modulo their number. */
  series: Color[];
  deep: Color;
  ink: Color;
  ink_3: Color;
  line: Color;
  /** Of the column `alert`. */
  alerts: [clear: Color, detected: Color, collided: Color];
  bad: Color;
  water: Color;
  accent: Color;
  /** Any other, such as '--c3'. */
  of(name: string): Color;
  dark: boolean;
}

export function read_colours(host: HTMLElement): Colours {
  const style = getComputedStyle(host);
  const known = new Map<string, Color>();
  const of = (name: string): Color => {
    let colour = known.get(name);
    if (colour === undefined) {
      colour = new Color(style.getPropertyValue(name).trim() || '#808080');
      known.set(name, colour);
    }
    return colour;
  };
  const deep = of('--deep');
  return {
    series: Array.from({ length: colour_count }, (_, k) => of(`--c${k}`)),
    deep, ink: of('--ink'), ink_3: of('--ink-3'), line: of('--line-2'),
    alerts: [of('--good'), of('--caution'), of('--bad')],
    bad: of('--bad'), water: of('--water'), accent: of('--accent'), of,
    dark: deep.getHSL({ h: 0, s: 0, l: 0 }).l < 0.5,
  };
}

export function series_name(vehicle: number): string {
  return `--c${vehicle % colour_count}`;
}
