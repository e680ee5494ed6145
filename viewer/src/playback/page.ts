// SPDX-License-Identifier: Apache-2.0
// The page around the picture: puts the parts together and keeps them in step.
import { buoy } from '../common/buoy';
import { h } from '../common/dom';
import { theme_toggle } from '../common/theme';
import { make_about, make_saving } from './about';
import { make_bindings } from './bindings';
import { make_charts } from './charts/charts';
import { Choice } from './choice';
import { Clock, frame_from } from './clock';
import { make_event_list } from './event_list';
import { make_explanation } from './explanation/explanation';
import type { Film } from './film';
import { Help } from './help';
import { expose } from './hook';
import { icon_button } from './icons';
import { give_back_keys, listen } from './keys';
import { make_layer_list } from './layer_list';
import { MomentLink } from './link';
import type { LiveRun } from './live';
import { make_live_controls } from './live_controls';
import type { Document, Scene } from './model';
import { no_stage } from './no_stage';
import type { Panel } from './panel';
import { make_stage } from './scene/stage';
import type { CameraKind, StageView } from './scene/stage_view';
import { make_thoughts } from './thoughts/thoughts';
import { make_transport } from './transport';
import { make_vehicle_list } from './vehicle_list';

/** Windows at least this large begin with the charts open [px]. */
const roomy = '(min-width: 1000px) and (min-height: 840px)';

function section(id: string, title: string, open: boolean, ...content: (HTMLElement | null)[]): HTMLDetailsElement {
  return h('details', { id, class: 'section', open }, h('summary', {}, title), ...content);
}

function stage_in(host: HTMLElement, scene: Scene, film: Film): StageView {
  try {
    return make_stage(host, scene, film);
  } catch (error) {
    return no_stage(host, error instanceof Error ? error.message : String(error));
  }
}

function camera_bar(choice: Choice, stage: StageView): HTMLElement {
  const kinds: [CameraKind, string, string][] = [['orbit', 'Orbit', 'o'], ['follow', 'Follow', 'c'], ['top', 'Top', 't'], ['side', 'Side', 's']];
  const buttons = kinds.map(([kind, label, key]) => h('button', {
    type: 'button', class: 'switch', 'data-camera': kind, title: `${label} (${key})`, click: () => choice.set_camera(kind),
  }, label));
  const update = (): void => buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(kinds[i]![0] === choice.camera)));
  choice.on_change(update);
  update();
  return h('div', { class: 'cameras', role: 'group', 'aria-label': 'Camera' }, ...buttons,
    h('button', { type: 'button', class: 'switch', title: 'Fit everything into the picture (f)', click: () => stage.fit() }, 'Fit'));
}

/** Calls `changed` when the colours of the page do. */
function on_theme(changed: () => void): void {
  new MutationObserver(changed).observe(window.document.documentElement, { attributeFilter: ['data-theme'] });
}

/** Shows the film, which holds a frame at least; `live` brings more of it. */
export function show_page(playback: Document, film: Film, live: LiveRun | null, into: HTMLElement): void {
  const { scene } = playback;
  window.document.title = `${playback.title} · fairway view`;
  const picture = h('div', { class: 'picture', role: 'img', 'aria-label': `The run in three dimensions: ${playback.title}` });
  const stage_area = h('main', { class: 'stage-area' }, picture);
  const side = h('aside', { class: 'side', 'aria-label': 'The run' });
  const charts_strip = h('details', { class: 'charts-strip' }, h('summary', {}, 'Charts'));
  const lower = h('div', { class: 'lower' }, charts_strip, side);
  const bar = h('header', { class: 'bar' });
  // It sets the theme, whose colours everything below draws with.
  const theme = theme_toggle();
  const page = h('div', { class: 'playback' }, bar, stage_area, lower);
  into.replaceChildren(page);

  const stage = stage_in(picture, scene, film);
  const choice = new Choice(stage, scene.vehicles.length);
  const panels: Panel[] = [];
  const clock = new Clock(film, live !== null, () => show());
  const link = new MomentLink(film, clock, choice);
  const live_controls = live === null ? null : make_live_controls(live, clock);
  const seek = (time: number): void => clock.seek(time);

  function show(): void {
    const moment = clock.moment;
    stage.show(moment);
    for (const panel of panels) panel.show(moment);
    live_controls?.show();
    link.update();
  }
  function add<P extends Panel>(panel: P): P {
    panels.push(panel);
    return panel;
  }

  // The side panel.
  const layers = make_layer_list(scene, film, choice);
  const about = make_about(playback, film);
  const { explanation } = playback;
  side.append(
    ...(playback.notice === '' ? [] : [h('div', { class: 'note warning', role: 'note' }, h('b', {}, 'Notice'), h('p', {}, playback.notice))]),
    ...(explanation === null ? [] : [section('explanation', 'Why it did so', true, make_explanation(explanation, scene, seek))]),
    section('vehicles', 'Vehicles', true, add(make_vehicle_list(scene, film, choice)).element),
    section('thoughts', 'What it thought', true, add(make_thoughts(scene, film)).element),
    section('layers', 'Layers', true, layers.element),
    section('events', 'Events', film.events.length > 0,
      add(make_event_list(scene, film, (event) => clock.seek_frame(frame_from(film, event.time_s)))).element),
    section('saving', 'Save and share', true, make_saving(playback, film, stage, () => link.text(), () => film.time(clock.moment.index))),
    section('about', 'About this run', false, about.element));

  // Around the picture.
  const transport = add(make_transport(scene, film, clock, live_controls?.element ?? null));
  stage_area.append(camera_bar(choice, stage));
  stage_area.after(transport.element);
  const toggle_panel = (): void => {
    const hidden = page.classList.toggle('alone');
    panel_button.setAttribute('aria-expanded', String(!hidden));
  };
  const toggles = { panel: toggle_panel, charts: () => { charts_strip.open = !charts_strip.open; }, help: () => help.toggle() };
  const bindings = make_bindings(film, clock, choice, stage, toggles);
  const help = new Help(bindings);
  page.append(help.element);
  const panel_button = icon_button('panel', 'Side panel', 'p', toggle_panel);
  panel_button.setAttribute('aria-expanded', 'true');
  bar.append(h('span', { class: 'brand' }, buoy()), h('h1', {}, playback.title),
    h('p', { class: 'summary', title: playback.summary }, playback.summary), h('span', { class: 'version' }, playback.version),
    h('button', { type: 'button', class: 'tool', 'aria-label': 'Help', title: 'Keys and pointer (?)', click: () => help.toggle() }, '?'),
    panel_button, theme);

  // Charts are worked out when they are first opened, after the first picture.
  let charts: Panel | null = null;
  charts_strip.addEventListener('toggle', () => {
    if (charts_strip.open && charts === null) {
      charts = add(make_charts(scene, film, seek));
      charts_strip.append(charts.element);
      charts.choose(choice.chosen);
    }
    if (charts_strip.open) charts?.restyle();
    show();
  });

  let { chosen } = choice;
  choice.on_change(() => {
    if (chosen !== choice.chosen) for (const panel of panels) panel.choose(choice.chosen);
    chosen = choice.chosen;
    show();
  });
  on_theme(() => {
    stage.restyle();
    for (const panel of panels) panel.restyle();
  });
  live?.on_answer((grown) => {
    if (grown) {
      for (const panel of panels) panel.grown();
      layers.grown();
      about.grown();
      clock.grown();
    } else {
      live_controls?.show();
    }
  });
  listen(bindings);
  give_back_keys(page);
  expose(film, clock, choice, stage);

  if (explanation !== null) {
    choice.choose([explanation.vehicle]);
    clock.seek(explanation.time_s);
  }
  const placed = link.go();
  if (live !== null && !placed) clock.follow();
  show();
  if (matchMedia(roomy).matches) setTimeout(toggles.charts);
}
