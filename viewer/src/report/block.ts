// SPDX-License-Identifier: Apache-2.0
// A block of the document as an element, numbered over the whole page.
import { h } from '../common/dom';
import { legend } from '../common/legend';
import { problem_element } from '../common/problem';
import { boxes_chart } from './charts/boxes';
import type { Chart, Palettes } from './charts/chart';
import { heat_chart } from './charts/heat';
import { intervals_chart } from './charts/intervals';
import { lines_chart } from './charts/lines';
import { raster_chart } from './charts/raster';
import { is_flat, trajectories_chart } from './charts/trajectories';
import { figure, type FigureOptions } from './figure';
import type { Block, ChartBlock, GridBlock } from './model';
import { table } from './table';

export class Numbering {
  private figures = 0;
  private tables = 0;
  figure(): number {
    return ++this.figures;
  }
  table(): number {
    return ++this.tables;
  }
}

export interface Context {
  palettes: Palettes;
  numbering: Numbering;
}

const charts = { boxes: boxes_chart, heat: heat_chart, intervals: intervals_chart, lines: lines_chart, raster: raster_chart, trajectories: trajectories_chart };

function is_chart(block: Block): block is ChartBlock {
  return block.kind in charts;
}

function chart_of(block: ChartBlock, palettes: Palettes): Chart {
  return (charts[block.kind] as (block: ChartBlock, palettes: Palettes) => Chart)(block, palettes);
}

function chart_element(block: ChartBlock, context: Context, within: Partial<FigureOptions> = {}): HTMLElement {
  const number = within.number ?? `Figure ${context.numbering.figure()}`;
  return figure(chart_of(block, context.palettes), {
    id: number.toLowerCase().replace(' ', '-'), number, title: block.title, kind: block.kind,
    compact: false, shared: null, ...within,
  });
}

/** Small charts side by side: one figure with lettered panels and, where they agree, one legend. */
function grid_element(block: GridBlock, context: Context): HTMLElement {
  const drawn = block.blocks.filter(is_chart);
  const compact = block.columns > 2;
  const legends = drawn.map((chart) => chart_of(chart, context.palettes).legend);
  const names = legends.map((entries) => JSON.stringify(entries.filter(({ toggles }) => toggles).map(({ label }) => label)));
  const alike = drawn.length > 1 && new Set(names).size === 1;
  const shared = alike ? { hidden: new Set<string>(), redraws: [] as (() => void)[] } : null;
  const entries = [...new Map(legends.flat().map((entry) => [`${entry.glyph} ${entry.label}`, entry])).values()];

  const number = drawn.length > 0 && drawn.length === block.blocks.length ? context.numbering.figure() : null;
  const panels = block.blocks.map((inner, i) => {
    if (!is_chart(inner)) return block_element(inner, context);
    if (number === null) return chart_element(inner, context, { compact, shared });
    const letter = i < 26 ? String.fromCharCode(97 + i) : String(i + 1);
    return chart_element(inner, context, { compact, shared, number: letter, id: `figure-${number}-${letter}` });
  });
  const area = h('div', { class: `grid${shared === null ? '' : ' even'}` }, ...panels);
  area.style.setProperty('--columns', String(block.columns));
  area.style.setProperty('--least', compact ? '212px' : '330px');
  const head = number === null ? null : h('div', { class: 'head' }, h('p', { class: 'caption' },
    h('a', { class: 'ref', href: `#figure-${number}` }, `Figure ${number}`), h('span', { class: 'title' }, block.title)));
  return h('div', { class: 'grid-figure', id: number === null ? undefined : `figure-${number}` }, head,
    shared === null || entries.length === 0 ? null : legend(entries, shared.hidden, () => shared.redraws.forEach((redraw) => redraw())), area);
}

export function block_element(block: Block, context: Context): HTMLElement {
  switch (block.kind) {
    case 'table': {
      const number = context.numbering.table();
      return table(block, `table-${number}`, `Table ${number}`, context.palettes.series);
    }
    case 'grid': return grid_element(block, context);
    case 'trajectories':
      return is_flat(block) ? chart_element(block, context) : grid_element({
        kind: 'grid', title: block.title, columns: 2,
        blocks: [{ ...block, title: 'From above' }, { ...block, title: 'From the south', side: 'south' }],
      }, context);
    case 'note':
      return h('div', { class: `note ${block.tone}`, role: 'note' },
        h('b', {}, block.tone === 'warning' ? 'Caution' : 'Note'), h('p', {}, block.text));
    case 'problem': return problem_element(block.text);
    default: return chart_element(block, context);
  }
}
