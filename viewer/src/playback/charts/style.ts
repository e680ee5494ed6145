// SPDX-License-Identifier: Apache-2.0
// Colours and dashes of the curves: a vehicle's over the whole page.
import { Palette } from '../../common/colour';
import type { VehicleSpec } from '../model';
import type { Look, Series } from './curves';

/** Vehicles get their colours in the order of the scene, by their index. */
export function vehicle_palette(vehicles: readonly VehicleSpec[]): Palette {
  const palette = new Palette();
  palette.add(vehicles.map((_, k) => String(k)));
  return palette;
}

const look_dashes: Record<Look, string> = { full: '', faint: '', dashed: '6 3', dotted: '1.5 3' };

/** Beyond eight vehicles the dash tells them apart, unless it already tells parts of one vehicle apart. */
export function dash_of({ vehicle, look }: Series, palette: Palette): string {
  return look_dashes[look] || palette.dash(String(vehicle));
}

const known = new Map<string, string>();

/** The value of a colour such as var(--c0) in the theme in force: a canvas knows no variables. */
export function colour_now(colour: string): string {
  const name = /^var\((--[\w-]+)\)$/.exec(colour)?.[1];
  if (name === undefined) return colour;
  const value = known.get(name) ?? getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  known.set(name, value);
  return value;
}

/** Asking the page for a colour makes it compute its styles: it is asked once per theme. */
export function forget_colours(): void {
  known.clear();
}
