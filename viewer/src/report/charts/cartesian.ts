// SPDX-License-Identifier: Apache-2.0
// The part that charts over x and y share: margins, grid lines, labels and reference lines.
import { fit_text, s, text_width } from '../../common/dom';
import { fixed, short } from '../../common/format';
import { linear, nice_domain, tick_digits, ticks, type Scale } from '../../common/scale';
import type { Rule } from '../model';
import type { View } from './chart';

/** Room left of the drawing, for labels of ticks and for the first label under it. */
export const least_left = 24;

export interface Area {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

export interface Canvas {
  svg: SVGSVGElement;
  /** Where the data are drawn, above grid and reference lines. */
  marks: SVGGElement;
  area: Area;
  y: Scale;
  font: number;
}

export interface CanvasOptions {
  view: View;
  y_label: string;
  /** Every value that must be inside the domain. */
  values: number[];
  y_max: number | null;
  rules: Rule[];
  x_label: string;
  /** Space under the axis for its labels, given the inner width. */
  x_space(inner: number, font: number): number;
}

/** The least and the largest of the values, of which there may be more than a call can have arguments; null of none. */
export function extent(values: readonly number[]): [number, number] | null {
  return values.length === 0 ? null : [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
}

/** A point of a curve. */
export function dot(colour: string, cx: number, cy: number): SVGElement {
  return s('circle', { colour, class: 'dot', cx, cy, r: 3.5 });
}

/** The height of the drawing; slanted labels get their space on top of it. */
function height_for({ width, compact }: View, under: number): number {
  const level = 46;
  const height = compact ? 200 : Math.max(270, Math.min(380, width * 0.42));
  return Math.round(height + Math.max(0, under - level));
}

/** Everything but the data and the labels along x. */
export function canvas({ view, y_label, values, y_max, rules, x_label, x_space }: CanvasOptions): Canvas {
  const font = view.compact ? 10.5 : 11.5;
  const under = x_space(view.width - 40, font) + (x_label === '' ? 4 : font + 10);
  const height = height_for(view, under);
  const count = Math.round(height / (view.compact ? 48 : 52));
  const in_domain = y_max === null ? [...values, ...rules.map((rule) => rule.value)] : values;
  const domain = nice_domain(in_domain, count, y_max ?? undefined);
  const marks_y = ticks(domain[0], domain[1], count);
  const digits = tick_digits(marks_y);
  const tick_width = Math.max(...marks_y.map((value) => text_width(fixed(value, digits), font)));

  const left = Math.max(least_left, Math.ceil(tick_width) + 10);
  const right = view.width - 6;
  const top = y_label === '' ? 10 : font + 16;
  const area = { left, right, top, bottom: height - under };
  const y = linear(domain, [area.bottom, area.top]);

  const svg = s('svg', { viewBox: `0 0 ${view.width} ${height}`, width: view.width, height, class: 'chart' });
  svg.style.fontSize = `${font}px`;
  for (const value of marks_y) {
    svg.append(
      s('line', { class: value === domain[0] ? 'axis' : 'grid', x1: left, x2: right, y1: y(value), y2: y(value) }),
      s('text', { class: 'tick', x: left - 8, y: y(value), dy: '0.34em', 'text-anchor': 'end' }, fixed(value, digits)));
  }
  svg.append(...axis_labels({ x_label, y_label, view, area, font, height }));
  for (const rule of rules) svg.append(...rule_marks(rule, y, area, font));
  const marks = s('g', { class: 'marks' });
  svg.append(marks);
  return { svg, marks, area, y, font };
}

interface AxisLabels {
  x_label: string;
  y_label: string;
  view: View;
  area: Area;
  font: number;
  height: number;
}

/** The name of y above the drawing, left of the buttons of a small chart, and the name of x below it. */
export function axis_labels({ x_label, y_label, view, area, font, height }: AxisLabels): SVGElement[] {
  const { left, right } = area;
  return [
    ...(y_label === '' ? [] : [s('text', { class: 'axis-label', x: 0, y: font },
      fit_text(y_label, Math.min(right + 2, view.width - (view.compact ? 104 : 4)), font, 500))]),
    ...(x_label === '' ? [] : [s('text', { class: 'axis-label', x: (left + right) / 2, y: height - 4, 'text-anchor': 'middle' },
      fit_text(x_label, right - left, font, 500))]),
  ];
}

/** About `count` ticks along x; their labels stay left of `edge`. */
export function draw_x_ticks(on: Canvas, x: Scale, count: number, edge: number): void {
  const marks_x = ticks(x.domain[0], x.domain[1], count);
  const digits = tick_digits(marks_x);
  const { bottom } = on.area;
  for (const value of marks_x) {
    const text = fixed(value, digits);
    const inset = text_width(text, on.font) / 2;
    on.svg.insertBefore(s('line', { class: 'axis', x1: x(value), x2: x(value), y1: bottom, y2: bottom + 4 }), on.marks);
    on.svg.insertBefore(s('text', {
      class: 'tick', x: Math.min(x(value), edge - inset), y: bottom + on.font + 6, 'text-anchor': 'middle',
    }, text), on.marks);
  }
}

/** A horizontal reference line with its name; one beyond the domain is named at the edge. */
function rule_marks(rule: Rule, y: Scale, area: Area, font: number): SVGElement[] {
  const [low, high] = y.domain;
  const name = `${rule.label} ${short(rule.value)}`;
  const label = (at: number, text: string): SVGElement =>
    s('text', { class: 'rule-label', x: area.right - 2, y: at, 'text-anchor': 'end' },
      fit_text(text, area.right - area.left, font));
  if (rule.value > high) return [label(area.top + font, `${name} ↑`)];
  if (rule.value < low) return [label(area.bottom - 4, `${name} ↓`)];
  const at = y(rule.value);
  const below = at - font - 4 < area.top - 4;
  return [
    s('line', { class: 'rule', x1: area.left, x2: area.right, y1: at, y2: at }),
    label(below ? at + font + 2 : at - 4, name),
  ];
}
