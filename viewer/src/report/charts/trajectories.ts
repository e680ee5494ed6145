// SPDX-License-Identifier: Apache-2.0
// Where the vehicles went: a view that can be turned, with plan and elevation beside it where there is room.
import { h, s } from '../../common/dom';
import { fixed, short } from '../../common/format';
import type { Made, Point, TrajectoriesBlock } from '../model';
import { time_controls } from './time_controls';
import { leads_to, type Chart, type Drawing, type Palettes, type Target, type View } from './chart';
import { outline_ratio, type Bounds, type Camera, type Projection, type Rect } from './projection';
import { draw_scene, goal_colours, type Scene, type Track } from './scene';

type ViewName = 'turn' | 'top' | 'south' | 'east';
const cameras: Record<Exclude<ViewName, 'turn'>, Camera> = {
  top: { heading: 0, elevation: 90 },
  south: { heading: 0, elevation: 0 },
  east: { heading: 270, elevation: 0 },
};
const names: Record<ViewName, string> = { turn: '3-D', top: 'Top', south: 'From south', east: 'From east' };

interface State {
  view: ViewName;
  camera: Camera;
  time: number;
}

/** At most this many points of a track are drawn; the table has them all. */
const most_points = 360;

function track_of(vehicle: TrajectoriesBlock['vehicles'][number], palettes: Palettes): Track {
  const step = Math.max(1, Math.ceil(vehicle.n.length / most_points));
  const kept = vehicle.n.map((_, i) => i).filter((i) => i % step === 0 || i === vehicle.n.length - 1);
  return {
    label: vehicle.label,
    colour: palettes.vehicles.colour(vehicle.label),
    dash: palettes.vehicles.dash(vehicle.label),
    points: kept.map((i): Point => [vehicle.n[i]!, vehicle.e[i]!, vehicle.d[i]!]),
    times: vehicle.t.length === 0 ? [] : kept.map((i) => vehicle.t[i]!),
  };
}

function bounds_of(block: TrajectoriesBlock, tracks: Track[]): Bounds {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const include = (point: Point, radius = 0): void => point.forEach((value, i) => {
    low[i] = Math.min(low[i]!, value - radius);
    high[i] = Math.max(high[i]!, value + radius);
  });
  for (const { points } of tracks) for (const point of points) include(point);
  for (const goal of block.goals) include(goal);
  for (const { centre, radius } of block.spheres) include(centre, radius);
  if (!Number.isFinite(low[0]!)) include([0, 0, 0], 1);
  const margin = Math.max(0.5, 0.04 * Math.max(high[0]! - low[0]!, high[1]! - low[1]!));
  for (const i of [0, 1, 2]) [low[i], high[i]] = [low[i]! - margin, high[i]! + margin];
  return { low: low as unknown as Point, high: high as unknown as Point };
}

interface Placed {
  projection: Projection;
  rect: Rect;
}

/** The runs behind one vehicle, or behind all of the figure. */
function made_of(block: TrajectoriesBlock, label: string): Made | null {
  return block.vehicles.find((vehicle) => vehicle.label === label)?.made ?? block.made;
}

/** The runs behind the figure, each once. */
function all_made(block: TrajectoriesBlock): Made | null {
  const runs = [...new Set([block.made, ...block.vehicles.map(({ made }) => made)].flatMap((made) => made?.runs ?? []))];
  return runs.length === 0 ? null : { runs, values: [] };
}

function pick_point(scene: Scene, placed: Placed[], x: number, y: number): Target | null {
  const inside = placed.find(({ rect }) =>
    x >= rect.x && x <= rect.x + rect.width && y >= rect.y && y <= rect.y + rect.height);
  if (inside === undefined) return null;
  let best: { track: Track; i: number; at: readonly [number, number] } | null = null;
  let nearest = 16;
  for (const track of scene.tracks) {
    track.points.forEach((point, i) => {
      const at = inside.projection(point);
      const distance = Math.hypot(at[0] - x, at[1] - y);
      if (distance < nearest) [best, nearest] = [{ track, i, at }, distance];
    });
  }
  if (best === null) return null;
  const { track, i, at } = best as { track: Track; i: number; at: readonly [number, number] };
  const [n, e, d] = track.points[i]!;
  const time = track.times[i];
  return {
    x: at[0], y: at[1],
    tip: () => ({
      title: track.label,
      rows: [
        ...(time === undefined ? [] : [{ label: 'time', value: `${short(time)} s`, colour: track.colour }]),
        { label: 'north, east, down', value: `${fixed(n, 2)}, ${fixed(e, 2)}, ${fixed(d, 2)} m` },
      ],
    }),
    cursor: () => [s('circle', { colour: track.colour, class: 'dot', cx: at[0], cy: at[1], r: 5 })],
    runs: leads_to(made_of(scene.block, track.label), scene.block.title, track.label),
  };
}

function draw(scene_all: Scene, state: State, flat: boolean, view: View): Drawing {
  const scene = { ...scene_all, time: state.time, tracks: scene_all.tracks.filter(({ label }) => !view.hidden.has(label)) };
  const { width, compact } = view;
  const wide = !compact && !flat && width >= 720;
  const font = compact ? 10 : 11.5;
  // As tall as a view of about 35 degrees needs, the same however the view is turned.
  const { low, high } = scene.bounds;
  const main_width = wide ? width * 0.64 : width;
  const ratio = flat ? (high[0] - low[0]) / (high[1] - low[1]) : outline_ratio(scene.bounds, 35);
  const needed = (main_width - font * 8) * ratio + font * 5;
  const [least, most] = compact ? [200, 320] : wide ? [360, width * 0.58] : [260, flat ? 560 : Math.min(460, width)];
  const height = Math.round(Math.max(least, Math.min(most, needed)));
  const svg = s('svg', { viewBox: `0 0 ${width} ${height}`, width, height, class: 'chart scene' });
  svg.style.fontSize = `${font}px`;

  const turned = state.view === 'turn';
  const places = [{
    rect: { x: 0, y: 0, width: main_width, height }, turnable: turned,
    camera: state.view === 'turn' ? state.camera : cameras[state.view], caption: '',
  }];
  if (wide) {
    const side = { x: main_width + 12, width: width - main_width - 12, height: height / 2 - 18 };
    places.push(
      { rect: { ...side, y: 18 }, camera: cameras.top, turnable: false, caption: 'From above' },
      { rect: { ...side, y: height / 2 + 18 }, camera: cameras.south, turnable: false, caption: 'From the south' });
  }
  const placed = places.map(({ rect, camera, turnable, caption }): Placed => {
    const { marks, view: projection } = draw_scene(scene, { camera, rect, turnable, font });
    svg.append(...marks);
    if (caption !== '') svg.append(s('text', { class: 'axis-label', x: rect.x + 8, y: rect.y - 6 }, caption));
    return { projection, rect };
  });
  return { svg, targets: [], pick: (x, y) => pick_point(scene, placed, x, y) };
}

function view_buttons(state: State, redraw: () => void): HTMLElement {
  const buttons = (Object.keys(names) as ViewName[]).map((name) => {
    const button = h('button', { type: 'button', 'data-view': name }, names[name]);
    button.addEventListener('click', () => {
      state.view = name;
      redraw();
    });
    return button;
  });
  return h('div', { class: 'segments', role: 'group', 'aria-label': 'View' }, ...buttons);
}

function turn(state: State, right: number, up: number): void {
  if (state.view !== 'turn') state.camera = { ...cameras[state.view] };
  state.view = 'turn';
  state.camera.heading = (state.camera.heading - right + 360) % 360;
  state.camera.elevation = Math.max(0, Math.min(90, state.camera.elevation + up));
}

function attach_turning(plot: HTMLElement, state: State, redraw: () => void): void {
  plot.classList.add('turnable');
  plot.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    plot.setPointerCapture(event.pointerId);
    let last = [event.clientX, event.clientY] as const;
    const move = (next: PointerEvent): void => {
      turn(state, (next.clientX - last[0]) * 0.5, (next.clientY - last[1]) * 0.4);
      last = [next.clientX, next.clientY];
      redraw();
    };
    plot.addEventListener('pointermove', move);
    const end = (): void => plot.removeEventListener('pointermove', move);
    plot.addEventListener('pointerup', end, { once: true });
    plot.addEventListener('pointercancel', end, { once: true });
  });
  plot.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: [6, 0], ArrowRight: [-6, 0], ArrowUp: [0, 6], ArrowDown: [0, -6] }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    turn(state, step[0]!, step[1]!);
    redraw();
  });
}

export function trajectories_chart(block: TrajectoriesBlock, palettes: Palettes): Chart {
  const tracks = block.vehicles.map((vehicle) => track_of(vehicle, palettes));
  const bounds = bounds_of(block, tracks);
  const depths = tracks.flatMap(({ points }) => points.map((point) => point[2]));
  const flat = depths.every((d) => Math.abs(d - depths[0]!) < 0.05);
  const times = tracks.flatMap((track) => track.times);
  const [start, end] = [times.reduce((a, b) => Math.min(a, b), Infinity), times.reduce((a, b) => Math.max(a, b), -Infinity)];
  const state: State = { view: flat ? 'top' : 'turn', camera: { heading: 330, elevation: 24 }, time: end };
  const scene: Scene = { block, bounds, tracks, goal_colours: goal_colours(block, palettes.vehicles), time: end };
  const spheres = [...new Set(block.spheres.map(({ label }) => label).filter((label) => label !== ''))];
  const size = bounds.high.map((value, i) => short(Math.round(value - bounds.low[i]!)));
  return {
    legend: [
      ...tracks.map(({ label, colour, dash }) => ({ label, glyph: 'line' as const, colour, dash, toggles: true })),
      ...(block.goals.length > 0 ? [{ label: 'goal', glyph: 'goal' as const, toggles: false }] : []),
      ...spheres.slice(0, 3).map((label) => ({ label, glyph: 'sphere' as const, toggles: false })),
    ],
    summary: `Trajectories of ${tracks.length} vehicles in a space of ${size.join(' by ')} metres (north, east, down)` +
      (Number.isFinite(end) ? ` over ${short(end - start)} seconds.` : '.') + (flat ? '' : ' Arrow keys turn the view.'),
    data: () => ({
      kind: 'table', title: block.title, note: '', filter: [],
      columns: [
        { key: 'vehicle', label: 'vehicle', unit: '', type: 'text', digits: null },
        ...[['t', 's'], ['n', 'm'], ['e', 'm'], ['d', 'm']].map(([key, unit]) =>
          ({ key: key!, label: key!, unit: unit!, type: 'number' as const, digits: null })),
      ],
      rows: block.vehicles.flatMap(({ label, n, e, d, t }) => n.map((_, i) =>
        ({ vehicle: label, t: t[i] ?? null, n: n[i]!, e: e[i]!, d: d[i]! }))),
    }),
    draw: (view) => draw(scene, state, flat, view),
    made: all_made(block),
    controls: (redraw) => {
      const shown = flat ? null : view_buttons(state, redraw);
      const bar = h('div', { class: 'controls' }, shown,
        end > start ? time_controls(start, end, (time) => { state.time = time; redraw(); }) : null);
      // The pressed button follows the state, which dragging changes too.
      bar.addEventListener('redrawn', () => shown?.querySelectorAll('button').forEach((button) =>
        button.setAttribute('aria-pressed', String(button.dataset['view'] === state.view))));
      return bar;
    },
    ...(flat ? {} : { attach: (plot: HTMLElement, redraw: () => void) => attach_turning(plot, state, redraw) }),
  };
}
