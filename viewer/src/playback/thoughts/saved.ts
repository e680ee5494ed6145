// SPDX-License-Identifier: Apache-2.0
// The planes of velocities as one SVG that stands alone, with their legend.
import { s, text_width } from '../../common/dom';
import { standalone_svg } from '../../common/saved_svg';
import { image_width, type ImageStroke } from '../model';
import { pixels_of } from './image';
import { told, type Entry } from './key';
import { glyph_marks } from './meanings';

const gap = 22;
const row = 18;

export interface SavedPlane {
  svg: SVGSVGElement;
  caption: string;
}

/** `image` lies under the first plane, which reaches so far [m/s]. */
export function planes_svg(title: string, planes: readonly SavedPlane[], entries: readonly Entry[],
                           image: ImageStroke | null, reach: number): string {
  const sizes = planes.map(({ svg }) => svg.viewBox.baseVal.width);
  const width = sizes.reduce((sum, size) => sum + size, (planes.length - 1) * gap);
  const tallest = Math.max(...sizes);
  if (image !== null && planes[0] !== undefined) put_image(planes[0].svg, image, reach);
  const legend = s('g', { transform: `translate(0 ${tallest + 2 * row})` });
  let [x, y] = [0, 0];
  for (const entry of entries) {
    const advance = 24 + text_width(told(entry), 12) + 24;
    if (x > 0 && x + advance > width) [x, y] = [0, y + row];
    legend.append(s('g', { transform: `translate(${x} ${y})` }, ...glyph_marks(entry.look),
      s('text', { class: 'saved-label', x: 24, y: 10 }, told(entry))));
    x += advance;
  }
  const drawing = s('svg', { class: 'chart', viewBox: `0 0 ${width} ${tallest + 3 * row + y}` });
  drawing.style.fontSize = '11px';
  let left = 0;
  planes.forEach(({ svg, caption }, k) => {
    svg.setAttribute('x', String(left));
    drawing.append(svg, s('text', { x: left, y: sizes[k]! + 15 }, caption));
    left += sizes[k]! + gap;
  });
  drawing.append(legend);
  return standalone_svg(drawing, title, []);
}

function put_image(svg: SVGSVGElement, stroke: ImageStroke, reach: number): void {
  const size = svg.viewBox.baseVal.width;
  const width = (image_width(stroke) / (2 * reach)) * size;
  svg.querySelector('g')?.prepend(s('image', {
    href: pixels_of(stroke).toDataURL(), x: (size - width) / 2, y: (size - width) / 2, width, height: width,
    'image-rendering': 'pixelated', transform: `rotate(${(stroke.yaw * 180) / Math.PI} ${size / 2} ${size / 2})`,
  }));
}
