// SPDX-License-Identifier: Apache-2.0
// Elements from a tag, attributes and children. Text always becomes a text node, never markup.

type Attribute = string | number | boolean | ((event: Event) => void) | undefined;
export type Attributes = Record<string, Attribute>;
export type Child = Node | string | number | null | undefined | false;

const svg_namespace = 'http://www.w3.org/2000/svg';

/** Coordinates to a hundredth of a pixel; a number that is not finite is a defect of the caller. */
function attribute_text(name: string, value: string | number): string {
  if (typeof value === 'string') return value;
  if (!Number.isFinite(value)) throw new Error(`${name} is not a finite number`);
  return String(Math.round(value * 100) / 100);
}

function fill<E extends Element>(element: E, attributes: Attributes, children: Child[]): E {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (typeof value === 'function') element.addEventListener(name, value);
    else element.setAttribute(name, value === true ? '' : attribute_text(name, value));
  }
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    element.append(typeof child === 'number' ? String(child) : child);
  }
  return element;
}

/** An HTML element; a function among the attributes listens to the event of that name. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Attributes = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  return fill(document.createElement(tag), attributes, children);
}

/** An SVG element. `colour` sets the custom property --k, which the style sheet draws with. */
export function s<K extends keyof SVGElementTagNameMap>(
  tag: K, attributes: Attributes & { colour?: string } = {}, ...children: Child[]
): SVGElementTagNameMap[K] {
  const { colour, ...rest } = attributes;
  const element = fill(document.createElementNS(svg_namespace, tag), rest, children);
  if (colour !== undefined) element.style.setProperty('--k', colour);
  return element;
}

/** A small square of a colour, beside what the colour stands for; without one, of none. */
export function swatch(colour: string | null): HTMLElement {
  const square = h('i', { class: 'swatch', 'aria-hidden': 'true' });
  if (colour !== null) square.style.background = colour;
  return square;
}

/** A path's data from points; a null point lifts the pen. */
export function path_data(points: Iterable<readonly [number, number] | null>): string {
  let data = '';
  let pen = 'M';
  for (const point of points) {
    if (point === null || !Number.isFinite(point[0]) || !Number.isFinite(point[1])) {
      pen = 'M';
      continue;
    }
    data += `${pen}${point[0].toFixed(1)} ${point[1].toFixed(1)}`;
    pen = 'L';
  }
  return data;
}

let canvas: CanvasRenderingContext2D | null = null;

/** Width in pixels of a line of text in the page's sans-serif. */
export function text_width(text: string, size: number, weight = 400): number {
  canvas ??= document.createElement('canvas').getContext('2d');
  if (canvas === null) return text.length * size * 0.56;
  canvas.font = `${weight} ${size}px "Fairway Sans", system-ui, sans-serif`;
  return canvas.measureText(text).width;
}

/** The text, shortened with an ellipsis until it fits. */
export function fit_text(text: string, width: number, size: number, weight = 400): string {
  if (text_width(text, size, weight) <= width) return text;
  let end = text.length - 1;
  while (end > 1 && text_width(text.slice(0, end) + '…', size, weight) > width) --end;
  return text.slice(0, end).trimEnd() + '…';
}

/** The texts without the words that all of them have in the same place, if they have as many words. */
function without_shared_words(texts: readonly string[]): string[] {
  const words = texts.map((text) => text.split(' '));
  if (new Set(words.map((list) => list.length)).size !== 1) return [...texts];
  return words.map((list) => list.filter((word, i) => words.some((other) => other[i] !== word)).join(' '));
}

/**
 * The texts, each shortened until it fits, but never so that two that differ come to the same: then they lose the words
 * that they share, or their beginnings, or, where that does not tell them apart either, nothing.
 */
export function fit_texts(texts: readonly string[], width: number, size: number): string[] {
  const apart = (shown: readonly string[]): boolean => new Set(shown).size === new Set(texts).size;
  const shortened = (list: readonly string[], cut: (text: string, kept: number) => string): string[] => list.map((text) => {
    if (text_width(text, size) <= width) return text;
    let kept = text.length - 1;
    while (kept > 1 && text_width(cut(text, kept), size) > width) --kept;
    return cut(text, kept);
  });
  const beginning = (text: string, kept: number): string => `${text.slice(0, kept).trimEnd()}…`;
  const end = (text: string, kept: number): string => `…${text.slice(-kept).trimStart()}`;
  const tried = [shortened(texts, beginning), shortened(without_shared_words(texts), beginning), shortened(texts, end)];
  return tried.find(apart) ?? [...texts];
}

/** An identifier for links: lower-case words joined by hyphens. */
export function slug(text: string): string {
  return text.toLowerCase().normalize('NFKD').replace(/[^a-z0-9]+/g, '-').replace(/^-+|-+$/g, '') || 'part';
}
