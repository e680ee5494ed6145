// SPDX-License-Identifier: Apache-2.0
// Below the picture: play, step, speed, the time, and the scrubber.
import { h } from '../common/dom';
import { speeds, type Clock, type Speed } from './clock';
import type { Film, Moment } from './film';
import { icon_button, set_icon } from './icons';
import type { Scene } from './model';
import type { Panel } from './panel';
import { seconds } from './printed';
import { make_timeline } from './timeline';

/** `divergence` is how the run broke, in a line, and is said at its last frame; empty if it is whole. */
export function make_transport(scene: Scene, film: Film, clock: Clock, more: HTMLElement | null, divergence: string): Panel {
  const timeline = make_timeline(scene, film, clock);
  const play = icon_button('play', 'Play', 'Space', () => clock.toggle());
  play.classList.add('play');
  const loop = icon_button('loop', 'Start again at the end', '', () => {
    clock.loop = !clock.loop;
    loop.setAttribute('aria-pressed', String(clock.loop));
  });
  loop.setAttribute('aria-pressed', 'false');
  const speed = h('select', { 'aria-label': 'Speed', title: 'Speed (↑ ↓)' },
    ...speeds.map((value) => h('option', { value }, `${value}×`)));
  speed.addEventListener('change', () => { clock.speed = Number(speed.value) as Speed; });
  const now = h('b', { class: 'now' });
  const end = h('span', {});
  const ending = h('span', { class: 'live-status trouble', role: 'status', hidden: true }, `The run ${divergence}`);
  const element = h('div', { class: 'transport', role: 'group', 'aria-label': 'Playback' }, timeline.element,
    h('div', { class: 'controls' },
      icon_button('back', 'Back one frame', 'Left', () => clock.step(-1)), play,
      icon_button('forward', 'Forward one frame', 'Right', () => clock.step(1)), speed, loop,
      h('span', { class: 'time' }, now, ' / ', end, ' s'), more, divergence === '' ? null : ending));
  const show_end = (): void => { end.textContent = seconds(film.end); };
  show_end();
  return {
    element,
    show(moment: Moment) {
      timeline.show(moment);
      now.textContent = seconds(film.time(moment.index));
      set_icon(play, clock.playing ? 'pause' : 'play', clock.playing ? 'Pause' : 'Play', 'Space');
      speed.value = String(clock.speed);
      ending.hidden = moment.index + 1 < film.count;
    },
    grown() {
      timeline.grown();
      show_end();
    },
  };
}
