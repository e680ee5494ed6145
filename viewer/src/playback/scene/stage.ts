// SPDX-License-Identifier: Apache-2.0
// A plain map in place of the picture in three dimensions: dots from above.
import { alerts } from '../model';
import type { Film, Moment } from '../film';
import type { Scene } from '../model';
import type { MakeStage } from './stage_view';

const alert_colours = { clear: '#2e9e5b', detected: '#e08a00', collided: '#d0342c' };

export const make_stage: MakeStage = (host: HTMLElement, scene: Scene, film: Film) => {
  const canvas = document.createElement('canvas');
  canvas.style.cssText = 'position:absolute;inset:0;width:100%;height:100%';
  host.append(canvas);
  const context = canvas.getContext('2d')!;
  const hidden = new Set<string>();
  let moment: Moment | null = null;
  let chosen: ReadonlySet<number> = new Set();
  let kind = 'orbit';
  let reach = 1;
  const fit = (): void => {
    reach = 10;
    for (let i = 0; i < film.count; i += 20) for (let v = 0; v < film.vehicles; ++v) for (const k of [0, 1]) reach = Math.max(reach, 1.2 * Math.abs(film.value('position_m', i, v, k)));
  };
  const place = (v: number): { x: number; y: number; scale: number } => {
    const { index, part } = moment!;
    const next = Math.min(index + 1, film.count - 1);
    const at = (k: number): number => film.value('position_m', index, v, k) * (1 - part) + film.value('position_m', next, v, k) * part;
    const scale = Math.min(host.clientWidth, host.clientHeight) / 2 / reach;
    const tall = kind === 'side' ? -at(2) : at(0);
    return { x: host.clientWidth / 2 + scale * at(1), y: host.clientHeight / 2 - scale * tall, scale };
  };
  const draw = (): void => {
    const ratio = Math.min(devicePixelRatio, 2);
    canvas.width = host.clientWidth * ratio;
    canvas.height = host.clientHeight * ratio;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    if (moment === null) return;
    const style = getComputedStyle(host);
    for (let v = 0; v < film.vehicles; ++v) {
      const { x, y, scale } = place(v);
      context.globalAlpha = 0.3;
      context.fillStyle = alert_colours[alerts[film.value('alert', moment.index, v)]!];
      context.beginPath();
      context.arc(x, y, scale * scene.exam.crit_dist_m / 2, 0, 7);
      if (!hidden.has('spheres')) context.fill();
      context.globalAlpha = 1;
      context.fillStyle = style.getPropertyValue(`--c${v % 8}`);
      context.fillRect(x - 5, y - 5, 10, 10);
      if (chosen.has(v)) context.strokeRect(x - 9, y - 9, 18, 18);
      if (!hidden.has('sketch') && chosen.has(v) && film.sketches.any) context.strokeRect(x - 30, y - 30, 60, 60);
    }
  };
  new ResizeObserver(draw).observe(host);
  fit();
  return {
    show: (now) => { moment = now; draw(); },
    choose: (vehicles) => { chosen = vehicles; draw(); },
    follow: () => undefined,
    set_camera: (next) => { kind = next; draw(); },
    set_layer: (layer, shown) => { if (shown) hidden.delete(layer); else hidden.add(layer); draw(); },
    fit: () => { fit(); draw(); },
    restyle: draw,
    place_of: (v) => (moment === null ? null : place(v)),
    on_pick: () => undefined,
    picture: () => new Promise((done) => canvas.toBlob((blob) => done(blob!))),
    frames_per_second: 0,
  };
};
