// SPDX-License-Identifier: Apache-2.0
// Hands on a chart: a click or drag moves the moment, a wheel with Ctrl or Shift zooms, a double click shows all.
import { h } from '../../common/dom';
import { hide_tip, show_tip, type Tip } from '../../common/tooltip';
import type { Span } from './span';

export interface Timeline {
  span: Span;
  seek(time: number): void;
  /** The time pointed at, to be marked in every chart; null when the pointer has left. */
  hover(time: number | null): void;
}

/** An area whose width is the span: it shows the moment and what is pointed at, and takes the pointer. */
export class TimeArea {
  readonly element = h('div', { class: 'time-area' });
  private readonly now = h('i', { class: 'now', 'aria-hidden': 'true' });
  private readonly pointed = h('i', { class: 'pointed', 'aria-hidden': 'true' });
  private width = 0;

  constructor(private readonly timeline: Timeline, private readonly tip: (time: number, y: number) => Tip | null) {
    this.element.append(this.pointed, this.now);
    this.element.addEventListener('pointerdown', (event) => this.down(event));
    this.element.addEventListener('pointermove', (event) => this.move(event));
    this.element.addEventListener('pointerleave', () => this.leave());
    this.element.addEventListener('pointercancel', () => this.leave());
    this.element.addEventListener('dblclick', () => timeline.span.reset());
    this.element.addEventListener('wheel', (event) => this.turn(event), { passive: false });
  }

  place(left: number, top: number, width: number, height: number): void {
    this.width = width;
    Object.assign(this.element.style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
  }

  /** A run that goes on is a little ahead of its charts: its moment is at their end. */
  show(time: number): void {
    const { span } = this.timeline;
    this.put(this.now, span.is_zoomed ? time : Math.min(time, span.shown[1]));
  }

  point_out(time: number | null): void {
    if (time === null) this.pointed.hidden = true;
    else this.put(this.pointed, time);
  }

  private put(mark: HTMLElement, time: number): void {
    const [from, to] = this.timeline.span.shown;
    const x = ((time - from) / (to - from)) * this.width;
    mark.hidden = !(x >= -0.5 && x <= this.width + 0.5);
    if (!mark.hidden) mark.style.transform = `translateX(${x.toFixed(1)}px)`;
  }

  private time_at(event: MouseEvent): number {
    const frame = this.element.getBoundingClientRect();
    const [from, to] = this.timeline.span.shown;
    const part = Math.min(Math.max((event.clientX - frame.left) / (frame.width || 1), 0), 1);
    return from + part * (to - from);
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0) return;
    // Pointers made up by scripts cannot be captured.
    if (event.isTrusted) this.element.setPointerCapture(event.pointerId);
    this.timeline.seek(this.time_at(event));
  }

  private move(event: PointerEvent): void {
    const time = this.time_at(event);
    if ((event.buttons & 1) !== 0) this.timeline.seek(time);
    if (event.pointerType !== 'mouse') return;
    this.timeline.hover(time);
    const tip = this.tip(time, event.clientY - this.element.getBoundingClientRect().top);
    if (tip === null) hide_tip();
    else show_tip(tip, event.clientX, event.clientY);
  }

  private leave(): void {
    this.timeline.hover(null);
    hide_tip();
  }

  private turn(event: WheelEvent): void {
    if (!event.ctrlKey && !event.shiftKey) return;
    event.preventDefault();
    const by = event.deltaY !== 0 ? event.deltaY : event.deltaX;
    this.timeline.span.zoom(Math.exp(Math.sign(by) * Math.min(Math.abs(by), 100) * 0.004), this.time_at(event));
  }
}
