// SPDX-License-Identifier: Apache-2.0
// A run that is still going on: asks whoever makes it for what is new, and may tell it to pause, go on or step. It asks for
// nothing else.
import { flag, number, optional, or_null, record, text, type Of } from '../common/read';
import { reason_of } from '../common/reason';
import type { Film } from './film';
import { part } from './model';
import type { Order, Source } from './source';

const run_state = record({
  paused: flag,
  done: flag,
  time_s: number,
  speed: number,
  /** How the run broke, in a line; empty if it is whole. */
  divergence: optional(text, ''),
});
export type RunState = Of<typeof run_state>;

const least_gap_ms = 50;
const gap_without_answer_ms = 2000;

export class LiveRun {
  /** Null before the first answer. */
  state: RunState | null = null;
  /** Why nothing comes; empty while all is well. */
  trouble = '';
  private readonly listeners: ((grown: boolean) => void)[] = [];
  private watching = false;

  constructor(private readonly film: Film, readonly source: Source) {
    source.on_news(() => void this.watch());
  }

  /** Hears of every answer, and whether the film has grown by it. */
  on_answer(listener: (grown: boolean) => void): void {
    this.listeners.push(listener);
  }

  /** Asks again and again, one request at a time, until the run is over and all of it is here. */
  async watch(): Promise<void> {
    if (this.watching) return;
    this.watching = true;
    for (;;) {
      const begin = performance.now();
      const grown = await this.ask();
      for (const listener of this.listeners) listener(grown);
      if (this.state?.done === true && !grown && this.trouble === '') break;
      const gap = this.trouble === '' ? least_gap_ms : gap_without_answer_ms;
      await new Promise((resume) => setTimeout(resume, Math.max(0, begin + gap - performance.now())));
    }
    this.watching = false;
  }

  order(what: Order): void {
    this.source.order(what);
  }

  private async ask(): Promise<boolean> {
    let answer: unknown;
    try {
      answer = await this.source.ask(this.film.count, this.film.generation);
    } catch {
      this.trouble = this.source.lost;
      return false;
    }
    try {
      return this.take(answer);
    } catch (error) {
      this.trouble = `What the run sent cannot be read: ${reason_of(error)}.`;
      return false;
    }
  }

  /** True where the film has grown by it. */
  private take(answer: unknown): boolean {
    const { state, part: found } = record({ state: run_state, part: or_null(part(this.film.vehicles)) })(answer, '');
    this.state = state;
    this.trouble = '';
    if (found === null || (found.count === 0 && !found.thoughts_anew)) return false;
    this.film.append(found);
    return true;
  }
}
