// SPDX-License-Identifier: Apache-2.0
import { h } from '../../common/dom';
import type { Film } from '../film';
import type { Scene } from '../model';
import type { Panel } from '../panel';

export function make_thoughts(_scene: Scene, film: Film): Panel {
  const element = h('p', { class: 'hint' }, film.sketches.any ? 'sketches are there' : 'no sketches');
  return { element, show: () => undefined, choose: () => undefined, grown: () => undefined, restyle: () => undefined };
}
