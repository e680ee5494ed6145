// SPDX-License-Identifier: Apache-2.0
// The page around the picture: puts the parts together and keeps them in step.
import { buoy } from '../common/buoy';
import { h } from '../common/dom';
import { reason_of } from '../common/reason';
import { theme_toggle } from '../common/theme';
import { make_about, make_saving } from './about';
import { make_bindings } from './bindings';
import { make_camera_bar } from './camera_bar';
import { make_charts } from './charts/charts';
import { Selection } from './selection';
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
import type { Document, RunEvent, Scene } from './model';
import { Mover } from './moving/mover';
import { no_stage } from './no_stage';
import type { Panel } from './panel';
import { make_stage } from './scene/stage';
import type { StageView } from './scene/stage_view';
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
    return no_stage(host, reason_of(error));
  }
}

/** Calls `changed` when the colours of the page do. */
function on_theme(changed: () => void): void {
  new MutationObserver(changed).observe(window.document.documentElement, { attributeFilter: ['data-theme'] });
}

/** The empty places of the page. */
function make_frame(playback: Document, into: HTMLElement) {
  window.document.title = `${playback.title} · fairway view`;
  const bar = h('header', { class: 'bar' });
  const picture = h('div', { class: 'picture' });
  const stage_area = h('main', { class: 'stage-area' }, picture);
  const charts_strip = h('details', { class: 'charts-strip' }, h('summary', {}, 'Charts'));
  const side = h('aside', { class: 'side', 'aria-label': 'The run' });
  const page = h('div', { class: 'playback' }, bar, stage_area, h('div', { class: 'lower' }, charts_strip, side));
  into.replaceChildren(page);
  // It sets the theme, whose colours everything else draws with.
  return { page, bar, picture, stage_area, charts_strip, side, theme: theme_toggle() };
}

class Page {
  private readonly stage: StageView;
  private readonly choice: Selection;
  private readonly clock: Clock;
  private readonly link: MomentLink;
  private readonly help: Help;
  private readonly panel_button = icon_button('panel', 'Side panel', 'p', () => this.toggle_side());
  private readonly panels: Panel[] = [];
  private readonly seek = (time: number): void => this.clock.seek(time);

  constructor(private readonly playback: Document, private readonly film: Film, private readonly live: LiveRun | null,
              private readonly frame: ReturnType<typeof make_frame>) {
    this.stage = stage_in(frame.picture, playback.scene, film);
    this.choice = new Selection(this.stage, playback.scene.vehicles.length);
    this.clock = new Clock(film, live !== null, () => this.show());
    this.link = new MomentLink(film, this.clock, this.choice);
    const mover = live !== null && playback.movable ? new Mover(live.source, this.stage) : null;
    if (mover !== null) {
      frame.picture.append(mover.handles.element);
      frame.stage_area.append(mover.button);
    }
    const bindings = make_bindings(film, this.clock, this.choice, this.stage, {
      panel: () => this.toggle_side(), charts: () => this.toggle_charts(), help: () => this.help.toggle(), move: mover && (() => mover.toggle()),
    });
    this.help = new Help(bindings);
    this.fill_side();
    this.surround_picture();
    this.fill_bar();
    this.make_charts_when_opened();
    this.keep_in_step();
    listen(bindings);
    give_back_keys(frame.page);
    expose(film, this.clock, this.choice, this.stage);
    this.begin();
  }

  private show(): void {
    const { moment } = this.clock;
    this.stage.show(moment);
    for (const panel of this.panels) panel.show?.(moment);
    this.link.update();
    this.live?.source.shown(moment.time, [...this.choice.chosen]);
  }

  /** Keeps the panel in step from now on. */
  private add<P extends Panel>(panel: P): P {
    this.panels.push(panel);
    return panel;
  }

  private fill_side(): void {
    const { playback, film, choice, clock } = this;
    const { scene, notice, explanation } = playback;
    const go_to = (event: RunEvent): void => clock.seek_frame(frame_from(film, event.time_s));
    this.frame.side.append(
      ...(notice === '' ? [] : [h('div', { class: 'note warning', role: 'note' }, h('b', {}, 'Notice'), h('p', {}, notice))]),
      ...(explanation === null ? [] : [section('explanation', 'Why it did so', true, make_explanation(explanation, scene, this.seek))]),
      section('vehicles', 'Vehicles', true, this.add(make_vehicle_list(scene, film, choice)).element),
      section('thoughts', 'What it thought', true, this.add(make_thoughts(scene, film)).element),
      section('layers', 'Layers', true, this.add(make_layer_list(scene, film, choice)).element),
      section('events', 'Events', film.events.length > 0, this.add(make_event_list(scene, film, go_to)).element),
      section('saving', 'Save and share', true,
        make_saving(playback, film, this.stage, () => this.link.text(), () => film.time(clock.moment.index))),
      section('about', 'About this run', false, this.add(make_about(playback, film)).element));
  }

  private surround_picture(): void {
    const { live, clock } = this;
    const live_controls = live === null ? null : this.add(make_live_controls(live, clock));
    const transport = this.add(make_transport(this.playback.scene, this.film, clock, live_controls?.element ?? null,
      this.playback.divergence));
    this.frame.stage_area.append(make_camera_bar(this.choice, this.stage));
    this.frame.stage_area.after(transport.element);
    // An answer that brings frames shows everything anew; any other one only tells how the run stands.
    live?.source.on_go((time, plays) => {
      clock.pause();
      clock.seek(time);
      if (plays) clock.play();
    });
    live?.on_answer((grown) => (grown ? this.grow() : live_controls?.show()));
  }

  private fill_bar(): void {
    const { title, summary, version } = this.playback;
    this.panel_button.setAttribute('aria-expanded', 'true');
    this.frame.bar.append(h('span', { class: 'brand' }, buoy()), h('h1', {}, title),
      h('p', { class: 'summary', title: summary }, summary), h('span', { class: 'version' }, version),
      h('button', { type: 'button', class: 'tool', 'aria-label': 'Help', title: 'Keys and pointer (?)', click: () => this.help.toggle() }, '?'),
      this.panel_button, this.frame.theme);
    this.frame.page.append(this.help.element);
  }

  /** Charts are worked out when they are first opened, after the first picture. */
  private make_charts_when_opened(): void {
    const { charts_strip } = this.frame;
    let charts: ReturnType<typeof make_charts> | null = null;
    charts_strip.addEventListener('toggle', () => {
      if (!charts_strip.open) return;
      if (charts === null) {
        charts = this.add(make_charts(this.playback.scene, this.film, this.seek));
        charts_strip.append(charts.element);
        charts.choose(this.choice.chosen);
      }
      charts.restyle();
      this.show();
    });
  }

  private keep_in_step(): void {
    let { chosen } = this.choice;
    this.choice.on_change(() => {
      if (chosen !== this.choice.chosen) for (const panel of this.panels) panel.choose?.(this.choice.chosen);
      chosen = this.choice.chosen;
      this.show();
    });
    on_theme(() => {
      this.stage.restyle();
      for (const panel of this.panels) panel.restyle?.();
    });
  }

  private grow(): void {
    for (const panel of this.panels) panel.grown?.();
    this.clock.grown();
  }

  private toggle_side(): void {
    const hidden = this.frame.page.classList.toggle('alone');
    this.panel_button.setAttribute('aria-expanded', String(!hidden));
  }

  private toggle_charts(): void {
    this.frame.charts_strip.open = !this.frame.charts_strip.open;
  }

  /** At the moment of the explanation, unless the address says another; a live run at its newest frame. */
  private begin(): void {
    const { explanation } = this.playback;
    if (explanation !== null) {
      this.choice.choose([explanation.vehicle]);
      this.clock.seek(explanation.time_s);
    }
    const placed = this.link.go();
    if (this.live !== null && !placed) {
      if (this.live.source.plays) this.clock.play();
      else this.clock.follow();
    }
    this.show();
    if (matchMedia(roomy).matches) setTimeout(() => this.toggle_charts());
  }
}

/** Shows the film, which holds a frame at least; `live` brings more of it. */
export function show_page(playback: Document, film: Film, live: LiveRun | null, into: HTMLElement): void {
  new Page(playback, film, live, make_frame(playback, into));
}
