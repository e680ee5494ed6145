// SPDX-License-Identifier: Apache-2.0
import '../common/tokens.css';
import '../common/parts.css';
import './play.css';
import { h } from '../common/dom';
import { problem_element } from '../common/problem';
import { Controls } from './controls';
import { held_data, type Held } from './data';
import type { Order } from './module';
import { parting, results_table } from './results';
import { Run } from './run';
import { address_of, first_state, state_in, type State } from './state';

const into = document.getElementById('page')!;
const text_of = (error: unknown): string => (error instanceof Error ? error.message : String(error));

class Player {
  private readonly runs: Run[] = [];
  private readonly shows = h('main', { class: 'shows' }, h('p', { class: 'waiting', role: 'status' }, 'The simulator begins.'));
  private controls!: Controls;
  private turn = 0;

  constructor(private readonly held: Held, private state: State) {}

  async begin(told: string): Promise<void> {
    const first = this.run_at(0);
    const names = await first.simulator.ask('names');
    this.controls = new Controls(this.held, names, {
      state: () => this.state,
      set: (state) => void this.play(state),
      describe: (method) => first.simulator.ask('describe', method),
      link: async () => location.href.replace(/#.*$/, '') + await address_of(this.state),
      verify: (bytes, file) => this.verify(bytes, file),
      explain: () => first.explain(),
      recording: async () => new Blob([await first.simulator.ask('recording')], { type: 'application/octet-stream' }),
    });
    into.replaceChildren(h('div', { class: 'play' }, this.controls.element, this.shows));
    await this.play(this.state);
    if (told !== '') this.controls.complain(told);
  }

  private run_at(index: number): Run {
    return this.runs[index] ??= new Run(this.held, index === 0 ? 'The run' : 'The run beside it', () => void this.show_results());
  }

  private orders(): Order[] {
    const { scenario, yaml, seed, set, beside } = this.state;
    const file = yaml === null ? scenario : 'scenario.yaml';
    const order = (changes: State['set']): Order => ({ yaml: yaml ?? this.held.scenarios[scenario] ?? '', file, set: changes, seed, filmed: true });
    return beside === null ? [order(set)] : [order(set), order(beside)];
  }

  /** What is refused is said, and what was shown before stays. */
  private async play(state: State): Promise<void> {
    this.state = state;
    const mine = ++this.turn;
    this.controls.show();
    this.controls.complain('');
    try {
      const orders = this.orders();
      const commands: string[] = [];
      for (const [i, order] of orders.entries()) commands.push(await this.run_at(i).begin(order));
      if (mine !== this.turn) return;
      this.runs.splice(orders.length).forEach((run) => run.end());
      const shown = this.runs.map((run) => run.element);
      if (shown.some((element, i) => this.shows.children[i] !== element)) this.shows.replaceChildren(...shown);
      if (this.runs[1] !== undefined) this.runs[0]!.lead(this.runs[1]);
      this.controls.show_command(commands.join('\n'));
      void this.show_results();
      history.replaceState(null, '', await address_of(state));
    } catch (error) {
      if (mine === this.turn) this.controls.complain(text_of(error));
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
      this.controls.complain(text_of(error));
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
    told = `The link cannot be read: ${text_of(error)}. This is the first scenario instead.`;
  }
  const held = await held_data();
  if (!(state.scenario in held.scenarios)) {
    told = `The link is of the scenario ${state.scenario}, which this page does not have. This is the first one instead.`;
    state = first_state;
  }
  await new Player(held, state).begin(told);
}

main().catch((error: unknown) => give_up(`${text_of(error)}.`));
