// SPDX-License-Identifier: Apache-2.0
import { h } from '../../common/dom';
import type { Film } from '../film';
import type { Scene } from '../model';
import type { Panel } from '../panel';

export function make_charts(_scene: Scene, film: Film, _seek: (time: number) => void): Panel {
  const element = h('p', { class: 'hint' }, `${film.count} frames`);
  return { element, show: () => undefined, choose: () => undefined, grown: () => undefined, restyle: () => undefined };
}
