// SPDX-License-Identifier: Apache-2.0
// For a run that is going on: how it stands, pause and step of the run itself, and back to its newest frame.
import { h } from '../common/dom';
import { short } from '../common/format';
import type { Clock } from './clock';
import type { LiveRun } from './live';
import type { Panel } from './panel';
import { seconds } from './printed';

function status_text({ state, trouble }: LiveRun): string {
  if (trouble !== '') return trouble;
  if (state === null) return 'Waiting for the run';
  const pace = state.speed > 0 ? `at ${short(state.speed)}×` : 'as fast as it can';
  if (state.divergence !== '') return `The run ${state.divergence}`;
  const how = state.done ? 'The run is over' : state.paused ? 'The run is paused' : `Running ${pace}`;
  return `${how}, at ${seconds(state.time_s)} s`;
}

export function make_live_controls(live: LiveRun, clock: Clock) {
  const status = h('span', { class: 'live-status', role: 'status' });
  const pause = h('button', { type: 'button', class: 'switch' });
  pause.addEventListener('click', () => live.order(live.state?.paused === true ? 'resume' : 'pause'));
  const step = h('button', { type: 'button', class: 'switch', title: 'The paused run goes on by one frame', click: () => live.order('step') }, 'Step run');
  const newest = h('button', { type: 'button', class: 'switch live', title: 'Show the newest frame as it comes', click: () => clock.follow() }, 'Live');
  const show = (): void => {
    const paused = live.state?.paused === true;
    const over = live.state === null || live.state.done || live.trouble !== '';
    status.textContent = status_text(live);
    status.classList.toggle('trouble', live.trouble !== '' || (live.state !== null && live.state.divergence !== ''));
    pause.textContent = paused ? 'Resume run' : 'Pause run';
    pause.disabled = over;
    step.disabled = over || !paused;
    newest.setAttribute('aria-pressed', String(clock.following));
  };
  show();
  return { element: h('div', { class: 'live-controls', role: 'group', 'aria-label': 'The run' }, newest, pause, step, status), show } satisfies Panel;
}
