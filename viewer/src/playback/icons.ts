// SPDX-License-Identifier: Apache-2.0
import { h, s } from '../common/dom';

const shapes = {
  play: 'M7 4.5v15l12.5-7.5Z',
  pause: 'M6 4.5h4.4v15H6ZM13.6 4.5H18v15h-4.4Z',
  back: 'M17.5 5v14L8.5 12ZM5.5 5h2.4v14H5.5Z',
  forward: 'M6.5 5v14l9-7ZM16.1 5h2.4v14h-2.4Z',
  loop: 'M6.2 9.2A6.6 6.6 0 0 1 17 7.4L15.2 9.2H20.5V3.9L18.6 5.8A8.8 8.8 0 0 0 4 9.2ZM17.8 14.8A6.6 6.6 0 0 1 7 16.6L8.8 14.8H3.5v5.3l1.9-1.9A8.8 8.8 0 0 0 20 14.8Z',
  panel: 'M3.5 5h17v14h-17ZM5.3 6.8v10.4h8.4V6.8Z',
  follow: 'M11 2h2v3.1a7 7 0 0 1 5.9 5.9H22v2h-3.1a7 7 0 0 1-5.9 5.9V22h-2v-3.1A7 7 0 0 1 5.1 13H2v-2h3.1A7 7 0 0 1 11 5.1ZM12 7.2a4.8 4.8 0 1 0 0 9.6 4.8 4.8 0 0 0 0-9.6Z',
} as const;
type Icon = keyof typeof shapes;

function icon(name: Icon): SVGElement {
  return s('svg', { class: 'icon', viewBox: '0 0 24 24', 'aria-hidden': 'true' },
    s('path', { d: shapes[name], 'fill-rule': 'evenodd' }));
}

/** A button that shows only a picture; `label` is its name and its tip, with the key that does the same. */
export function icon_button(name: Icon, label: string, key: string, action: () => void): HTMLButtonElement {
  return h('button', { type: 'button', class: 'tool', 'aria-label': label, title: key === '' ? label : `${label} (${key})`, click: action }, icon(name));
}

/** Another picture and name, as play becomes pause. */
export function set_icon(button: HTMLButtonElement, name: Icon, label: string, key: string): void {
  if (button.getAttribute('aria-label') === label) return;
  button.replaceChildren(icon(name));
  button.setAttribute('aria-label', label);
  button.title = `${label} (${key})`;
}
