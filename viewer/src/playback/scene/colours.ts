// SPDX-License-Identifier: Apache-2.0
// The page's colours, read from its style sheets whenever the theme changes.
import { Color } from 'three';
import { series_colour } from '../../common/colour';

export interface Colours {
  vehicle(index: number): Color;
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
    vehicle: (index) => of(series_colour(index)),
    deep, ink: of('--ink'), ink_3: of('--ink-3'), line: of('--line-2'),
    alerts: [of('--sign-clear'), of('--sign-detected'), of('--sign-collided')],
    bad: of('--bad'), water: of('--water'), accent: of('--accent'), of,
    dark: deep.getHSL({ h: 0, s: 0, l: 0 }).l < 0.5,
  };
}
