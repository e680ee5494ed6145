// SPDX-License-Identifier: Apache-2.0
// One of the runs of the page: its simulator, and what is shown of it.
import { h } from '../common/dom';
import { make_explanation } from '../playback/explanation/explanation';
import type { Scene } from '../playback/model';
import type { Handle } from '../playback/source';
import type { Held } from './data';
import type { Begun, Layout, Order, Outcome } from './module';
import { Show } from './show';
import { RemoteSimulator } from './simulator';

export interface RunHands {
  /** Its outcome is there. */
  ended(): void;
  /** Null: nothing can be moved in it. */
  edit: ((on: boolean) => void) | null;
  moved(path: string, position_m: readonly number[]): void;
  dropped(file: File): void;
}

export class Run {
  readonly simulator: RemoteSimulator;
  readonly element = h('div', { class: 'one' });
  /** How it ended; null while it goes on. */
  outcome: Outcome | null = null;
  /** Between frames [s]. */
  period_s = 0;
  scene: Scene | null = null;
  layout: Layout = { handles: [], fleet_count: null };
  /** Whose thoughts are filmed: of those that are chosen, at first of the first. */
  private thinkers: readonly number[] = [0];
  private show: Show | null = null;

  /** From now on the other run shows the times that this one shows. */
  lead(other: Run): void {
    if (this.show !== null) this.show.beside = other.show;
  }

  constructor(private readonly held: Held, private readonly label: string, private readonly hands: RunHands) {
    this.simulator = new RemoteSimulator(held.module);
  }

  /** Begins anew, and plays from this time on; what was shown before is gone. Answers with the command that makes the same run, rejects
   *  with what is wrong with the order. */
  begin(order: Order, from_s: number | null): Promise<string> {
    return this.show_run(this.simulator.ask('begin', order), from_s);
  }

  /** Likewise the run of a recording. */
  verify(bytes: Uint8Array, file: string): Promise<string> {
    return this.show_run(this.simulator.ask('verify', bytes, file), null);
  }

  /** Shows what can be moved, or no longer. */
  offer(handles: readonly Handle[]): void {
    this.show?.offer(handles);
  }

  /** The instant that is shown [s]. */
  get time_s(): number {
    return this.show?.moment.time_s ?? 0;
  }

  /** Why the vehicle that is chosen in the picture decided as it did by the time that is shown. */
  async explain(): Promise<HTMLElement> {
    const { show, scene } = this;
    if (show === null || scene === null) throw new Error('no run has begun');
    const { vehicle, time_s } = show.moment;
    return make_explanation(await this.simulator.ask('explanation', String(vehicle), time_s), scene, (time) => show.go(time));
  }

  end(): void {
    this.show?.end();
    this.simulator.end();
    this.element.remove();
  }

  private async show_run(begun: Promise<Begun>, from_s: number | null): Promise<string> {
    const { document, layout } = await begun;
    this.outcome = null;
    this.thinkers = [0];
    this.layout = layout;
    this.period_s = Number(document['period_s']);
    this.scene = document['scene'] as Scene;
    this.show?.end();
    this.show = new Show(this.simulator, this.held.playback, document, this.label, {
      over: () => void this.end_run(),
      edit: this.hands.edit,
      moved: (path, position_m) => this.hands.moved(path, position_m),
      chosen: (vehicles) => void this.think(vehicles),
      dropped: (file) => this.hands.dropped(file),
    }, from_s);
    this.element.replaceChildren(this.show.element);
    return String(document['command']);
  }

  private async think(vehicles: readonly number[]): Promise<void> {
    if (vehicles.join() === this.thinkers.join()) return;
    this.thinkers = vehicles;
    await this.simulator.ask('think', vehicles);
    this.show?.announce();
  }

  private async end_run(): Promise<void> {
    this.outcome = await this.simulator.ask('outcome');
    this.hands.ended();
  }
}
