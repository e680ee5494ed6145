// SPDX-License-Identifier: Apache-2.0
// The scrubber: every frame of the film, with a mark where something happened. A click on a mark goes there.
import { h, s } from '../common/dom';
import { hide_tip, show_tip } from '../common/tooltip';
import { frame_from, type Clock } from './clock';
import type { Film, Moment } from './film';
import type { RunEvent, Scene } from './model';
import type { Panel } from './panel';
import { event_text, seconds } from './printed';

// In the order in which they are drawn, the gravest on top. The ends of encounters are in the list of events only.
const marked = ['arrived', 'detected', 'stuck', 'collision'] as const;
/** Marks lie in the upper part of the scrubber [px], and are hit this near [px]. */
const marks_height = 15;
const reach = 6;
/** Half a thumb, as wide as the style sheet makes it [px]: the ends of the track lie that far inside. */
const inset = 8;
/** Width of the drawing that is stretched over the track. */
const units = 10_000;

export function make_timeline(scene: Scene, film: Film, clock: Clock) {
  const range = h('input', { type: 'range', min: 0, step: 1, class: 'scrubber', 'aria-label': 'Time' });
  const paths = marked.map((kind) => s('path', { class: `mark ${kind}`, 'vector-effect': 'non-scaling-stroke' }));
  const drawing = s('svg', { class: 'marks', viewBox: `0 0 ${units} 10`, preserveAspectRatio: 'none', 'aria-hidden': 'true' }, ...paths);
  const element = h('div', { class: 'timeline' }, drawing, range);
  let events: { event: RunEvent; frame: number }[] = [];

  const fraction = (frame: number): number => (film.count < 2 ? 0 : frame / (film.count - 1));
  const fill = (): void => {
    range.max = String(film.count - 1);
    const of_kind = (kind: RunEvent['kind']): { event: RunEvent; frame: number }[] =>
      film.events.filter((event) => event.kind === kind).map((event) => ({ event, frame: frame_from(film, event.time_s) }));
    const groups = marked.map(of_kind);
    groups.forEach((group, i) => {
      const places = new Set(group.map(({ frame }) => Math.round(fraction(frame) * units)));
      paths[i]!.setAttribute('d', [...places].map((x) => `M${x} ${marked[i] === 'collision' ? 0 : 3}V10`).join(''));
    });
    events = groups.flat();
  };
  const nearest = (event: PointerEvent | MouseEvent): { event: RunEvent; frame: number } | null => {
    const box = element.getBoundingClientRect();
    if (event.clientY - box.top > marks_height) return null;
    const x = event.clientX - box.left - inset;
    let best: (typeof events)[number] | null = null;
    let least = reach;
    for (const entry of events) {
      const distance = Math.abs(fraction(entry.frame) * (box.width - 2 * inset) - x);
      if (distance <= least) [best, least] = [entry, distance];
    }
    return best;
  };

  range.addEventListener('input', () => clock.seek_frame(Number(range.value)));
  range.addEventListener('click', (event) => {
    const hit = nearest(event);
    if (hit !== null) clock.seek_frame(hit.frame);
  });
  range.addEventListener('pointermove', (event) => {
    const hit = nearest(event);
    if (hit === null) hide_tip();
    else show_tip({ title: event_text(hit.event, scene), rows: [{ label: 't', value: `${seconds(hit.event.time_s)} s` }] }, event.clientX, event.clientY - 34);
  });
  range.addEventListener('pointerleave', hide_tip);
  fill();
  return {
    element,
    show({ index }: Moment) {
      range.value = String(index);
      range.setAttribute('aria-valuetext', `${seconds(film.time(index))} s`);
      range.style.setProperty('--done', String(fraction(index)));
    },
    grown: fill,
  } satisfies Panel;
}
