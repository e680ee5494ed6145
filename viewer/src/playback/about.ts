// SPDX-License-Identifier: Apache-2.0
// What can be taken from the page, and where it comes from.
import { h, slug } from '../common/dom';
import { short } from '../common/format';
import { action_button, copy_text, save_blob, save_text } from '../common/save';
import type { Film } from './film';
import { frames_csv } from './frames_csv';
import type { Document } from './model';
import type { Panel } from './panel';
import { seconds } from './printed';
import type { StageView } from './scene/stage_view';

export function make_saving(playback: Document, film: Film, stage: StageView, link: () => string, time: () => number): HTMLElement {
  const name = slug(playback.title);
  return h('div', { class: 'saving' },
    action_button('Save the picture', 'Save the picture as PNG', 'saved', async () => {
      try {
        save_blob(`${name}-${time().toFixed(3)}s.png`, await stage.picture());
        return true;
      } catch {
        return false;
      }
    }),
    action_button('Copy the link', 'Copy the link to this moment', 'copied', () => copy_text(link())),
    action_button('Save the frames', 'Save all frames as CSV, with full precision', 'saved', () =>
      save_text(`${name}.csv`, 'text/csv', frames_csv(playback.scene, playback.columns, film))));
}

function facts(playback: Document, film: Film): [string, string][] {
  const { vehicles, exam, waves, current_depths_m } = playback.scene;
  const stride = film.stride === 1 ? '' : `, one in ${film.stride} of the run`;
  return [
    ['Vehicles', String(vehicles.length)],
    ['Frames', `${film.count}${stride}`],
    ['Time', `${seconds(film.time(0))} to ${seconds(film.end)} s`],
    ['Tick', `${short(playback.period_s)} s`],
    ['Detected', `centres within ${short(exam.crit_dist_m)} m`],
    ['Collided', `centres within ${short(exam.safety_distance_m)} m`],
    ['Sea', waves.length === 0 ? 'flat' : `${waves.length} wave components`],
    ['Water', current_depths_m.length === 0 ? 'still' : `current at ${current_depths_m.map(short).join(', ')} m`],
    ['Seed', playback.seed],
    ['Made by', playback.version],
  ];
}

/** Where the run comes from: its command, seed and numbers. */
export function make_about(playback: Document, film: Film): Panel {
  const list = h('dl', {});
  const fill = (): void => list.replaceChildren(...facts(playback, film).filter(([, value]) => value !== '')
    .map(([label, value]) => h('div', {}, h('dt', {}, label), h('dd', {}, value))));
  fill();
  const command = playback.command === '' ? null : h('div', { class: 'command' }, h('code', {}, playback.command),
    action_button('Copy', 'Copy the command', 'copied', () => copy_text(playback.command)));
  return {
    element: h('div', { class: 'about' }, playback.summary === '' ? null : h('p', {}, playback.summary), command, list,
      h('p', { class: 'remark' }, 'This page is one file: it needs no network, and keeps working wherever it is copied.')),
    grown: fill,
  };
}
