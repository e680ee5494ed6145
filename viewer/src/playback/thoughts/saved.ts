// SPDX-License-Identifier: Apache-2.0
// The planes of velocities as one SVG that stands alone, with their legend.
import { s } from '../../common/dom';
import { drawn_legend } from '../../common/legend';
import { standalone_svg } from '../../common/saved_svg';
import { told, type Entry } from './key';
import { glyph_marks } from './meanings';

const gap = 22;
const row = 18;

export interface SavedPlane {
  svg: SVGSVGElement;
  caption: string;
}

export function planes_svg(title: string, planes: readonly SavedPlane[], entries: readonly Entry[]): string {
  const sizes = planes.map(({ svg }) => svg.viewBox.baseVal.width);
  const width = sizes.reduce((sum, size) => sum + size, (planes.length - 1) * gap);
  const tallest = Math.max(...sizes);
  const { marks, height } = drawn_legend(entries.map((entry) => ({ label: told(entry), sign: glyph_marks(entry.look) })), width);
  marks.setAttribute('transform', `translate(0 ${tallest + 2 * row})`);
  const drawing = s('svg', { class: 'chart', viewBox: `0 0 ${width} ${tallest + 2 * row + height}` });
  drawing.style.fontSize = '11px';
  let left = 0;
  planes.forEach(({ svg, caption }, k) => {
    svg.setAttribute('x', String(left));
    drawing.append(svg, s('text', { x: left, y: sizes[k]! + 15 }, caption));
    left += sizes[k]! + gap;
  });
  drawing.append(marks);
  return standalone_svg(drawing, title, []);
}
