// SPDX-License-Identifier: Apache-2.0
// An image over a plane, such as what an avoider thinks of each velocity, cell by cell.
import { shape_path } from '../../common/colour';
import { h, s, type Attributes } from '../../common/dom';
import { fixed, short } from '../../common/format';
import type { Tip } from '../../common/tooltip';
import type { RasterBlock } from '../model';
import { numbers_table, palette_of, type Chart, type Drawing, type Palettes, type Target, type View } from './chart';
import { plane, type Plane } from './plane';

function colour_at(block: RasterBlock, column: number, row: number): string {
  const from = 6 * (row * block.width + column);
  return `#${block.rgb.slice(from, from + 6)}`;
}

/** The middle of a cell; rows count from the top. */
function centre_of({ x, y, width, height }: RasterBlock, column: number, row: number): { x: number; y: number } {
  const between = (from: number, to: number, at: number, count: number): number =>
    (from * (count - at - 0.5) + to * (at + 0.5)) / count;
  return { x: between(x[0], x[1], column, width), y: between(y[1], y[0], row, height) };
}

function canvas_of(width: number, height: number) {
  const canvas = h('canvas', { width, height });
  const context = canvas.getContext('2d');
  if (context === null) throw new Error('the browser offers no canvas');
  return { canvas, context };
}

/** Printers and viewers of saved images smooth what they enlarge; from this size on that does not show. */
const least_pixels_along_a_side = 400;

/** The cells as rectangles of whole pixels. */
function picture({ width, height, rgb }: RasterBlock): SVGImageElement {
  const cells = canvas_of(width, height);
  const pixels = cells.context.createImageData(width, height);
  for (let i = 0; i < width * height; ++i) {
    const value = parseInt(rgb.slice(6 * i, 6 * i + 6), 16);
    pixels.data.set([value >> 16, (value >> 8) & 255, value & 255, 255], 4 * i);
  }
  cells.context.putImageData(pixels, 0, 0);

  const enlarged = (count: number): number => count * Math.ceil(least_pixels_along_a_side / count);
  const { canvas, context } = canvas_of(enlarged(width), enlarged(height));
  context.imageSmoothingEnabled = false;
  context.drawImage(cells.canvas, 0, 0, canvas.width, canvas.height);
  return s('image', { href: canvas.toDataURL(), preserveAspectRatio: 'none', 'image-rendering': 'pixelated' });
}

function position_rows(block: RasterBlock, at: { x: number; y: number }): Tip['rows'] {
  return [
    { label: block.x_label || 'x', value: fixed(at.x, 2) },
    { label: block.y_label || 'y', value: fixed(at.y, 2) },
  ];
}

function cell_target(block: RasterBlock, on: Plane, column: number, row: number): Target {
  const centre = centre_of(block, column, row);
  const [x, y] = [on.x(centre.x), on.y(centre.y)];
  const side = on.area.right - on.area.left;
  const [width, height] = [Math.max(5, side / block.width), Math.max(5, side / block.height)];
  const outline = { x: x - width / 2, y: y - height / 2, width, height };
  const colour = colour_at(block, column, row);
  return {
    x, y,
    tip: () => ({ title: 'Cell', rows: [...position_rows(block, centre), { label: 'colour', value: colour, colour }] }),
    cursor: () => edged('rect', outline),
  };
}

type Mark = RasterBlock['marks'][number];

function mark_style({ label }: Mark, palettes: Palettes) {
  const palette = palette_of(label, palettes);
  return { colour: palette.colour(label), shape: palette.shape(label) };
}

/** An outline that is seen on every colour. */
function edged(tag: 'circle' | 'rect', attributes: Attributes): SVGElement[] {
  return ['pin-edge', 'pin-ring'].map((name) => s(tag, { class: name, ...attributes }));
}

const pin_radius = 4.5;

/** Draws a mark; one beyond the image becomes an arrow head at its edge. */
function draw_mark(block: RasterBlock, on: Plane, mark: Mark, palettes: Palettes): Target {
  const { left, right, top, bottom } = on.area;
  const { colour, shape } = mark_style(mark, palettes);
  const [to_x, to_y] = [on.x(mark.x), on.y(mark.y)];
  const [x, y] = [Math.max(left, Math.min(right, to_x)), Math.max(top, Math.min(bottom, to_y))];
  const beyond = x !== to_x || y !== to_y;
  const d = beyond ? 'M0 0L-9 5V-5Z' : shape_path(shape, pin_radius);
  const turn = beyond ? ` rotate(${((Math.atan2(to_y - y, to_x - x) * 180) / Math.PI).toFixed(1)})` : '';
  on.marks.append(s('g', { colour, transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})${turn}` },
    s('path', { class: 'pin-edge', d }), s('path', { class: 'pin', d })));
  return {
    x, y,
    tip: () => ({ title: mark.label, rows: position_rows(block, mark).map((row, i) => (i === 0 ? { ...row, colour } : row)) }),
    cursor: () => edged('circle', { cx: x, cy: y, r: pin_radius + 4 }),
  };
}

function pick(block: RasterBlock, on: Plane, pins: Target[], x: number, y: number): Target | null {
  const pin = pins.find((target) => Math.hypot(target.x - x, target.y - y) < 8);
  if (pin !== undefined) return pin;
  const { left, right, top, bottom } = on.area;
  const column = Math.floor(((x - left) / (right - left)) * block.width);
  const row = Math.floor(((y - top) / (bottom - top)) * block.height);
  const inside = column >= 0 && column < block.width && row >= 0 && row < block.height;
  return inside ? cell_target(block, on, column, row) : null;
}

function draw(block: RasterBlock, image: SVGImageElement, palettes: Palettes, view: View): Drawing {
  const on = plane({ view, x: block.x, y: block.y, x_label: block.x_label, y_label: block.y_label });
  const { left, right, top, bottom } = on.area;
  const place = { x: left, y: top, width: right - left, height: bottom - top };
  for (const [name, value] of Object.entries(place)) image.setAttribute(name, String(value));
  on.marks.append(image);
  const pins = block.marks.filter(({ label }) => !view.hidden.has(label)).map((mark) => draw_mark(block, on, mark, palettes))
    .sort((a, b) => a.x - b.x);
  // Without marks the arrow keys go along the middle row.
  const middle = Math.floor(block.height / 2);
  const targets = pins.length > 0 ? pins
    : Array.from({ length: block.width }, (_, column) => cell_target(block, on, column, middle));
  return { svg: on.svg, targets, pick: (x, y) => pick(block, on, pins, x, y) };
}

function rows_of(block: RasterBlock) {
  const cells = Array.from({ length: block.width * block.height }, (_, i) => {
    const [column, row] = [i % block.width, Math.floor(i / block.width)];
    return { mark: '', ...centre_of(block, column, row), colour: colour_at(block, column, row) };
  });
  return [...block.marks.map(({ label, x, y }) => ({ mark: label, x, y, colour: '' })), ...cells];
}

export function raster_chart(block: RasterBlock, palettes: Palettes): Chart {
  const named = [...new Map(block.marks.map((mark) => [mark.label, mark])).values()];
  const [x_name, y_name] = [block.x_label || 'x', block.y_label || 'y'];
  const span = ([low, high]: RasterBlock['x']): string => `from ${short(low)} to ${short(high)}`;
  const marks = block.marks.map(({ label, x, y }) => `${label} at ${fixed(x, 2)}, ${fixed(y, 2)}`);
  let image: SVGImageElement | null = null;
  return {
    legend: named.map((mark) => ({ label: mark.label, glyph: 'point', ...mark_style(mark, palettes), toggles: true })),
    summary: `Image of ${block.width} by ${block.height} cells over ${x_name} ${span(block.x)} and ${y_name} ${span(block.y)}.` +
      (marks.length === 0 ? '' : ` Marks: ${marks.join('; ')}.`),
    data: () => numbers_table(block.title, [
      ...(named.length === 0 ? [] : [['mark', 'mark', 'text'] as const]), ['x', x_name], ['y', y_name], ['colour', 'colour', 'text'],
    ], rows_of(block)),
    draw: (view) => draw(block, image ??= picture(block), palettes, view),
  };
}
