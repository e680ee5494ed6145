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

/** The value now of a colour such as var(--c0): a canvas knows no variables. */
export function colour_now(colour: string): string {
  const name = /^var\((--[\w-]+)\)$/.exec(colour)?.[1];
  return name === undefined ? colour : getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
