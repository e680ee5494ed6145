// SPDX-License-Identifier: Apache-2.0
// What is written over the picture: placed with every camera, the less important left out where it would overlap.
import { Vector3, type Camera } from 'three';
import { fit_text, h, text_width } from '../../common/dom';

export interface Label {
  text: string;
  at: Vector3;
  kind: 'name' | 'meaning' | 'scale';
  /** A custom property of the page, such as '--c3'. */
  colour?: string;
  /** The greater, the sooner it gets its place; those from 100 on are always shown. */
  rank: number;
  /** Of its left end from the point [px]; without it, centred below. */
  beside_px?: number;
}

/** A label where it ended up, for pictures that are saved. */
export interface PlacedLabel {
  text: string;
  x: number;
  y: number;
  element: HTMLElement;
}

interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

const line_px = 14;
/** Longer texts end in an ellipsis. */
const most_px = 220;
const seen = new Vector3();

/** Pixels of the picture, or null behind the camera. */
export function project(at: Vector3, camera: Camera, width: number, height: number): { x: number; y: number; depth: number } | null {
  seen.copy(at).project(camera);
  if (seen.z < -1 || seen.z > 1) return null;
  return { x: (seen.x + 1) * 0.5 * width, y: (1 - seen.y) * 0.5 * height, depth: seen.z };
}

export class Labels {
  readonly element = h('div', { class: 'stage-labels', 'aria-hidden': 'true' });
  private readonly pool: HTMLElement[] = [];
  private readonly fitted = new Map<string, { text: string; width: number }>();
  placed: PlacedLabel[] = [];

  place(labels: Label[], camera: Camera, width: number, height: number): void {
    const taken: Box[] = [];
    this.placed = [];
    for (const label of [...labels].sort((a, b) => b.rank - a.rank)) {
      const point = project(label.at, camera, width, height);
      if (point === null) continue;
      const { text, width: text_px } = this.fit(label);
      const box = this.box(label, text_px, point.x, point.y);
      if (box.right < 0 || box.left > width || box.bottom < 0 || box.top > height) continue;
      if (label.rank < 100 && taken.some((b) => b.left < box.right && b.right > box.left && b.top < box.bottom && b.bottom > box.top)) continue;
      taken.push(box);
      this.write(label, text, box);
    }
    for (let i = this.placed.length; i < this.pool.length; ++i) this.pool[i]!.style.display = 'none';
  }

  private box(label: Label, width: number, x: number, y: number): Box {
    const left = Math.round(label.beside_px === undefined ? x - width / 2 : label.beside_px < 0 ? x + label.beside_px - width : x + label.beside_px);
    const top = Math.round(label.beside_px === undefined ? y + 11 : y - line_px / 2);
    return { left, top, right: left + width + 3, bottom: top + line_px };
  }

  private fit(label: Label): { text: string; width: number } {
    const key = label.kind + label.text;
    let fitted = this.fitted.get(key);
    if (fitted === undefined) {
      if (this.fitted.size > 2000) this.fitted.clear();
      const weight = label.kind === 'name' ? 600 : 500;
      const text = fit_text(label.text, most_px, 11.5, weight);
      fitted = { text, width: text_width(text, 11.5, weight) };
      this.fitted.set(key, fitted);
    }
    return fitted;
  }

  private write(label: Label, text: string, box: Box): void {
    const i = this.placed.length;
    const element = this.pool[i] ?? this.grow();
    if (element.textContent !== text) element.textContent = text;
    const name = `stage-label ${label.kind}`;
    if (element.className !== name) element.className = name;
    element.style.color = label.colour === undefined ? '' : `var(${label.colour})`;
    element.style.transform = `translate(${box.left}px, ${box.top}px)`;
    element.style.display = '';
    this.placed.push({ text, x: box.left, y: box.top, element });
  }

  private grow(): HTMLElement {
    const element = h('span', { class: 'stage-label' });
    this.pool.push(element);
    this.element.append(element);
    return element;
  }
}
