// SPDX-License-Identifier: Apache-2.0
// A chart as an SVG that stands alone: the canvas on the page is sharp at its own size only.
import type { Palette } from '../../common/colour';
import { path_data, s } from '../../common/dom';
import { fixed, short } from '../../common/format';
import { standalone_svg } from '../../common/saved_svg';
import { linear, multiples, tick_digits, ticks } from '../../common/scale';
import type { ChartKind, Curves, Series } from './curves';
import type { Store } from './store';
import { dash_of } from './style';
import { told, value_domain, value_step } from './values';

const [width, height] = [640, 300];
const margin = { left: 62, right: 12, top: 8, bottom: 44 };

export function curves_svg(kind: ChartKind, curves: Curves, store: Store, span: readonly [number, number], palette: Palette): string {
  const { times, columns } = store.thinned(span[0], span[1], width - margin.left - margin.right);
  const ends = columns.flatMap((values) => [least(values), -least(values.map((value) => -value))]);
  const domain = value_domain(kind.key, [...ends, ...curves.rules.map(({ value }) => value)]);
  const x = linear(span, [margin.left, width - margin.right]);
  const bottom = height - margin.bottom;
  const y = linear(domain, kind.key === 'depth' ? [margin.top, bottom] : [bottom, margin.top]);
  const drawing = s('svg', { class: 'chart', viewBox: `0 0 ${width} ${height}` });
  drawing.style.fontSize = '11px';

  const levels = multiples(domain[0], domain[1], value_step(kind.key, domain));
  const instants = ticks(span[0], span[1], 6);
  drawing.append(
    ...levels.flatMap((value) => [
      s('line', { class: 'grid-line', x1: margin.left, x2: width - margin.right, y1: y(value), y2: y(value) }),
      s('text', { x: margin.left - 7, y: y(value) + 4, 'text-anchor': 'end' }, fixed(told(kind.key, value), tick_digits(levels))),
    ]),
    ...instants.flatMap((time) => [
      s('line', { class: 'grid-line', x1: x(time), x2: x(time), y1: margin.top, y2: bottom }),
      s('text', { x: x(time), y: bottom + 16, 'text-anchor': 'middle' }, fixed(time, tick_digits(instants))),
    ]),
    s('text', { class: 'axis-label', x: (margin.left + width - margin.right) / 2, y: height - 8, 'text-anchor': 'middle' }, 'time [s]'),
    s('text', { class: 'axis-label', 'text-anchor': 'middle', transform: `translate(14 ${(margin.top + bottom) / 2}) rotate(-90)` }, curves.axis),
    ...curves.rules.map(({ value }) =>
      s('line', { class: 'rule', x1: margin.left, x2: width - margin.right, y1: y(value), y2: y(value) })),
    ...curves.series.map((series, k) => curve(series, palette, Array.from(columns[k]!, (value, i) => {
      const time = times[i]!;
      return time < span[0] || time > span[1] ? null : [x(time), y(value)] as const;
    }))),
  );
  return standalone_svg(drawing, `${kind.title}, ${curves.note}`, [
    ...curves.series.filter(({ look }) => look !== 'faint').map((series) => ({
      label: series.label, glyph: 'line' as const, toggles: false,
      colour: palette.colour(String(series.vehicle)), dash: dash_of(series, palette),
    })),
    ...curves.rules.map(({ label, value }) => ({ label: `${label} ${short(value)} ${kind.unit}`, glyph: 'rule' as const, toggles: false })),
  ]);
}

function least(values: Float64Array): number {
  return values.reduce((a, b) => Math.min(a, Number.isFinite(b) ? b : a), Infinity);
}

function curve(series: Series, palette: Palette, points: (readonly [number, number] | null)[]): SVGPathElement {
  return s('path', { class: series.look === 'faint' ? 'curve faint' : 'curve', d: path_data(points),
    colour: palette.colour(String(series.vehicle)), 'stroke-dasharray': dash_of(series, palette) || undefined });
}
