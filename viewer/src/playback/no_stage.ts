// SPDX-License-Identifier: Apache-2.0
import { problem_element } from '../common/problem';
import type { StageView } from './scene/stage_view';

/** In place of the picture, why there is none; everything beside it goes on. */
export function no_stage(host: HTMLElement, reason: string): StageView {
  host.replaceChildren(problem_element(`There is no picture: ${reason}. Lists, charts and times are complete all the same.`));
  const nothing = (): void => undefined;
  return {
    show: nothing, choose: nothing, follow: nothing, set_camera: nothing, set_layer: nothing, fit: nothing, restyle: nothing,
    on_pick: nothing, on_draw: nothing, place_of: () => null, point_of: () => null, place_under: () => null,
    picture: () => Promise.reject(new Error('there is no picture')), frames_per_second: 0,
  };
}
