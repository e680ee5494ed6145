// SPDX-License-Identifier: Apache-2.0
// The key of the picture: what its colours stand for. On a narrow page it is folded, and a button opens it.
import { h, swatch } from '../../common/dom';
import type { KeyLine } from './part';

export class StageKey {
  private readonly lines = h('div', { class: 'lines' });
  private readonly fold = h('button', { type: 'button', class: 'switch', 'aria-expanded': 'false', click: () => this.turn() }, 'Key');
  readonly element = h('div', { class: 'stage-key', hidden: true }, this.lines, this.fold);
  private shown = '';

  /** Does nothing while these are the same. */
  show(lines: readonly KeyLine[]): void {
    const text = JSON.stringify(lines);
    if (text === this.shown) return;
    this.shown = text;
    this.element.hidden = lines.length === 0;
    this.lines.replaceChildren(...lines.map(({ colour, text: said }) =>
      colour === '' ? h('p', {}, said) : h('div', {}, swatch(`var(${colour})`), said)));
  }

  private turn(): void {
    this.fold.setAttribute('aria-expanded', String(this.element.classList.toggle('open')));
  }
}
