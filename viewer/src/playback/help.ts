// SPDX-License-Identifier: Apache-2.0
import { h } from '../common/dom';
import { key_name, type Binding } from './keys';

const pointer = [
  ['Drag', 'turn the picture; with the right button, or two fingers, move it'],
  ['Wheel, pinch', 'nearer and farther'],
  ['Click', 'choose a vehicle; with Shift, one more; on nothing, none'],
];

function row(what: string, does: string): HTMLElement {
  return h('tr', {}, h('th', { scope: 'row' }, h('kbd', {}, what)), h('td', {}, does));
}

/** The overlay that lists the keys and what the pointer does. */
export class Help {
  readonly element: HTMLDialogElement;

  constructor(bindings: Binding[]) {
    const keys = bindings.filter(({ does }) => does !== '').map((binding) => row(key_name(binding), binding.does));
    const close = h('button', { type: 'button', class: 'action', click: () => this.element.close() }, 'Close');
    this.element = h('dialog', { class: 'help', 'aria-label': 'Keys and pointer' },
      h('div', { class: 'help-head' }, h('h2', {}, 'Keys and pointer'), close),
      h('table', {}, h('tbody', {}, ...keys, ...pointer.map(([what, does]) => row(what!, does!)))));
    // A click beside the text closes it too.
    this.element.addEventListener('click', (event) => {
      if (event.target === this.element) this.element.close();
    });
  }

  toggle(): void {
    if (this.element.open) this.element.close();
    else this.element.showModal();
  }
}
