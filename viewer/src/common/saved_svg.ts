// SPDX-License-Identifier: Apache-2.0
// A chart as a file that stands alone: styles resolved, title and legend inside, in the light theme.
import { fit_text, s } from './dom';
import { drawn_legend, glyph, type LegendEntry } from './legend';
import { in_light_theme } from './theme';

// What the style sheet sets on marks, with the values that need not be written.
const properties: [name: string, initial: string][] = [
  ['fill', 'rgb(0, 0, 0)'], ['fill-opacity', '1'], ['stroke', 'none'], ['stroke-width', '1px'],
  ['stroke-opacity', '1'], ['stroke-dasharray', 'none'], ['stroke-linecap', 'butt'], ['stroke-linejoin', 'miter'],
  ['opacity', '1'], ['paint-order', 'normal'], ['font-size', ''], ['font-weight', '400'], ['text-anchor', 'start'],
];

function resolve(element: Element): void {
  const style = getComputedStyle(element);
  const shape = element.localName !== 'g' && element.localName !== 'svg' && element.localName !== 'title';
  for (const [name, initial] of properties) {
    const value = style.getPropertyValue(name);
    const text_only = name.startsWith('font') || name === 'text-anchor';
    if (name === 'opacity' ? value !== '1' : shape && (!text_only || element.localName === 'text') && value !== initial) {
      element.setAttribute(name, value);
    } else {
      element.removeAttribute(name);
    }
  }
  for (const child of element.children) resolve(child);
}

function strip(element: Element): void {
  element.removeAttribute('class');
  element.removeAttribute('style');
  for (const child of element.children) strip(child);
}

export function standalone_svg(drawing: SVGSVGElement, title: string, entries: LegendEntry[]): string {
  const width = drawing.viewBox.baseVal.width;
  const height = drawing.viewBox.baseVal.height;
  const margin = 16;
  const head = 26;
  const { marks, height: legend_height } = drawn_legend(entries.map((entry) => ({ label: entry.label, sign: glyph(entry) })), width);
  const offset = margin + head + (legend_height > 0 ? legend_height + 6 : 0);
  const total = { width: width + 2 * margin, height: offset + height + margin };

  const chart = s('g', { transform: `translate(${margin} ${offset})` });
  for (const child of drawing.children) {
    if (!child.classList.contains('cursor')) chart.append(child.cloneNode(true));
  }
  marks.setAttribute('transform', `translate(${margin} ${margin + head})`);
  const svg = s('svg', {
    class: 'chart', viewBox: `0 0 ${total.width} ${total.height}`, width: total.width, height: total.height,
    'font-family': 'Inter, "Helvetica Neue", Arial, sans-serif',
  },
    s('title', {}, title),
    s('rect', { class: 'saved-ground', width: total.width, height: total.height }),
    s('text', { class: 'saved-title', x: margin, y: margin + 12 }, fit_text(title, width, 15, 600)), marks, chart);
  svg.style.fontSize = drawing.style.fontSize;

  // Styles can be computed only inside the page.
  const shelf = document.createElement('div');
  shelf.className = 'offscreen';
  shelf.append(svg);
  document.body.append(shelf);
  in_light_theme(() => resolve(svg));
  strip(svg);
  shelf.remove();
  return new XMLSerializer().serializeToString(svg) + '\n';
}
