// SPDX-License-Identifier: Apache-2.0
import type { Film } from '../../film';
import type { Scene } from '../../model';
import type { Colours } from '../colours';
import type { Extent } from '../extent';
import type { Part } from '../part';
import type { Layer } from '../stage_view';
import { Alerts } from './alerts';
import { Currents } from './currents';
import { DepthGrid } from './depth_grid';
import { Goals } from './goals';
import { Messages } from './messages';
import { Names } from './names';
import { Obstacles } from './obstacles';
import { Sea } from './sea';
import { Sketches } from './sketches';
import { SonarFan } from './sonar';
import { Tracks } from './tracks';
import { Trails } from './trails';

/** One part per layer. */
export function make_parts(scene: Scene, film: Film) {
  return {
    trails: new Trails(film), spheres: new Alerts(scene, film), goals: new Goals(film), obstacles: new Obstacles(scene),
    grid: new DepthGrid(), surface: new Sea(scene), current: new Currents(scene, film), sketch: new Sketches(film),
    tracks: new Tracks(film), sonar: new SonarFan(scene, film), messages: new Messages(film), names: new Names(scene),
  } satisfies Record<Layer, Part>;
}
export type Parts = ReturnType<typeof make_parts>;

/** Those that depend on how far the scene reaches. */
export function fit_parts(parts: Parts, colours: Colours, extent: Extent): void {
  for (const part of [parts.trails, parts.current, parts.sketch, parts.tracks]) part.set_extent(extent);
  for (const part of [parts.obstacles, parts.grid, parts.surface]) part.restyle(colours, extent);
}
