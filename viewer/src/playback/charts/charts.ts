// SPDX-License-Identifier: Apache-2.0
// Charts in step with the picture: the reader picks which; they share their time, and a click in one moves it.
import 'uplot/dist/uPlot.min.css';
import './charts.css';
import { h, s } from '../../common/dom';
import type { Film, Moment } from '../film';
import type { Scene } from '../model';
import type { Panel } from '../panel';
import { chart_kinds, type ChartKind, type Shown } from './curves';
import { Plot } from './plot';
import type { Timeline } from './pointing';
import { Span } from './span';
import { Strip } from './strip';
import { forget_colours, vehicle_palette } from './style';

const grown_every_ms = 300;
const zoom_step = 0.5;

type Key = ChartKind['key'] | 'strip';

/** Whether anything but zero has come in a column; each frame is looked at once. */
class Awaited {
  private seen = 0;
  private found = false;
  constructor(private readonly film: Film, private readonly column: string) {}
  get has_come(): boolean {
    if (this.seen > this.film.count) this.seen = 0;
    const width = this.film.width(this.column) * this.film.vehicles;
    for (; !this.found && this.seen < this.film.count; ++this.seen) {
      for (let k = 0; k < width; ++k) if (this.film.value(this.column, this.seen, 0, k) !== 0) this.found = true;
    }
    return this.found;
  }
}

class Charts implements Panel {
  readonly element: HTMLElement;
  private readonly chips = h('div', { class: 'chips', role: 'group', 'aria-label': 'Charts' });
  private readonly stack = h('div', { class: 'chart-stack' });
  private readonly names = h('ul', { class: 'vehicle-key', 'aria-label': 'Vehicles' });
  private readonly whole = h('button', {
    type: 'button', class: 'chip', title: 'Show the whole run (double click)', hidden: true,
  }, 'Whole run');
  private readonly span = new Span(() => this.redraw());
  private readonly timeline: Timeline;
  private readonly palette;
  private readonly awaited: Map<string, Awaited>;
  private readonly open = new Set<Key>([...chart_kinds.filter((kind) => kind.open).map(({ key }) => key), 'strip']);
  private offered = '';
  private plots: (Plot | Strip)[] = [];
  private chosen: ReadonlySet<number> = new Set();
  private width = 0;
  private time = 0;
  private redraw_at = 0;

  constructor(private readonly scene: Scene, private readonly film: Film, seek: (time: number) => void) {
    this.palette = vehicle_palette(scene.vehicles);
    this.awaited = new Map(chart_kinds.flatMap(({ needs }) => (needs === null ? [] : [[needs, new Awaited(film, needs)] as const])));
    this.timeline = {
      span: this.span, seek,
      hover: (time) => this.plots.forEach((plot) => plot.point_out(time)),
    };
    this.whole.addEventListener('click', () => this.span.reset());
    this.element = h('div', { class: 'charts' },
      this.chips, h('div', { class: 'charts-bar' }, this.names,
        h('div', { class: 'chips zoom', role: 'group', 'aria-label': 'Stretch of time' }, this.whole,
          this.zoom_button('−', 'Show a longer stretch of time (Ctrl and wheel)', 1 / zoom_step),
          this.zoom_button('+', 'Show a shorter stretch about the moment (Ctrl and wheel)', zoom_step))),
      this.stack);
    this.span.grow(film.count > 0 ? film.time(0) : 0, film.end);
    this.offer();
    new ResizeObserver(() => this.fit()).observe(this.stack);
  }

  show({ time }: Moment): void {
    if (time === this.time) return;
    this.time = time;
    this.span.keep_in_view(time);
    for (const plot of this.plots) plot.show(time);
  }

  choose(vehicles: ReadonlySet<number>): void {
    this.chosen = new Set(vehicles);
    this.rebuild();
  }

  /** Draws what has come in a few times a second, however often it comes. */
  grown(): void {
    if (this.redraw_at !== 0) return;
    this.redraw_at = window.setTimeout(() => {
      this.redraw_at = 0;
      this.span.grow(this.film.count > 0 ? this.film.time(0) : 0, this.film.end);
      if (!this.offer()) this.redraw();
    }, grown_every_ms);
  }

  restyle(): void {
    forget_colours();
    this.width = this.stack.clientWidth;
    this.lay_out();
  }

  private zoom_button(label: string, title: string, factor: number): HTMLButtonElement {
    const button = h('button', { type: 'button', class: 'chip', title, 'aria-label': title }, label);
    button.addEventListener('click', () => {
      const [from, to] = this.span.shown;
      this.span.zoom(factor, this.time >= from && this.time <= to ? this.time : (from + to) / 2);
    });
    return button;
  }

  /** Buttons of the charts that have something to show; true when there are others now. */
  private offer(): boolean {
    const kinds = chart_kinds.filter(({ needs }) => needs === null || this.awaited.get(needs)!.has_come);
    const entries: [Key, string][] = [...kinds.map(({ key, title }): [Key, string] => [key, title]), ['strip', 'State']];
    const offered = entries.map(([key]) => key).join();
    if (offered === this.offered) return false;
    this.offered = offered;
    this.chips.replaceChildren(...entries.map(([key, title]) => this.chip(key, title)));
    this.rebuild();
    return true;
  }

  private chip(key: Key, title: string): HTMLButtonElement {
    const button = h('button', { type: 'button', class: 'chip', 'aria-pressed': String(this.open.has(key)), 'data-chart': key }, title);
    button.addEventListener('click', () => {
      if (!this.open.delete(key)) this.open.add(key);
      button.setAttribute('aria-pressed', String(this.open.has(key)));
      this.rebuild(this.plots);
    });
    return button;
  }

  private shown(): Shown {
    const chosen = [...this.chosen].filter((vehicle) => vehicle < this.scene.vehicles.length).sort((a, b) => a - b);
    const vehicles = chosen.length > 0 ? chosen : this.scene.vehicles.map((_, k) => k);
    return { vehicles, alone: vehicles.length === 1 ? vehicles[0]! : null };
  }

  /** The charts that are open, in their order; those of `kept` are as they have to be. */
  private rebuild(kept: (Plot | Strip)[] = []): void {
    const shown = this.shown();
    const offered = new Set(this.offered.split(','));
    for (const plot of this.plots) if (plot instanceof Plot) plot.destroy();
    const plot_of = (kind: ChartKind): Plot => kept.find((plot): plot is Plot => plot instanceof Plot && plot.kind === kind) ??
      new Plot(kind, kind.curves(this.scene, this.film, shown), this.film, this.palette, this.timeline);
    this.plots = chart_kinds.filter(({ key }) => this.open.has(key) && offered.has(key)).map(plot_of).filter((plot) => plot.has_curves);
    if (this.open.has('strip')) this.plots.push(new Strip(this.scene, this.film, shown.vehicles, this.timeline));
    this.stack.replaceChildren(...this.plots.map(({ element }) => element));
    if (this.plots.length === 0) this.stack.append(h('p', { class: 'hint' }, 'Pick a chart above.'));
    this.name_vehicles(shown);
    this.lay_out();
  }

  private name_vehicles({ vehicles, alone }: Shown): void {
    const named = alone === null ? vehicles : this.scene.vehicles.map((_, k) => k);
    this.names.replaceChildren(...named.map((vehicle) => h('li', { class: vehicle === alone ? 'alone' : undefined },
      s('svg', { viewBox: '0 0 18 8', width: 18, height: 8, 'aria-hidden': 'true' }, s('line', {
        class: 'key-line', colour: this.palette.colour(String(vehicle)), x1: 0, x2: 18, y1: 4, y2: 4,
        'stroke-dasharray': this.palette.dash(String(vehicle)) || undefined,
      })), h('span', { title: this.scene.vehicles[vehicle]!.name }, this.scene.vehicles[vehicle]!.name))));
  }

  private fit(): void {
    const width = Math.floor(this.stack.clientWidth);
    if (width === this.width) return;
    this.width = width;
    this.lay_out();
  }

  /** Draws every chart anew, unless the panel is out of sight. */
  private lay_out(): void {
    if (this.width <= 0) return;
    const last = this.plots.findLastIndex((plot) => plot instanceof Plot);
    this.plots.forEach((plot, k) => {
      plot.lay_out(this.width, k === last);
      plot.show(this.time);
      plot.point_out(null);
    });
  }

  private redraw(): void {
    this.whole.hidden = !this.span.is_zoomed;
    if (this.width <= 0) return;
    for (const plot of this.plots) {
      plot.refresh();
      plot.show(this.time);
    }
  }
}

/** Charts of a film; `seek` moves the moment that all of the page shows. */
export function make_charts(scene: Scene, film: Film, seek: (time: number) => void): Required<Panel> {
  return new Charts(scene, film, seek);
}
