// SPDX-License-Identifier: Apache-2.0
// One colour, dash and marker per name over the whole page. The colours themselves are in tokens.css,
// chosen to stay apart under the common colour-vision deficiencies in both themes.

export const colour_count = 8;
export type Shape = 'circle' | 'square' | 'triangle' | 'wedge' | 'diamond';
// The diamond is left for published values.
const shapes: Shape[] = ['circle', 'square', 'triangle', 'wedge'];
const dashes = ['', '7 3', '2 3', '9 3 2 3'];

/** The page's colour of the so-many-th series, as the name of a custom property; after the last the first returns. */
export function series_colour(index: number): string {
  return `--c${index % colour_count}`;
}

export class Palette {
  private readonly order = new Map<string, number>();

  /** Names in the order in which they get their colours; a repeated name keeps its first. */
  add(names: Iterable<string>): void {
    for (const name of names) if (!this.order.has(name)) this.order.set(name, this.order.size);
  }
  has(name: string): boolean {
    return this.order.has(name);
  }
  index(name: string): number {
    return this.order.get(name) ?? 0;
  }
  colour(name: string): string {
    return `var(${series_colour(this.index(name))})`;
  }
  /** Beyond the last colour the same ones return, dashed. */
  dash(name: string): string {
    return dashes[Math.floor(this.index(name) / colour_count) % dashes.length]!;
  }
  shape(name: string): Shape {
    const index = this.index(name);
    return shapes[(index + Math.floor(index / colour_count)) % shapes.length]!;
  }
}

/** Outline of a marker about the origin, of the same visual weight for every shape. */
export function shape_path(shape: Shape, radius: number): string {
  const r = radius;
  switch (shape) {
    case 'circle': return `M${-r} 0A${r} ${r} 0 1 1 ${r} 0A${r} ${r} 0 1 1 ${-r} 0Z`;
    case 'square': return `M${-r * 0.9} ${-r * 0.9}H${r * 0.9}V${r * 0.9}H${-r * 0.9}Z`;
    case 'triangle': return `M0 ${-r * 1.2}L${r * 1.1} ${r * 0.85}H${-r * 1.1}Z`;
    case 'wedge': return `M0 ${r * 1.2}L${r * 1.1} ${-r * 0.85}H${-r * 1.1}Z`;
    case 'diamond': return `M0 ${-r * 1.3}L${r * 1.15} 0L0 ${r * 1.3}L${-r * 1.15} 0Z`;
  }
}
