// SPDX-License-Identifier: Apache-2.0
// Who makes a run that is still going on: the server that this page came from, or the page around this one, in which it is simulated.
export type Order = 'pause' | 'resume' | 'step';

export interface Source {
  /** {"part", "state"}: what there is from frame `first` on, of the film of this generation. Rejects where nobody answers. */
  ask(first: number, generation: number): Promise<unknown>;
  order(what: Order): void;
  /** What is said when nobody answers. */
  readonly lost: string;
  /** Whether the page plays from the beginning, because the run is quicker than the clock. */
  readonly plays: boolean;
  /** Tells what time is shown [s], and which vehicles are chosen: somebody may show another run beside this one, or explain it. */
  shown(time_s: number, chosen: readonly number[]): void;
  /** Hears what time is to be shown, and whether it plays on from there. */
  on_go(go: (time_s: number, plays: boolean) => void): void;
  /** Hears that there is more to ask for, though the run is over. */
  on_news(news: () => void): void;
  /** Asks for what can be moved, or for nothing any more. */
  edit(on: boolean): void;
  /** Hears of it. */
  on_handles(show: (handles: readonly Handle[]) => void): void;
  /** Tells that it has been moved there. */
  moved(path: string, position_m: readonly number[]): void;
}

/** What can be moved in the picture. */
export interface Handle {
  path: string;
  what: 'start' | 'goal' | 'obstacle';
  name: string;
  vehicle: number | null;
  /** North, east and, where it has a depth, down [m]. */
  position_m: readonly number[];
}

type Told = { fairway: 'answer'; id: number; answer: unknown } | { fairway: 'go'; time_s: number; plays: boolean } | { fairway: 'news' }
  | { fairway: 'handles'; handles: Handle[] };

export function server(): Source {
  return {
    async ask(first, generation) {
      const response = await fetch(`part?from=${first}&generation=${generation}`, { cache: 'no-store' });
      if (!response.ok) throw new Error(`it answers ${response.status}`);
      return response.json();
    },
    order(what) {
      // The header is what a page from elsewhere could not send without being asked whether it may.
      fetch(what, { method: 'POST', headers: { 'X-Fairway': '1' } }).catch(() => {
        // The next question finds out that nobody is there.
      });
    },
    lost: 'The run has ended, or its server is gone. What has come in so far stays here.',
    plays: false,
    shown() {},
    on_go() {},
    on_news() {},
    edit() {},
    on_handles() {},
    moved() {},
  };
}

/**
 * By messages to the page around: {fairway: 'ask', id, first, generation}, which it answers by {fairway: 'answer', id, answer};
 * {fairway: 'order', what}; {fairway: 'shown', time_s, chosen}; {fairway: 'edit', on}, which it answers by {fairway: 'handles', handles};
 * and {fairway: 'moved', path, position_m}. It may send {fairway: 'go', time_s, plays}, {fairway: 'news'} and handles unasked.
 */
export function page_around(): Source {
  const waiting = new Map<number, (answer: unknown) => void>();
  let asked = 0;
  const tell = (message: object): void => window.parent.postMessage(message, '*');
  let go: (time_s: number, plays: boolean) => void = () => {};
  let news = (): void => {};
  let handles: readonly Handle[] = [];
  let show_handles: (handles: readonly Handle[]) => void = () => {};
  window.addEventListener('message', ({ source, data }: MessageEvent<Told | undefined>) => {
    if (source !== window.parent || data === undefined) return;
    if (data.fairway === 'go') go(data.time_s, data.plays);
    if (data.fairway === 'news') news();
    if (data.fairway === 'handles') show_handles(handles = data.handles);
    if (data.fairway !== 'answer') return;
    waiting.get(data.id)?.(data.answer);
    waiting.delete(data.id);
  });
  return {
    ask(first, generation) {
      const id = asked++;
      return new Promise((resolve) => {
        waiting.set(id, resolve);
        tell({ fairway: 'ask', id, first, generation });
      });
    },
    order: (what) => tell({ fairway: 'order', what }),
    lost: 'The page around this one does not answer.',
    plays: true,
    shown: (time_s, chosen) => tell({ fairway: 'shown', time_s, chosen }),
    on_go: (then) => { go = then; },
    on_news: (then) => { news = then; },
    edit: (on) => tell({ fairway: 'edit', on }),
    // They may have come before the picture was there.
    on_handles(then) {
      show_handles = then;
      then(handles);
    },
    moved: (path, position_m) => tell({ fairway: 'moved', path, position_m }),
  };
}
