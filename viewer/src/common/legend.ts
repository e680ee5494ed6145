// SPDX-License-Identifier: Apache-2.0
// Names of series with their drawing; a click on a name hides and shows the series.
import { shape_path, type Shape } from './colour';
import { h, s, text_width } from './dom';

export interface LegendEntry {
  label: string;
  glyph: 'box' | 'line' | 'point' | 'rule' | 'mean' | 'published' | 'goal' | 'sphere' | 'front';
  colour?: string;
  shape?: Shape;
  dash?: string;
  /** Whether a click shows and hides the series of this name. */
  toggles: boolean;
}

const size = 16;

/** The sign of an entry in a field of 16 by 16. */
export function glyph({ glyph: kind, colour, shape, dash }: LegendEntry): SVGElement[] {
  const k = colour ?? 'var(--ink)';
  const centred = `translate(${size / 2} ${size / 2})`;
  switch (kind) {
    case 'box': return [
      s('rect', { colour: k, class: 'box', x: 2, y: 3, width: 12, height: 10, rx: 1.5, 'stroke-dasharray': dash || undefined }),
      s('line', { colour: k, class: 'median', x1: 2, x2: 14, y1: 8, y2: 8 }),
    ];
    case 'line': return [s('line', { colour: k, class: 'curve', x1: 0, x2: 16, y1: 8, y2: 8, 'stroke-dasharray': dash })];
    case 'point': return [s('path', { colour: k, class: 'point', d: shape_path(shape ?? 'circle', 4.5), transform: centred })];
    case 'rule': return [s('line', { class: 'rule', x1: 0, x2: 16, y1: 8, y2: 8 })];
    case 'mean': return [s('circle', { class: 'mean', colour: k, cx: 8, cy: 8, r: 3.2 })];
    case 'published': return [s('path', { class: 'published', d: shape_path('diamond', 4.5), transform: centred })];
    case 'goal': return [s('path', { class: 'goal', colour: k, d: 'M4 4l8 8m0 -8l-8 8' })];
    case 'front': return [s('path', { class: 'front', d: 'M0 8H16' }), s('circle', { class: 'front-ring', cx: 8, cy: 8, r: 5 })];
    case 'sphere': return [s('g', { class: 'sphere' }, s('circle', { cx: 8, cy: 8, r: 6 }))];
  }
}

export function legend(entries: LegendEntry[], hidden: Set<string>, changed: () => void): HTMLElement {
  const items = entries.map((entry) => {
    const sign = s('svg', { class: 'chart glyph', viewBox: `0 0 ${size} ${size}`, width: size, height: size, 'aria-hidden': 'true' },
      ...glyph(entry));
    if (!entry.toggles) return h('li', {}, h('span', { class: 'entry' }, sign, entry.label));
    const button = h('button', { type: 'button', class: 'entry', 'aria-pressed': 'true', title: 'Show or hide' },
      sign, entry.label);
    button.addEventListener('click', () => {
      if (hidden.has(entry.label)) hidden.delete(entry.label);
      else hidden.add(entry.label);
      button.setAttribute('aria-pressed', String(!hidden.has(entry.label)));
      changed();
    });
    return h('li', {}, button);
  });
  return h('ul', { class: 'legend', 'aria-label': 'Legend' }, ...items);
}

/** The legend drawn as part of a saved image, each name beside its sign: its marks and its height for a width. */
export function drawn_legend(entries: readonly { label: string; sign: SVGElement[] }[], width: number): { marks: SVGElement; height: number } {
  const group = s('g', {});
  let [x, row] = [0, 0];
  for (const { label, sign } of entries) {
    const advance = size + 6 + text_width(label, 12) + 18;
    if (x > 0 && x + advance > width) [x, row] = [0, row + 1];
    group.append(s('g', { transform: `translate(${x.toFixed(1)} ${row * 20})` }, s('g', {}, ...sign),
      s('text', { class: 'saved-label', x: size + 6, y: 12 }, label)));
    x += advance;
  }
  return { marks: group, height: entries.length === 0 ? 0 : (row + 1) * 20 };
}
