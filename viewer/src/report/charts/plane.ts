// SPDX-License-Identifier: Apache-2.0
// A rectangle over x and y, both to their very ends, with ticks outside of it.
import { s, text_width } from '../../common/dom';
import { fixed } from '../../common/format';
import { linear, tick_digits, ticks, type Scale } from '../../common/scale';
import type { Range } from '../model';
import { axis_labels, draw_x_ticks, type Canvas } from './cartesian';
import type { View } from './chart';

export interface Plane extends Canvas {
  x: Scale;
}

export interface PlaneOptions {
  view: View;
  x: Range;
  y: Range;
  x_label: string;
  y_label: string;
  /** Its height over its width; a square where it is not given. */
  ratio?: number;
}

/** As large as the view is wide, up to a size that still fits a window. */
export function plane({ view, x, y, x_label, y_label, ratio = 1 }: PlaneOptions): Plane {
  const [font, most] = view.compact ? [10.5, 300] : [11.5, 460];
  const count = Math.max(2, Math.round(Math.min(most, view.width) / (view.compact ? 48 : 60)));
  const marks_y = ticks(y[0], y[1], Math.max(2, Math.round(count * Math.min(1, ratio))));
  const digits = tick_digits(marks_y);
  const left = Math.ceil(Math.max(...marks_y.map((value) => text_width(fixed(value, digits), font)))) + 12;
  const room = 14;
  const across = Math.max(40, Math.floor(Math.min(most / Math.max(ratio, 1e-3), view.width - left - room)));
  const side = { x: across, y: Math.max(24, Math.round(across * ratio)) };
  const top = y_label === '' ? 10 : Math.ceil(font) + 16;
  const area = { left, right: left + side.x, top, bottom: top + side.y };
  const width = area.right + room;
  const height = Math.ceil(area.bottom + font + (x_label === '' ? 14 : font + 20));

  const svg = s('svg', { viewBox: `0 0 ${width} ${height}`, width, height, class: 'chart' });
  svg.style.fontSize = `${font}px`;
  const on: Plane = {
    svg, marks: s('g', { class: 'marks' }), area, font,
    x: linear(x, [area.left, area.right]), y: linear(y, [area.bottom, area.top]),
  };
  for (const value of marks_y) {
    const at = on.y(value);
    svg.append(
      s('line', { class: 'axis', x1: left - 4, x2: left, y1: at, y2: at }),
      s('text', { class: 'tick', x: left - 8, y: at, dy: '0.34em', 'text-anchor': 'end' }, fixed(value, digits)));
  }
  svg.append(...axis_labels({ x_label, y_label, view, area, font, height }), on.marks);
  draw_x_ticks(on, on.x, count, width);
  svg.append(s('rect', { class: 'face', x: left - 0.5, y: top - 0.5, width: side.x + 1, height: side.y + 1 }));
  return on;
}
