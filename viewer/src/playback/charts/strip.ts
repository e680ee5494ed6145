// SPDX-License-Identifier: Apache-2.0
// Two bands per vehicle over time: how near the metric saw others, and in which mode it went.
import { fit_text, h, swatch } from '../../common/dom';
import type { Tip } from '../../common/tooltip';
import type { Film } from '../film';
import { alerts, modes, type Scene } from '../model';
import { alert_text, mode_text, phase_text, progress_text, shortfall_text } from '../printed';
import { plot_extent } from './plot';
import { TimeArea, type Timeline } from './pointing';
import { colour_now } from './style';

const label_size = 11;
// The worse of what falls on one pixel is what is seen.
const alert_colours = ['var(--alert-clear)', 'var(--alert-detected)', 'var(--alert-collided)'];
const mode_colours = ['var(--mode-cruise)', 'var(--mode-avoid)', 'var(--mode-hold)', 'var(--mode-infeasible)'];

export class Strip {
  readonly element: HTMLElement;
  private readonly canvas = h('canvas', { 'aria-hidden': 'true' });
  private readonly names = h('div', { class: 'strip-names', 'aria-hidden': 'true' });
  private readonly area: TimeArea;
  private readonly row_height: number;
  private width = 0;

  constructor(private readonly scene: Scene, private readonly film: Film, private readonly vehicles: number[],
              private readonly timeline: Timeline) {
    this.row_height = vehicles.length > 16 ? 9 : 17;
    this.area = new TimeArea(timeline, (time, y) => this.tip(time, y));
    this.element = h('section', { class: 'chart-panel strip', 'data-chart': 'strip', 'aria-label': 'Nearness and mode over time' },
      h('div', { class: 'chart-head' }, h('h3', {}, 'State')),
      h('div', { class: 'strip-key' }, ...key('near', alerts, alert_colours), ...key('mode', modes, mode_colours)),
      h('div', { class: 'strip-host' }, this.names, this.canvas, this.area.element));
  }

  lay_out(width: number): void {
    this.width = width;
    const { left, width: inner } = plot_extent(width);
    const height = this.vehicles.length * this.row_height;
    Object.assign(this.canvas.style, { marginLeft: `${left}px`, width: `${inner}px`, height: `${height}px` });
    this.area.place(left, 0, inner, height);
    this.names.replaceChildren(...this.vehicles.map((vehicle, row) => {
      const { name } = this.scene.vehicles[vehicle]!;
      const label = h('span', { title: name }, this.row_height < 12 ? '' : fit_text(name, left - 6, label_size));
      label.style.top = `${row * this.row_height}px`;
      return label;
    }));
    this.refresh();
  }

  refresh(): void {
    const { width } = plot_extent(this.width);
    const ratio = window.devicePixelRatio || 1;
    const columns = Math.max(1, Math.round(width * ratio));
    const row = Math.round(this.row_height * ratio);
    this.canvas.width = columns;
    this.canvas.height = row * this.vehicles.length;
    const context = this.canvas.getContext('2d');
    if (context === null || this.film.count === 0) return;
    const [upper, lower] = [Math.round(row * 0.42), Math.round(row * 0.36)];
    this.vehicles.forEach((vehicle, k) => {
      this.paint(context, 'alert', vehicle, alert_colours, columns, k * row + Math.round(ratio), upper);
      this.paint(context, 'mode', vehicle, mode_colours, columns, k * row + Math.round(ratio) + upper, lower);
    });
  }

  show(time: number): void {
    this.area.show(time);
  }
  point_out(time: number | null): void {
    this.area.point_out(time);
  }

  /** One band: the greatest value that falls on each column of pixels, in runs. */
  private paint(context: CanvasRenderingContext2D, column: 'alert' | 'mode', vehicle: number, colours: string[], columns: number,
                top: number, height: number): void {
    const { film } = this;
    const [from, to] = this.timeline.span.shown;
    const worst = new Int8Array(columns + 1).fill(-1);
    const x_of = (i: number): number => ((film.time(i) - from) / (to - from)) * columns;
    const last = film.index_at(to);
    for (let i = film.index_at(from); i <= last; ++i) {
      const value = film.value(column, i, vehicle);
      const start = Math.max(0, Math.floor(x_of(i)));
      const end = Math.min(columns, i + 1 < film.count ? Math.ceil(x_of(i + 1)) : start + 1);
      for (let x = start; x < end; ++x) if (value > worst[x]!) worst[x] = value;
    }
    const fills = colours.map(colour_now);
    for (let x = 0, begun = 0; x <= columns; ++x) {
      if (x < columns && worst[x] === worst[begun]) continue;
      const fill = fills[worst[begun]!];
      if (fill !== undefined) {
        context.fillStyle = fill;
        context.fillRect(begun, top, x - begun, height);
      }
      begun = x;
    }
  }

  private tip(time: number, y: number): Tip | null {
    const vehicle = this.vehicles[Math.floor(y / this.row_height)];
    if (vehicle === undefined || this.film.count === 0) return null;
    const i = this.film.index_at(time);
    const beyond = shortfall_text(this.film, i, vehicle);
    const standing = progress_text(this.film, i, vehicle, this.scene);
    return {
      title: `${this.scene.vehicles[vehicle]!.name}, t = ${this.film.time(i).toFixed(2)} s`,
      rows: [
        { label: 'near', value: alert_text(this.film, i, vehicle) }, { label: 'mode', value: mode_text(this.film, i, vehicle) },
        { label: 'phase', value: phase_text(this.film, i, vehicle) },
        ...(beyond === '' ? [] : [{ label: 'commanded', value: beyond }]),
        ...(standing === '' ? [] : [{ label: 'progress', value: standing }]),
      ],
    };
  }
}

function key(title: string, words: readonly string[], colours: string[]): HTMLElement[] {
  return [h('b', {}, title), ...words.map((word, k) => h('span', {}, swatch(colours[k]!), word))];
}
