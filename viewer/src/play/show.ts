// SPDX-License-Identifier: Apache-2.0
// A run as the playback shows it: its page in a frame, which asks for the film as it asks a live run's server.
import { h } from '../common/dom';
import type { RemoteSimulator } from './simulator';

/** What the page in the frame sends (src/playback/source.ts). */
type Asked = { fairway: 'ask'; id: number; first: number; generation: number } | { fairway: 'order'; what: 'pause' | 'resume' | 'step' }
  | { fairway: 'shown'; time_s: number; chosen: number[] };

export class Show {
  readonly element: HTMLIFrameElement;
  /** Another that shows the times that this one shows. */
  beside: Show | null = null;
  /** What it shows, and the vehicle that was chosen first there. */
  moment = { time_s: 0, vehicle: 0 };
  private readonly listen = (event: MessageEvent<Asked | undefined>): void => {
    if (event.source !== this.element.contentWindow || event.data === undefined) return;
    const { data } = event;
    if (data.fairway === 'order') void this.simulator.ask('order', data.what);
    if (data.fairway === 'shown') {
      this.moment = { time_s: data.time_s, vehicle: data.chosen[0] ?? 0 };
      this.beside?.go(data.time_s);
    }
    if (data.fairway === 'ask') void this.answer(data.id, data.first, data.generation);
  };

  /** `page` is the playback's template, `document` what it is of; `over` is called once, when the run has ended. */
  constructor(private readonly simulator: RemoteSimulator, page: string, document: object, label: string, private over: () => void) {
    const json = JSON.stringify({ ...document, live: 'page' }).replaceAll('</', '<\\/').replaceAll('<!', '\\u003c!');
    this.element = h('iframe', { title: label });
    // Written so that the marker of the data, which is searched for in this page as well, is not in it.
    this.element.srcdoc = page.replace(/__FAIRWAY_[A-Z]+__/, () => json);
    window.addEventListener('message', this.listen);
  }

  end(): void {
    window.removeEventListener('message', this.listen);
    this.element.remove();
  }

  /** Shows this time. */
  go(time_s: number): void {
    this.element.contentWindow?.postMessage({ fairway: 'go', time_s }, '*');
  }

  private async answer(id: number, first: number, generation: number): Promise<void> {
    try {
      const answer = await this.simulator.ask('part', first, generation);
      if (answer.state.done) {
        this.over();
        this.over = () => {};
      }
      this.element.contentWindow?.postMessage({ fairway: 'answer', id, answer }, '*');
    } catch {
      // The run is no more; a newer one has a frame of its own.
    }
  }
}
