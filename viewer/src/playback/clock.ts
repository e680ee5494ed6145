// SPDX-License-Identifier: Apache-2.0
// What time it is in the film. At rest it stands on a frame, so that what is printed is what was recorded;
// while it plays it moves between frames with the picture's pace.
import { moment_at, type Film, type Moment } from './film';

export const speeds = [0.25, 0.5, 1, 2, 4, 8, 16, 32] as const;
export type Speed = (typeof speeds)[number];

/** Longer gaps between two pictures are those of a hidden or a stalled window, and are not caught up with. */
const longest_gap_s = 0.5;
/** Times that were rounded for a link or a message still find their frame. */
const rounding_s = 1e-6;

/** The first frame at or after `time`; the last if all are earlier. O(log frames). */
export function frame_from(film: Film, time: number): number {
  const before = film.index_at(time - rounding_s);
  const next = film.count > 0 && film.time(before) < time - rounding_s ? before + 1 : before;
  return Math.min(next, film.count - 1);
}

function nearest_frame(film: Film, time: number): number {
  const before = film.index_at(time);
  if (before + 1 >= film.count) return before;
  return time - film.time(before) <= film.time(before + 1) - time ? before : before + 1;
}

export class Clock {
  speed: Speed = 1;
  loop = false;
  /** On a live page: shows the newest frame as it comes. */
  following = false;
  private time = 0;
  /** On a live page: where it goes as soon as the film is there [s]; null: nowhere. */
  private awaited: number | null = null;
  private running = false;
  private picture = 0;

  /** `changed` hears of every new moment, and of play and pause. */
  constructor(private readonly film: Film, private readonly live: boolean, private readonly changed: () => void) {
    this.time = film.time(0);
  }

  get moment(): Moment {
    return moment_at(this.film, this.time);
  }
  get playing(): boolean {
    return this.running || this.following;
  }

  play(): void {
    if (this.playing) return;
    if (this.time >= this.film.end) {
      if (this.live) return this.keep_to_newest();
      this.time = this.film.time(0);
    }
    this.running = true;
    let last = performance.now();
    const tick = (now: number): void => {
      if (!this.running) return;
      this.advance(Math.min(Math.max(0, now - last) / 1000, longest_gap_s));
      last = now;
      if (this.running) this.picture = requestAnimationFrame(tick);
    };
    this.picture = requestAnimationFrame(tick);
    this.changed();
  }

  /** Stops on the frame that is shown. */
  pause(): void {
    this.halt();
    this.awaited = null;
    this.time = this.film.time(this.moment.index);
    this.changed();
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Goes to the nearest frame; playing goes on from there. On a live page it goes to what is not there yet once it is. */
  seek(time: number): void {
    this.seek_frame(nearest_frame(this.film, time));
    if (this.live && time > this.film.end) this.awaited = time;
  }

  seek_frame(index: number): void {
    this.following = false;
    this.awaited = null;
    this.time = this.film.time(Math.min(Math.max(0, index), this.film.count - 1));
    this.changed();
  }

  /** Stops, and goes by so many frames. */
  step(frames: number): void {
    const { index } = this.moment;
    this.halt();
    this.seek_frame(index + frames);
  }

  /** Keeps to the newest frame of a live run. */
  follow(): void {
    this.awaited = null;
    this.keep_to_newest();
  }

  faster(steps: number): void {
    const next = Math.min(Math.max(0, speeds.indexOf(this.speed) + steps), speeds.length - 1);
    this.speed = speeds[next]!;
    this.changed();
  }

  /** More frames have come in, or all were replaced. */
  grown(): void {
    const { awaited, playing } = this;
    if (awaited !== null && awaited <= this.film.end) {
      this.seek(awaited);
      if (playing) this.play();
    }
    if (this.following || this.time > this.film.end) this.time = this.film.end;
    this.changed();
  }

  private keep_to_newest(): void {
    this.halt();
    this.following = true;
    this.time = this.film.end;
    this.changed();
  }

  private halt(): void {
    this.running = false;
    this.following = false;
    cancelAnimationFrame(this.picture);
  }

  private advance(seconds: number): void {
    this.time += seconds * this.speed;
    if (this.time >= this.film.end) {
      if (this.live) return this.keep_to_newest();
      this.time = this.loop ? this.film.time(0) : this.film.end;
      this.running = this.loop;
    }
    this.changed();
  }
}
