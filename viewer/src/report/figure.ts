// SPDX-License-Identifier: Apache-2.0
// The frame around a chart: caption, legend, buttons, the drawing at the width there is, and pointing at it.
import { h, s, slug } from '../common/dom';
import { legend, type LegendEntry } from '../common/legend';
import { reason_of } from '../common/reason';
import { action_button, save_text } from '../common/save';
import { standalone_svg } from '../common/saved_svg';
import { hide_tip, show_tip } from '../common/tooltip';
import type { Chart, Drawing, Target } from './charts/chart';
import { to_csv } from './csv';
import { count_of, show_runs } from './runs_panel';
import { table_body } from './table';

export interface FigureOptions {
  id: string;
  number: string;
  title: string;
  kind: string;
  compact: boolean;
  /** The names hidden in several figures at once, and who must be told to redraw. */
  shared: { hidden: Set<string>; redraws: (() => void)[] } | null;
}

class Plot {
  readonly element: HTMLElement;
  private readonly cursor = s('g', { class: 'cursor', 'aria-hidden': 'true' });
  private drawing: Drawing | null = null;
  private selected = -1;
  private target: Target | null = null;
  private pressed = { x: 0, y: 0, ready: true };
  private width = 0;

  constructor(private readonly chart: Chart, private readonly hidden: Set<string>, private readonly compact: boolean,
              label: string) {
    this.element = h('div', { class: 'plot', tabindex: 0, role: 'group', 'aria-label': `${label}. ${chart.summary}` });
    this.element.addEventListener('pointermove', (event) => this.point_at(event));
    this.element.addEventListener('pointerleave', () => this.leave());
    this.element.addEventListener('pointerdown', (event) => this.press(event));
    this.element.addEventListener('click', (event) => this.choose(event));
    this.element.addEventListener('keydown', (event) => this.step(event));
    this.element.addEventListener('blur', () => this.leave());
    new ResizeObserver(() => {
      const width = Math.floor(this.element.clientWidth);
      // Before printing the page is laid out anew; the drawing scales with its view box then.
      if (width > 0 && width !== this.width) this.redraw(width);
    }).observe(this.element);
  }

  svg(): SVGSVGElement | null {
    return this.drawing?.svg ?? null;
  }

  redraw(width = this.width): void {
    if (width <= 0) return;
    this.width = width;
    this.leave();
    try {
      this.drawing = this.chart.draw({ width, compact: this.compact, hidden: this.hidden });
    } catch (error) {
      this.drawing = null;
      this.element.replaceChildren(h('p', { class: 'problem' },
        `This chart cannot be drawn: ${reason_of(error)}.`));
      return;
    }
    const { svg } = this.drawing;
    svg.setAttribute('role', 'img');
    svg.setAttribute('aria-label', this.chart.summary);
    svg.append(this.cursor);
    this.element.replaceChildren(svg);
  }

  private leave(): void {
    this.selected = -1;
    this.target = null;
    this.element.classList.remove('leads');
    this.cursor.replaceChildren();
    hide_tip();
  }

  private show(target: Target, x: number, y: number): void {
    this.target = target;
    this.cursor.replaceChildren(...target.cursor());
    this.element.classList.toggle('leads', target.runs != null);
    const tip = target.tip();
    if (target.runs != null) tip.rows.push({ label: 'click or Enter', value: `lists ${count_of(target.runs.made)}` });
    show_tip(tip, x, y);
  }

  /** A finger first shows what it points at and then, at the same place, where that leads. */
  private press(event: PointerEvent): void {
    const before = this.element.classList.contains('leads') ? this.cursor.innerHTML : '';
    this.point_at(event);
    this.pressed = {
      x: event.clientX, y: event.clientY,
      ready: event.pointerType !== 'touch' || (before !== '' && before === this.cursor.innerHTML),
    };
  }

  private choose(event: MouseEvent): void {
    const moved = Math.hypot(event.clientX - this.pressed.x, event.clientY - this.pressed.y);
    if (moved < 6 && this.pressed.ready) this.open();
  }

  private open(): void {
    const runs = this.target?.runs;
    if (runs == null) return;
    this.leave();
    show_runs(runs.title, runs.made, runs.see);
  }

  private point_at(event: PointerEvent): void {
    if (this.drawing === null || (event.buttons !== 0 && event.pointerType === 'mouse')) return;
    const frame = this.drawing.svg.getBoundingClientRect();
    const part = this.drawing.svg.viewBox.baseVal.width / (frame.width || 1);
    const target = this.drawing.pick((event.clientX - frame.left) * part, (event.clientY - frame.top) * part);
    if (target === null) return this.leave();
    this.selected = this.drawing.targets.indexOf(target);
    this.show(target, event.clientX, event.clientY);
  }

  /** Arrow keys go from one mark to the next. */
  private step(event: KeyboardEvent): void {
    const targets = this.drawing?.targets ?? [];
    if (event.key === 'Escape') return this.leave();
    if (event.key === 'Enter') {
      // Else the same key would press the first button of what opens.
      event.preventDefault();
      return this.open();
    }
    if (targets.length === 0 || (event.key !== 'ArrowRight' && event.key !== 'ArrowLeft')) return;
    event.preventDefault();
    const by = event.key === 'ArrowRight' ? 1 : -1;
    this.selected = this.selected < 0 ? (by > 0 ? 0 : targets.length - 1)
      : (this.selected + by + targets.length) % targets.length;
    const target = targets[this.selected]!;
    const frame = this.drawing!.svg.getBoundingClientRect();
    this.show(target, frame.left + target.x, frame.top + target.y);
  }
}

/** A button that unfolds the numbers behind the chart, made when they are first asked for. */
function data_button(chart: Chart, panel: HTMLElement): HTMLButtonElement {
  const button = h('button', {
    type: 'button', class: 'action', 'aria-expanded': 'false', 'aria-controls': panel.id,
    title: 'Show the numbers behind this chart', 'aria-label': 'Show the numbers behind this chart',
  }, 'Data');
  button.addEventListener('click', () => {
    if (panel.childElementCount === 0) {
      const data = chart.data();
      panel.append(table_body(data, `${data.title}, data`).element);
    }
    panel.hidden = !panel.hidden;
    button.setAttribute('aria-expanded', String(!panel.hidden));
  });
  return button;
}

/** Where one run or a few made the whole drawing. */
function runs_button(chart: Chart, title: string): HTMLButtonElement | null {
  const made = chart.made ?? null;
  if (made === null) return null;
  const button = h('button', {
    type: 'button', class: 'action', 'aria-haspopup': 'dialog', title: 'Show the runs that made this chart',
    'aria-label': 'Show the runs that made this chart',
  }, made.runs.length === 1 ? 'Run' : 'Runs');
  button.addEventListener('click', () => show_runs(title, made));
  return button;
}

export function figure(chart: Chart, options: FigureOptions): HTMLElement {
  const { id, number, title, compact, shared } = options;
  const hidden = shared?.hidden ?? new Set<string>();
  const plot = new Plot(chart, hidden, compact, title || number);
  const redraw = (): void => plot.redraw();
  shared?.redraws.push(redraw);

  const name = slug(title || id);
  const shown_entries = (): LegendEntry[] => chart.legend.filter(({ label }) => !hidden.has(label));
  const save = action_button('SVG', 'Save this chart as SVG', 'saved', () => {
    const svg = plot.svg();
    if (svg === null) return false;
    save_text(`${name}.svg`, 'image/svg+xml', standalone_svg(svg, title, shown_entries()));
    return true;
  });
  const csv = action_button('CSV', 'Save the numbers behind this chart as CSV', 'saved', () => {
    const data = chart.data();
    save_text(`${name}.csv`, 'text/csv', to_csv(data, data.rows));
  });
  const runs = runs_button(chart, title || number);
  const panel = h('div', { class: 'data-panel', id: `${id}-data`, hidden: true });

  const caption = h('figcaption', {},
    number === '' ? null : h('a', { class: 'ref', href: `#${id}` }, number), h('span', { class: 'title' }, title));
  const own_legend = shared === null && chart.legend.length > 0;
  return h('figure', { class: `figure chart-${options.kind}${compact ? ' compact' : ''}${own_legend ? ' own-legend' : ''}`, id },
    h('div', { class: 'head' }, caption, h('div', { class: 'actions' }, runs, data_button(chart, panel), csv, save)),
    own_legend ? legend(chart.legend, hidden, redraw) : null,
    plot.element, panel);
}
