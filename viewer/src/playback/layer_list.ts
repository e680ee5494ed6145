// SPDX-License-Identifier: Apache-2.0
// What is drawn, as a row of switches; those for which this run has nothing are not offered.
import { h } from '../common/dom';
import type { Selection } from './selection';
import type { Film } from './film';
import { layer_keys } from './keys';
import type { Scene } from './model';
import type { Panel } from './panel';
import { layers, type Layer } from './scene/stage_view';

const names: Record<Layer, string> = {
  trails: 'Trails', spheres: 'Spheres', goals: 'Goals', obstacles: 'Obstacles', grid: 'Depth grid', surface: 'Sea surface',
  current: 'Current', sketch: 'Sketch', tracks: 'Tracks', sonar: 'Sonar', messages: 'Messages', names: 'Names',
};

function has_any(layer: Layer, scene: Scene, film: Film): boolean {
  switch (layer) {
    case 'obstacles': return scene.obstacles.length > 0;
    case 'current': return scene.current_depths_m.length > 0;
    case 'sketch': return film.sketches.any;
    case 'tracks': return film.tracks.any;
    case 'sonar': return scene.sonar !== null;
    case 'messages': return film.flights.length > 0 || film.words.any;
    default: return true;
  }
}

export function make_layer_list(scene: Scene, film: Film, choice: Selection): Panel {
  const buttons = layers.map((layer) => h('button', {
    type: 'button', class: 'switch', 'data-layer': layer, title: `${names[layer]} (${layer_keys[layer]})`,
    click: () => choice.set_layer(layer, !choice.shows(layer)),
  }, names[layer]));
  const update = (): void => buttons.forEach((button, i) => {
    button.hidden = !has_any(layers[i]!, scene, film);
    button.setAttribute('aria-pressed', String(choice.shows(layers[i]!)));
  });
  choice.on_change(update);
  update();
  return { element: h('div', { class: 'switches', role: 'group', 'aria-label': 'Layers' }, ...buttons), grown: update };
}
