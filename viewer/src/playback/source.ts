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
  /** Hears what time is to be shown. */
  on_go(go: (time_s: number) => void): void;
}

type Told = { fairway: 'answer'; id: number; answer: unknown } | { fairway: 'go'; time_s: number };

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
  };
}

/**
 * By messages to the page around: {fairway: 'ask', id, first, generation}, which it answers by {fairway: 'answer', id, answer};
 * {fairway: 'order', what}; and {fairway: 'shown', time_s, chosen}. It may send {fairway: 'go', time_s}.
 */
export function page_around(): Source {
  const waiting = new Map<number, (answer: unknown) => void>();
  let asked = 0;
  const tell = (message: object): void => window.parent.postMessage(message, '*');
  let go: (time_s: number) => void = () => {};
  window.addEventListener('message', ({ source, data }: MessageEvent<Told | undefined>) => {
    if (source !== window.parent || data === undefined) return;
    if (data.fairway === 'go') go(data.time_s);
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
  };
}
