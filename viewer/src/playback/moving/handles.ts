// SPDX-License-Identifier: Apache-2.0
// Starts, goals and corners of obstacles as handles over the picture, moved with the pointer or with keys.
import './handles.css';
import { h } from '../../common/dom';
import type { Vec3 } from '../model';
import { vehicle_colour } from '../printed';
import type { StageView } from '../scene/stage_view';
import type { Handle } from '../source';

/** Places are whole multiples of this [m]. */
const grain_m = 0.1;
const key_step_m = 0.5;

const rounded = (x: number): number => Number((Math.round(x / grain_m) * grain_m).toFixed(1));
const place_of = ([n = 0, e = 0, d = 0]: readonly number[]): Vec3 => [n, e, d];

/** What a key moves it by: north, east, down; null: nothing. */
function step_of({ key, shiftKey }: KeyboardEvent): Vec3 | null {
  if (key === 'ArrowUp') return shiftKey ? [0, 0, -key_step_m] : [key_step_m, 0, 0];
  if (key === 'ArrowDown') return shiftKey ? [0, 0, key_step_m] : [-key_step_m, 0, 0];
  if (key === 'ArrowRight') return [0, key_step_m, 0];
  if (key === 'ArrowLeft') return [0, -key_step_m, 0];
  return null;
}

export class Handles {
  readonly element = h('div', { class: 'handles' });
  private readonly tip = h('div', { class: 'handle-tip', role: 'status' });
  private readonly shown: { button: HTMLElement; at: () => Vec3 }[] = [];

  /** `moved` hears of each that was let go of elsewhere. */
  constructor(private readonly stage: StageView, private readonly moved: (path: string, position_m: readonly number[]) => void) {
    stage.on_draw(() => this.place());
  }

  show(handles: readonly Handle[]): void {
    this.shown.length = 0;
    this.tip.textContent = '';
    this.element.replaceChildren(...handles.map((handle) => this.make(handle)), this.tip);
    this.place();
  }

  private place(): void {
    for (const { button, at } of this.shown) {
      const point = this.stage.point_of(at());
      button.hidden = point === null;
      if (point !== null) button.style.transform = `translate(${point.x.toFixed(1)}px, ${point.y.toFixed(1)}px)`;
    }
  }

  private make(handle: Handle): HTMLElement {
    const what = handle.what === 'obstacle' ? handle.name : `${handle.what} of ${handle.name}`;
    const deep = handle.position_m.length > 2;
    const button = h('button', {
      type: 'button', class: `handle ${handle.what}`, 'aria-label': `Move the ${what}`,
      title: `${what}: drag it${deep ? ', with Shift up and down' : ''}; or arrow keys and Enter`,
    });
    if (handle.vehicle !== null) button.style.setProperty('--k', vehicle_colour(handle.vehicle));
    let at = place_of(handle.position_m);
    const go = (to: Vec3): void => {
      at = [rounded(to[0]), rounded(to[1]), rounded(to[2])];
      this.tip.textContent = `${what}: ${at[0]} m north, ${at[1]} m east${deep ? `, ${at[2]} m deep` : ''}`;
      this.place();
    };
    const let_go = (): void => {
      const now = at.slice(0, handle.position_m.length);
      if (now.some((x, k) => x !== handle.position_m[k])) this.moved(handle.path, now);
    };
    button.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      button.focus();
      button.setPointerCapture(event.pointerId);
    });
    button.addEventListener('pointermove', (event) => {
      if (!button.hasPointerCapture(event.pointerId)) return;
      const { left, top } = this.element.getBoundingClientRect();
      const to = this.stage.place_under(event.clientX - left, event.clientY - top, at, deep && event.shiftKey);
      if (to !== null) go(deep ? to : [to[0], to[1], at[2]]);
    });
    button.addEventListener('pointerup', let_go);
    button.addEventListener('keydown', (event) => {
      const step = step_of(event);
      if (step === null && event.key !== 'Enter') return;
      event.preventDefault();
      if (step === null) let_go();
      else go([at[0] + step[0], at[1] + step[1], at[2] + (deep ? step[2] : 0)]);
    });
    this.shown.push({ button, at: () => at });
    return button;
  }
}
