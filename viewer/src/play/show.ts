// SPDX-License-Identifier: Apache-2.0
// A run as the playback shows it: its page in a frame, which asks for the film as it asks a live run's server.
import { h } from '../common/dom';
import type { Handle } from '../playback/source';
import { take_drops } from './drop';
import { bytes_of } from './module';
import type { RemoteSimulator } from './simulator';

/** What the page in the frame sends (src/playback/source.ts). */
type Asked = { fairway: 'ask'; id: number; first: number; generation: number } | { fairway: 'order'; what: 'pause' | 'resume' | 'step' }
  | { fairway: 'shown'; time_s: number; chosen: number[] } | { fairway: 'edit'; on: boolean } | { fairway: 'moved'; path: string; position_m: number[] };

/** What is done with what the visitor does in the picture. */
export interface ShowHands {
  /** Once, when the run has ended. */
  over(): void;
  /** Things are to be movable, or no longer; null: never. */
  edit: ((on: boolean) => void) | null;
  moved(path: string, position_m: readonly number[]): void;
  /** Somebody else is chosen. */
  chosen(vehicles: readonly number[]): void;
  /** A file is dropped on the picture. */
  dropped(file: File): void;
}

/** An empty frame gets its page. It is empty again whenever it has been moved to another place. */
function fill(frame: HTMLIFrameElement, text: string, dropped: (file: File) => void): void {
  const inside = frame.contentDocument;
  if (inside === null || inside.body.childElementCount > 0) return;
  inside.open();
  inside.write(text);
  inside.close();
  take_drops(frame.contentWindow!, dropped);
}

export class Show {
  readonly element: HTMLIFrameElement;
  /** Another that shows the times that this one shows. */
  beside: Show | null = null;
  /** What it shows, and the vehicle that was chosen first there. */
  moment = { time_s: 0, vehicle: 0 };
  private thinkers = '';
  private handles: readonly Handle[] = [];
  private is_over = false;
  private readonly listen = (event: MessageEvent<Asked | undefined>): void => {
    if (event.source !== this.element.contentWindow || event.data === undefined) return;
    const { data } = event;
    if (data.fairway === 'order') void this.simulator.ask('order', data.what);
    if (data.fairway === 'shown') this.take_moment(data.time_s, data.chosen);
    if (data.fairway === 'ask') void this.answer(data.id, data.first, data.generation);
    if (data.fairway === 'edit') this.hands.edit?.(data.on);
    if (data.fairway === 'moved') this.hands.moved(data.path, data.position_m);
  };

  /** `page` is the playback's template, `document` what it is of; it plays from `opens_at` on as soon as that is there [s]. */
  constructor(private readonly simulator: RemoteSimulator, page: string, document: object, label: string, private readonly hands: ShowHands,
              private opens_at: number | null) {
    const json = JSON.stringify({ ...document, live: 'page', movable: hands.edit !== null }).replaceAll('</', '<\\/').replaceAll('<!', '\\u003c!');
    this.element = h('iframe', { title: label });
    // Written so that the marker of the data, which is searched for in this page as well, is not in it.
    const text = page.replace(/__FAIRWAY_[A-Z]+__/, () => json);
    // What a `srcdoc` had a browser keeps for as long as this page is open.
    this.element.addEventListener('load', () => fill(this.element, text, (file) => hands.dropped(file)));
    window.addEventListener('message', this.listen);
  }

  end(): void {
    window.removeEventListener('message', this.listen);
    this.element.remove();
  }

  /** Shows this time. */
  go(time_s: number, plays = false): void {
    this.tell({ fairway: 'go', time_s, plays });
  }

  /** What can be moved in it from now on. */
  offer(handles: readonly Handle[]): void {
    this.handles = handles;
    this.tell({ fairway: 'handles', handles });
  }

  /** There is more to ask for. */
  announce(): void {
    this.tell({ fairway: 'news' });
  }

  private tell(message: object, given: Transferable[] = []): void {
    this.element.contentWindow?.postMessage(message, '*', given);
  }

  private take_moment(time_s: number, chosen: readonly number[]): void {
    this.moment = { time_s, vehicle: chosen[0] ?? 0 };
    this.beside?.go(time_s);
    if (chosen.length === 0 || chosen.join() === this.thinkers) return;
    this.thinkers = chosen.join();
    this.hands.chosen(chosen);
  }

  private async answer(id: number, first: number, generation: number): Promise<void> {
    try {
      // Whatever was told before its first question, nobody heard.
      if (first === 0 && this.handles.length > 0) this.offer(this.handles);
      const answer = await this.simulator.ask('part', first, generation);
      const { done, time_s } = answer.state;
      this.tell({ fairway: 'answer', id, answer }, bytes_of(answer));
      if (this.opens_at !== null && answer.part !== null && (time_s >= this.opens_at || done)) {
        this.go(this.opens_at, true);
        this.opens_at = null;
      }
      if (done && !this.is_over) {
        this.is_over = true;
        this.hands.over();
      }
    } catch {
      // The run is no more; a newer one has a frame of its own.
    }
  }
}
