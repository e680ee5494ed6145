// SPDX-License-Identifier: Apache-2.0
import '../common/tokens.css';
import '../common/parts.css';
import './play.css';
import { h } from '../common/dom';
import { problem_element } from '../common/problem';
import { reason_of } from '../common/reason';
import { Controls } from './controls';
import { held_data, type Held } from './data';
import type { Order } from './module';
import { parting, results_table } from './results';
import { Run } from './run';
import { address_of, first_state, state_in, type State } from './state';

const into = document.getElementById('page')!;

class Player {
  private readonly runs: Run[] = [];
  private readonly shows = h('main', { class: 'shows' }, h('p', { class: 'waiting', role: 'status' }, 'The simulator begins.'));
  private controls!: Controls;
  private turn = 0;
  private editing = false;

  constructor(private readonly held: Held, private state: State) {}

  async begin(told: string): Promise<void> {
    // The picture is made while the names, which only the controls need, are on their way.
    const place = h('aside', { class: 'controls' });
    into.replaceChildren(h('div', { class: 'play' }, place, this.shows));
    const first = this.run_at(0);
    const begun = this.begin_runs(++this.turn, null).then((commands) => () => commands, (error: unknown) => () => { throw error; });
    const names = await first.simulator.ask('names');
    this.controls = new Controls(this.held, names, {
      state: () => this.state,
      set: (state) => void this.play(state),
      now_s: () => first.time_s,
      describe: (method) => first.simulator.ask('describe', method),
      link: async () => location.href.replace(/#.*$/, '') + await address_of(this.state),
      verify: (bytes, file) => this.verify(bytes, file),
      explain: () => first.explain(),
      recording: async () => new Blob([await first.simulator.ask('recording')], { type: 'application/octet-stream' }),
    });
    place.replaceWith(this.controls.element);
    this.controls.show();
    await this.show_begun(this.turn, begun.then((commands) => commands()));
    if (told !== '') this.controls.complain(told);
  }

  private run_at(index: number): Run {
    return this.runs[index] ??= new Run(this.held, index === 0 ? 'The run' : 'The run beside it', {
      ended: () => void this.show_results(),
      edit: index === 0 ? (on) => this.edit(on) : null,
      moved: (path, position_m) => this.controls.move(path, position_m),
    });
  }

  private edit(on: boolean): void {
    this.editing = on;
    this.offer();
    if (on && this.runs[0]!.layout.handles.length === 0) this.controls.complain('Nothing can be moved here: of very many vehicles, and of a recording, nothing is.');
  }

  private orders(): Order[] {
    const { scenario, yaml, seed, set, beside, changes } = this.state;
    const file = yaml === null ? scenario : 'scenario.yaml';
    const text = yaml ?? this.held.scenarios[scenario] ?? '';
    const order = (of: State['set'], on_the_way: State['changes']): Order =>
      ({ yaml: text, file, set: of, seed, filmed: true, thinkers: [0], changes: on_the_way });
    return beside === null ? [order(set, changes)] : [order(set, changes), order(beside, [])];
  }

  /** In the first run things are moved. */
  private offer(): void {
    this.runs[0]?.offer(this.editing ? this.runs[0].layout.handles : []);
  }

  /** What is refused is said, and what was shown before stays. */
  private async play(state: State): Promise<void> {
    const newest = state.changes.at(-1)?.at_s ?? null;
    const goes_on = newest !== null && state.changes !== this.state.changes ? newest : null;
    this.state = state;
    const mine = ++this.turn;
    this.controls.show();
    this.controls.complain('');
    await this.show_begun(mine, this.begin_runs(mine, goes_on));
  }

  /** Begins what the state says, the first run to be played from this time on. Answers with the commands. */
  private async begin_runs(mine: number, goes_on: number | null): Promise<string[]> {
    const orders = this.orders();
    const commands: string[] = [];
    for (const [i, order] of orders.entries()) commands.push(await this.run_at(i).begin(order, i === 0 ? goes_on : null));
    if (mine !== this.turn) return commands;
    this.runs.splice(orders.length).forEach((run) => run.end());
    const shown = this.runs.map((run) => run.element);
    if (shown.some((element, i) => this.shows.children[i] !== element)) this.shows.replaceChildren(...shown);
    if (this.runs[1] !== undefined) this.runs[0]!.lead(this.runs[1]);
    return commands;
  }

  private async show_begun(mine: number, begun: Promise<string[]>): Promise<void> {
    try {
      const commands = await begun;
      if (mine !== this.turn) return;
      this.controls.show_command(commands.join('\n'));
      this.controls.show_vehicles(this.runs[0]!.scene!, this.runs[0]!.layout);
      this.offer();
      void this.show_results();
      history.replaceState(null, '', await address_of(this.state));
    } catch (error) {
      if (mine === this.turn) this.controls.complain(reason_of(error));
    }
  }

  private async verify(bytes: Uint8Array, file: string): Promise<void> {
    ++this.turn;
    this.controls.complain('');
    try {
      const command = await this.runs[0]!.verify(bytes, file);
      this.runs.splice(1).forEach((run) => run.end());
      this.controls.show_command(command);
      void this.show_results();
    } catch (error) {
      this.controls.complain(reason_of(error));
    }
  }

  private async show_results(): Promise<void> {
    const outcomes = this.runs.map((run) => run.outcome);
    const content: HTMLElement[] = [results_table(outcomes)];
    if (outcomes.length === 2 && outcomes.every((outcome) => outcome !== null)) {
      const [first, second] = await Promise.all(this.runs.map((run) => run.simulator.ask('hashes')));
      const at = parting(first!, second!);
      content.push(h('p', {}, at === null ? 'The two runs have the same bits.' : `They part at ${(at * this.runs[0]!.period_s).toFixed(3)} s.`));
    }
    this.controls.show_results(...content);
  }
}

function give_up(reason: string): void {
  into.replaceChildren(h('div', { class: 'problem-page' }, h('h1', {}, 'This page cannot simulate here'), h('main', {}, problem_element(reason))));
}

async function main(): Promise<void> {
  if (typeof WebAssembly === 'undefined') {
    give_up('This browser has no WebAssembly, or does not allow it. The command fairway makes the same runs: see the README.');
    return;
  }
  let state = first_state;
  let told = '';
  try {
    state = await state_in(location.hash) ?? first_state;
  } catch (error) {
    told = `The link cannot be read: ${reason_of(error)}. This is the first scenario instead.`;
  }
  const held = await held_data();
  if (!(state.scenario in held.scenarios)) {
    told = `The link is of the scenario ${state.scenario}, which this page does not have. This is the first one instead.`;
    state = first_state;
  }
  await new Player(held, state).begin(told);
}

main().catch((error: unknown) => give_up(`${reason_of(error)}.`));
