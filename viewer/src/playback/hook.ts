// SPDX-License-Identifier: Apache-2.0
// What scripts and tests of a page can reach, as window.fairway; viewer/README.md describes it.
import type { Selection } from './selection';
import type { Clock } from './clock';
import type { Film } from './film';
import { alert_text, position_texts, seconds } from './printed';
import type { StageView } from './scene/stage_view';

export interface Hook {
  film: Film;
  /** Goes to the frame nearest to a time [s]. */
  seek(time: number): void;
  play(): void;
  pause(): void;
  state(): {
    /** Of the moment [s]; between frames only while playing. */
    time: number;
    /** As the page prints it: of the frame. */
    time_text: string;
    index: number;
    playing: boolean;
    speed: number;
    camera: string;
    chosen: number[];
    vehicles: { position: string[]; alert: string; place: { x: number; y: number } | null }[];
    frames_per_second: number;
  };
}

declare global {
  interface Window {
    fairway?: Hook;
  }
}

export function expose(film: Film, clock: Clock, choice: Selection, stage: StageView): void {
  window.fairway = {
    film,
    seek: (time) => clock.seek(time),
    play: () => clock.play(),
    pause: () => clock.pause(),
    state() {
      const { time, index } = clock.moment;
      return {
        time, time_text: seconds(film.time(index)), index, playing: clock.playing, speed: clock.speed,
        camera: choice.camera, chosen: [...choice.chosen],
        vehicles: Array.from({ length: film.vehicles }, (_, vehicle) => ({
          position: position_texts(film, index, vehicle), alert: alert_text(film, index, vehicle), place: stage.place_of(vehicle),
        })),
        frames_per_second: stage.frames_per_second,
      };
    },
  };
}
