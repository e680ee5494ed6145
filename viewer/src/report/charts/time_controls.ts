// SPDX-License-Identifier: Apache-2.0
import { h } from '../../common/dom';
import { fixed } from '../../common/format';

/** A slider over time and a button that plays it; a whole run takes `seconds` on the clock. */
export function time_controls(start: number, end: number, changed: (time: number) => void, seconds = 9): HTMLElement {
  const slider = h('input', { type: 'range', min: 0, max: 1000, value: 1000, 'aria-label': 'Time' });
  const output = h('output', {});
  const play = h('button', { type: 'button', class: 'play', 'aria-label': 'Play' });
  let frame = 0;

  const show = (): void => {
    const time = start + ((end - start) * Number(slider.value)) / 1000;
    const text = `${fixed(time, end - start < 20 ? 1 : 0)} s`;
    output.textContent = text;
    slider.setAttribute('aria-valuetext', text);
    slider.style.setProperty('--part', `${Number(slider.value) / 10}%`);
    changed(time);
  };
  const stop = (): void => {
    cancelAnimationFrame(frame);
    frame = 0;
    play.classList.remove('playing');
    play.setAttribute('aria-label', 'Play');
  };
  const run = (): void => {
    if (Number(slider.value) >= 1000) slider.value = '0';
    const from = Number(slider.value);
    let began: number | null = null;
    play.classList.add('playing');
    play.setAttribute('aria-label', 'Pause');
    const step = (now: number): void => {
      began ??= now;
      slider.value = String(Math.min(1000, Math.round(from + (now - began) / seconds)));
      show();
      if (Number(slider.value) >= 1000) stop();
      else frame = requestAnimationFrame(step);
    };
    frame = requestAnimationFrame(step);
  };
  play.addEventListener('click', () => (frame === 0 ? run() : stop()));
  slider.addEventListener('input', () => {
    stop();
    show();
  });
  slider.style.setProperty('--part', '100%');
  output.textContent = `${fixed(end, end - start < 20 ? 1 : 0)} s`;
  return h('div', { class: 'time' }, play, slider, output);
}
