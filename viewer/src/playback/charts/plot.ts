// SPDX-License-Identifier: Apache-2.0
// One chart over time: uPlot draws the curves, once per change of what is to be seen; the moment is a line above it.
import uPlot from 'uplot';
import type { Palette } from '../../common/colour';
import { h, slug } from '../../common/dom';
import { fixed, short } from '../../common/format';
import { action_button, save_text } from '../../common/save';
import { multiples, tick_digits } from '../../common/scale';
import type { Tip } from '../../common/tooltip';
import type { Film } from '../film';
import type { ChartKind, Curves } from './curves';
import { curves_csv } from './csv';
import { TimeArea, type Timeline } from './pointing';
import { curves_svg } from './saved';
import { Store } from './store';
import { colour_now, dash_of } from './style';
import { told, value_domain, value_step } from './values';

const axis_width = 56;
const right_margin = 10;
const plot_height = 112;
const time_axis_height = 38;
const most_rows = 12;
const widths = { full: 1.6, faint: 1.2, dashed: 1.6, dotted: 1.8 };
const font = '11px "Fairway Sans", system-ui, sans-serif';

/** Where the curves lie across a panel of a width [px]. */
export function plot_extent(width: number): { left: number; width: number } {
  return { left: axis_width, width: Math.max(width - axis_width - right_margin, 40) };
}

export class Plot {
  readonly element: HTMLElement;
  private readonly host = h('div', { class: 'plot-host' });
  private readonly area: TimeArea;
  private readonly store: Store;
  private chart: uPlot | null = null;
  private width = 0;

  constructor(readonly kind: ChartKind, private readonly curves: Curves, private readonly film: Film,
              private readonly palette: Palette, private readonly timeline: Timeline) {
    this.store = new Store(film, curves);
    this.area = new TimeArea(timeline, (time) => this.tip(time));
    this.element = h('section', { class: 'chart-panel', 'data-chart': kind.key, 'aria-label': `${kind.title} over time` },
      h('div', { class: 'chart-head' }, h('h3', {}, kind.title), h('span', { class: 'chart-note' }, curves.note), this.actions()),
      this.host);
  }

  get has_curves(): boolean {
    return this.curves.series.length > 0;
  }

  /** Draws anew for a width [px]; the last chart of a stack tells the times for all. */
  lay_out(width: number, tells_time: boolean): void {
    this.width = width;
    this.chart?.destroy();
    this.store.update();
    const height = plot_height + (tells_time ? time_axis_height : 8);
    this.chart = new uPlot(this.options(width, height, tells_time), this.data(), this.host);
    const { left, width: inner } = plot_extent(width);
    this.area.place(left, 6, inner, plot_height - 6);
    this.host.append(this.area.element);
  }

  /** Frames have come in, or another stretch is to be seen. */
  refresh(): void {
    this.store.update();
    this.chart?.setData(this.data());
  }

  show(time: number): void {
    this.area.show(time);
  }
  point_out(time: number | null): void {
    this.area.point_out(time);
  }
  destroy(): void {
    this.chart?.destroy();
  }

  private data(): uPlot.AlignedData {
    const [from, to] = this.timeline.span.shown;
    const { times, columns } = this.store.thinned(from, to, plot_extent(this.width).width);
    return [times, ...columns.map(with_gaps)];
  }

  private options(width: number, height: number, tells_time: boolean): uPlot.Options {
    const { curves, kind, timeline } = this;
    const [ink, line] = [colour_now('var(--ink-2)'), colour_now('var(--line)')];
    const values_domain = (self: uPlot): [number, number] => {
      const ends = self.series.slice(1).flatMap(({ min, max }) => [min ?? Number.NaN, max ?? Number.NaN]);
      return value_domain(kind.key, [...ends, ...curves.rules.map(({ value }) => value)]);
    };
    const axis = { stroke: ink, font, labelFont: font, ticks: { show: false }, gap: 5 };
    const grid = { stroke: line, width: 1 };
    return {
      width, height, padding: [6, right_margin, tells_time ? 0 : 8, 0],
      legend: { show: false }, cursor: { show: false }, select: { show: false, left: 0, top: 0, width: 0, height: 0 },
      scales: {
        x: { time: false, range: () => [...timeline.span.shown] },
        y: { range: values_domain, dir: kind.key === 'depth' ? -1 : 1 },
      },
      axes: [
        { ...axis, grid, space: 60, size: tells_time ? 20 : 0,
          ...(tells_time ? { label: 'time [s]', labelSize: 18, labelGap: 0, values: tell } : { values: () => [] }) },
        { ...axis, grid, size: axis_width - 18, label: curves.axis, labelSize: 18, labelGap: 2,
          splits: (_, __, low, high) => multiples(low, high, value_step(kind.key, [low, high])),
          values: (_, at) => tell(_, at.map((value) => told(kind.key, value))) },
      ],
      series: [{}, ...curves.series.map((series): uPlot.Series => ({
        stroke: colour_now(this.palette.colour(String(series.vehicle))), width: widths[series.look],
        dash: dash_of(series, this.palette).split(' ').filter(Boolean).map(Number),
        alpha: series.look === 'faint' ? 0.45 : 1, points: { show: false }, spanGaps: false,
      }))],
      hooks: { drawAxes: [(self) => this.draw_rules(self)], draw: [(self) => this.name_rules(self)] },
    };
  }

  private draw_rules(self: uPlot): void {
    const { ctx, bbox } = self;
    const ratio = uPlot.pxRatio;
    const right = bbox.left + bbox.width;
    ctx.save();
    ctx.strokeStyle = colour_now('var(--limit)');
    ctx.lineWidth = 1.2 * ratio;
    ctx.setLineDash([5 * ratio, 4 * ratio]);
    for (const { value } of this.curves.rules) {
      const y = self.valToPos(value, 'y', true);
      ctx.stroke(new Path2D(`M${bbox.left} ${y}H${right}`));
    }
    ctx.restore();
  }

  /** Side by side, for the rules may lie close together. */
  private name_rules(self: uPlot): void {
    const { ctx, bbox } = self;
    const ratio = uPlot.pxRatio;
    let x = bbox.left + bbox.width - 2 * ratio;
    ctx.save();
    ctx.font = font.replace('11px', `${10.5 * ratio}px`);
    ctx.textAlign = 'right';
    ctx.lineJoin = 'round';
    ctx.lineWidth = 3 * ratio;
    ctx.strokeStyle = colour_now('var(--ground)');
    ctx.fillStyle = colour_now('var(--limit)');
    for (const { label, value } of this.curves.rules) {
      const text = `${label} ${short(value)} ${this.kind.unit}`;
      const line = self.valToPos(value, 'y', true);
      const y = line < bbox.top + 12 * ratio ? line + 11 * ratio : line - 3 * ratio;
      ctx.strokeText(text, x, y);
      ctx.fillText(text, x, y);
      x -= ctx.measureText(text).width + 8 * ratio;
    }
    ctx.restore();
  }

  private tip(time: number): Tip | null {
    if (this.film.count === 0) return null;
    this.store.update();
    const i = this.film.index_at(time);
    const rows = this.curves.series.map((series, k) => ({ series, value: this.store.value(k, i) }))
      .filter(({ value }) => Number.isFinite(value));
    if (this.kind.key === 'separation') rows.sort((a, b) => a.value - b.value);
    const shown = rows.slice(0, most_rows).map(({ series, value }) => ({
      label: series.label, value: `${fixed(told(this.kind.key, value), 2)} ${this.kind.unit}`,
      colour: this.palette.colour(String(series.vehicle)),
    }));
    if (rows.length > most_rows) shown.push({ label: `and ${rows.length - most_rows} more`, value: '', colour: 'transparent' });
    return { title: `t = ${fixed(this.film.time(i), 2)} s`, rows: shown };
  }

  private actions(): HTMLElement {
    const name = slug(this.kind.title);
    return h('span', { class: 'panel-actions' },
      action_button('CSV', `Save ${this.kind.title.toLowerCase()} at every frame as CSV`, 'saved', () => {
        this.store.update();
        save_text(`${name}.csv`, 'text/csv', curves_csv(this.kind, this.curves, this.store));
      }),
      action_button('SVG', `Save the chart of ${this.kind.title.toLowerCase()} as SVG`, 'saved', () => {
        this.store.update();
        save_text(`${name}.svg`, 'image/svg+xml', curves_svg(this.kind, this.curves, this.store, this.timeline.span.shown, this.palette));
      }));
  }
}

/** uPlot leaves a gap at null, which a typed array cannot hold. */
function with_gaps(values: Float64Array): Float64Array | (number | null)[] {
  return values.some(Number.isNaN) ? Array.from(values, (value) => (Number.isNaN(value) ? null : value)) : values;
}

function tell(_: uPlot, at: number[]): string[] {
  const digits = tick_digits(at);
  return at.map((value) => fixed(value, digits));
}
