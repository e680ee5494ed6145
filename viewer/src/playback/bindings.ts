// SPDX-License-Identifier: Apache-2.0
// Which key does what.
import type { Selection } from './selection';
import type { Clock } from './clock';
import type { Film } from './film';
import { camera_keys, layer_keys, type Binding } from './keys';
import { cameras, layers, type CameraKind, type StageView } from './scene/stage_view';

const looks: Record<CameraKind, string> = {
  orbit: 'turn freely about the scene', follow: 'behind the vehicle', top: 'from above, north up', side: 'from the south',
};

function time_keys(film: Film, clock: Clock): Binding[] {
  return [
    { keys: [' '], does: 'play, pause', run: () => clock.toggle() },
    { keys: ['arrowleft', 'arrowright'], shown: 'Left Right', does: 'one frame', shift: false, run: (key) => clock.step(key === 'arrowleft' ? -1 : 1) },
    { keys: ['arrowleft', 'arrowright'], shown: 'Left Right', does: 'one second', shift: true,
      run: (key) => clock.seek(film.time(clock.moment.index) + (key === 'arrowleft' ? -1 : 1)) },
    { keys: ['arrowup', 'arrowdown'], does: 'faster, slower', run: (key) => clock.faster(key === 'arrowup' ? 1 : -1) },
    { keys: ['home', 'end'], does: 'to the start, to the end', run: (key) => clock.seek_frame(key === 'home' ? 0 : film.count - 1) },
  ];
}

/** All keys of the page; `panel`, `charts` and `help` open and close those, `move` lets things be moved. */
export function make_bindings(film: Film, clock: Clock, choice: Selection, stage: StageView,
                              toggles: { panel(): void; charts(): void; help(): void; move: (() => void) | null }): Binding[] {
  const { move } = toggles;
  return [
    ...time_keys(film, clock),
    { keys: [...'123456789'], shown: '1 to 9', does: 'follow that vehicle', run: (key) => choice.follow(Number(key) - 1) },
    { keys: ['f'], does: 'fit everything into the picture', run: () => stage.fit() },
    ...cameras.map((kind): Binding => ({ keys: [camera_keys[kind]], does: looks[kind], run: () => choice.set_camera(kind) })),
    ...layers.map((layer): Binding => ({
      keys: [layer_keys[layer]], does: `show or hide: ${layer}`, run: () => choice.set_layer(layer, !choice.shows(layer)),
    })),
    { keys: ['p'], does: 'show or hide the side panel', run: () => toggles.panel() },
    { keys: ['h'], does: 'show or hide the charts', run: () => toggles.charts() },
    ...(move === null ? [] : [{ keys: ['e'], does: 'move starts, goals and obstacles', run: move }]),
    { keys: ['escape'], does: 'choose no vehicle', run: () => choice.choose([]) },
    { keys: ['?'], does: 'this list', run: () => toggles.help() },
  ];
}
