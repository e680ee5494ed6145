// SPDX-License-Identifier: Apache-2.0
// The ways of looking, as a row of switches over the picture.
import { h } from '../common/dom';
import type { Selection } from './selection';
import { camera_keys } from './keys';
import { cameras, type CameraKind, type StageView } from './scene/stage_view';

const names: Record<CameraKind, string> = { orbit: 'Orbit', follow: 'Follow', top: 'Top', side: 'Side' };

export function make_camera_bar(choice: Selection, stage: StageView): HTMLElement {
  const buttons = cameras.map((kind) => h('button', {
    type: 'button', class: 'switch', 'data-camera': kind, title: `${names[kind]} (${camera_keys[kind]})`, click: () => choice.set_camera(kind),
  }, names[kind]));
  const update = (): void => buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(cameras[i] === choice.camera)));
  choice.on_change(update);
  update();
  return h('div', { class: 'cameras', role: 'group', 'aria-label': 'Camera' }, ...buttons,
    h('button', { type: 'button', class: 'switch', title: 'Fit everything into the picture (f)', click: () => stage.fit() }, 'Fit'));
}
