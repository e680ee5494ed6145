// SPDX-License-Identifier: Apache-2.0
// Named points on a plane: a symbol each, its name beside it where there is room, and its values when pointed at.
import { shape_path } from '../../common/colour';
import { fit_text, s, text_width, type Attributes } from '../../common/dom';
import type { Tip } from '../../common/tooltip';
import type { Palettes, Target } from './chart';
import type { Plane } from './plane';
import type { Rect } from './projection';

export interface Pin {
  label: string;
  x: number;
  y: number;
}

/** A name that is a vehicle's elsewhere on the page has the vehicle's colour here too. */
export function pin_style(label: string, { series, vehicles }: Palettes) {
  const palette = vehicles.has(label) ? vehicles : series;
  return { colour: palette.colour(label), shape: palette.shape(label) };
}

const radius = 4.5;
const arrow_length = 9;

interface Placed {
  pin: Pin;
  x: number;
  y: number;
  /** The direction in degrees of a pin beyond the plane, which is drawn as an arrow head on the edge. */
  beyond: number | null;
  /** How far the symbol reaches from x and y. */
  reach: number;
}

function place(on: Plane, pin: Pin): Placed {
  const { left, right, top, bottom } = on.area;
  const [x, y] = [on.x(pin.x), on.y(pin.y)];
  const [inside_x, inside_y] = [Math.max(left, Math.min(right, x)), Math.max(top, Math.min(bottom, y))];
  const outside = x !== inside_x || y !== inside_y;
  const angle = (Math.atan2(y - inside_y, x - inside_x) * 180) / Math.PI;
  return { pin, x: inside_x, y: inside_y, beyond: outside ? angle : null, reach: outside ? arrow_length : radius };
}

function symbol({ pin, x, y, beyond }: Placed, palettes: Palettes): SVGElement {
  const { colour, shape } = pin_style(pin.label, palettes);
  const d = beyond === null ? shape_path(shape, radius) : `M0 0L${-arrow_length} 5V-5Z`;
  const turn = beyond === null ? '' : ` rotate(${beyond.toFixed(1)})`;
  return s('g', { colour, transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})${turn}` },
    s('path', { class: 'pin-edge', d }), s('path', { class: 'pin', d }));
}

/** An outline that is seen on every colour. */
export function edged(tag: 'circle' | 'rect', attributes: Attributes): SVGElement[] {
  return ['pin-edge', 'pin-ring'].map((name) => s(tag, { class: name, ...attributes }));
}

function around(x: number, y: number, reach: number): Rect {
  return { x: x - reach, y: y - reach, width: 2 * reach, height: 2 * reach };
}

function overlap(a: Rect, b: Rect): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/** The names that find room right, left, above or below of their symbols; the legend has them all. */
function names(on: Plane, pins: Placed[]): SVGElement[] {
  const { left, right, top, bottom } = on.area;
  const taken = pins.map(({ x, y, reach }) => around(x, y, reach));
  return pins.flatMap(({ pin, x, y, reach }) => {
    const gap = reach + 4;
    const text = fit_text(pin.label, (right - left) / 2, on.font, 500);
    const [width, height] = [text_width(text, on.font, 500), on.font + 2];
    const corners = [
      [x + gap, y - height / 2], [x - gap - width, y - height / 2],
      [x - width / 2, y - gap - height], [x - width / 2, y + gap],
    ] as const;
    const free = corners.map(([x, y]) => ({ x, y, width, height })).find((place) =>
      place.x >= left && place.x + width <= right && place.y >= top && place.y + height <= bottom &&
      !taken.some((other) => overlap(place, other)));
    if (free === undefined) return [];
    taken.push(free);
    return [s('text', { class: 'pin-label', x: free.x, y: free.y + height * 0.79 }, text)];
  });
}

/** Draws the pins and returns them as targets, from left to right. */
export function draw_pins(on: Plane, pins: Pin[], palettes: Palettes, tip: (pin: Pin, colour: string) => Tip): Target[] {
  const placed = pins.map((pin) => place(on, pin));
  on.marks.append(...placed.map((pin) => symbol(pin, palettes)), ...names(on, placed));
  return placed.sort((a, b) => a.x - b.x).map(({ pin, x, y }) => ({
    x, y,
    tip: () => tip(pin, pin_style(pin.label, palettes).colour),
    cursor: () => edged('circle', { cx: x, cy: y, r: radius + 4 }),
  }));
}
