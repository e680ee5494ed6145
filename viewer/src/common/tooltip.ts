// SPDX-License-Identifier: Apache-2.0
import { h, swatch } from './dom';

export interface Tip {
  title: string;
  rows: { label: string; value: string; colour?: string }[];
}

// One for the page. It never takes the pointer, and says its text to assistive technology.
const box = h('div', { class: 'tip', role: 'status', 'aria-live': 'polite', hidden: true });
let shown: Tip | null = null;

function fill(tip: Tip): void {
  const rows = tip.rows.map(({ label, value, colour }) => h('tr', {},
    h('th', { scope: 'row' }, colour === undefined ? null : swatch(colour), label), h('td', {}, value)));
  box.replaceChildren(h('b', {}, tip.title), h('table', {}, h('tbody', {}, ...rows)));
}

/** Shows the tip beside a point of the window, on the side where there is room. */
export function show_tip(tip: Tip, x: number, y: number): void {
  if (!box.isConnected) document.body.append(box);
  if (tip !== shown) fill(tip);
  shown = tip;
  box.hidden = false;
  const { width, height } = box.getBoundingClientRect();
  const room = { width: document.documentElement.clientWidth, height: window.innerHeight };
  const gap = 14;
  const left = x + gap + width < room.width - 4 ? x + gap : x - gap - width;
  const top = y - height / 2;
  box.style.left = `${Math.max(4, Math.min(left, room.width - width - 4))}px`;
  box.style.top = `${Math.max(4, Math.min(top, room.height - height - 4))}px`;
}

export function hide_tip(): void {
  box.hidden = true;
  shown = null;
}
