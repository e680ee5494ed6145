// SPDX-License-Identifier: Apache-2.0
import { h } from '../../common/dom';
import type { Explanation, Scene } from '../model';

export function make_explanation(explanation: Explanation, _scene: Scene, seek: (time: number) => void): HTMLElement {
  return h('div', {}, h('p', {}, explanation.headline),
    h('button', { type: 'button', class: 'action', click: () => seek(explanation.time_s) }, 'Go there'));
}
