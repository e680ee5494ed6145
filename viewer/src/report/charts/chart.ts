// SPDX-License-Identifier: Apache-2.0
// What a chart is to the figure around it.
import type { Palette } from '../../common/colour';
import type { LegendEntry } from '../../common/legend';
import type { Tip } from '../../common/tooltip';
import type { Column, Made, Row, TableBlock } from '../model';

export interface View {
  width: number;
  /** One of several small charts side by side. */
  compact: boolean;
  hidden: ReadonlySet<string>;
}

/** A thing in the drawing that can be pointed at. */
export interface Target {
  x: number;
  y: number;
  tip(): Tip;
  /** Drawn while it is pointed at. */
  cursor(): SVGElement[];
  /** The runs behind it, under their own title. */
  runs?: Leading | null;
}

/** Where a target leads. */
export interface Leading {
  title: string;
  made: Made;
  /** The title of the figure that shows more of it. */
  see?: string;
}

export interface Drawing {
  svg: SVGSVGElement;
  /** What the arrow keys step through, from left to right. */
  targets: Target[];
  /** The target at a point of the drawing. */
  pick(x: number, y: number): Target | null;
}

export interface Chart {
  legend: LegendEntry[];
  /** One or two sentences for who does not see the drawing. */
  summary: string;
  /** The numbers behind the drawing. */
  data(): TableBlock;
  draw(view: View): Drawing;
  /** The runs behind the drawing as a whole. */
  made?: Made | null;
}

export interface Palettes {
  series: Palette;
  vehicles: Palette;
}

/** The colours of a name: one that is a vehicle's elsewhere on the page has the vehicle's colour everywhere. */
export function palette_of(label: string, { series, vehicles }: Palettes): Palette {
  return vehicles.has(label) ? vehicles : series;
}

/** The numbers behind a chart, as a table; of numbers where a column does not say. */
export function numbers_table(title: string, columns: (readonly [key: string, label: string, type?: Column['type'], unit?: string])[],
                              rows: Row[]): TableBlock {
  return {
    kind: 'table', title, note: '', filter: [], rows,
    columns: columns.map(([key, label, type = 'number', unit = '']) => ({ key, label, unit, type, digits: null })),
  };
}

/** What a target leads to; nothing where the runs are not known. */
export function leads_to(made: Made | null, ...title: string[]): Leading | null {
  return made === null ? null : { title: title.filter((part) => part !== '').join(', '), made };
}

/** The target nearest in x among those within reach; for charts whose targets stand side by side. */
export function pick_along_x(targets: readonly Target[], reach: number): Drawing['pick'] {
  return (x) => {
    let best: Target | null = null;
    let nearest = reach;
    for (const target of targets) {
      const distance = Math.abs(target.x - x);
      if (distance <= nearest) [best, nearest] = [target, distance];
    }
    return best;
  };
}
