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
import { address_of, as_shipped, file_of, first_state, state_in, type State } from './state';

const into = document.getElementById('page')!;
const address_alone = (): string => location.href.replace(/#.*$/, '');
const sentence = (text: string): string => (/[.?!]$/.test(text) ? text : `${text}.`);

/** What an address asks for; null: nothing. Throws where this page cannot read it. */
async function asked_in(address: string, held: Held): Promise<State | null> {
  const state = await state_in(address);
  if (state !== null && !Object.hasOwn(held.scenarios, state.scenario)) throw new Error(`it is of the scenario ${state.scenario}, which this page does not have`);
  return state;
}

class Player {
  private readonly runs: Run[] = [];
  private readonly shows = h('main', { class: 'shows' }, h('p', { class: 'waiting', role: 'status' }, 'The simulator begins.'));
  private controls!: Controls;
  private turn = 0;
  private editing = false;
  /** Of what is shown. */
  private address = '';
  /** The name of the recording that is shown; null: none is. */
  private recorded: string | null = null;

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
      recorded: () => this.recorded,
      set: (state) => void this.play(state),
      now_s: () => first.time_s,
      describe: (method) => first.simulator.ask('describe', method),
      link: async () => address_alone() + await address_of(this.state),
      verify: (bytes, file) => this.verify(bytes, file),
      explain: () => first.explain(),
      recording: async () => new Blob([await first.simulator.ask('recording')], { type: 'application/octet-stream' }),
    });
    place.replaceWith(this.controls.element);
    this.controls.show();
    const refused = await this.show_begun(this.turn, begun.then((commands) => commands()));
    if (refused !== '') await this.fall_back(refused);
    else if (told !== '') this.controls.complain(told);
    window.addEventListener('hashchange', () => void this.follow(location.hash));
  }

  /** What a link asks for that is put into the open page. */
  private async follow(address: string): Promise<void> {
    try {
      const state = await asked_in(address, this.held);
      if (state === null) return;
      const refused = await this.play(state);
      if (refused !== '') await this.fall_back(refused);
    } catch (error) {
      this.controls.complain(`The link cannot be read: ${sentence(reason_of(error))} What was played goes on.`);
      this.say_address(this.address);
    }
  }

  private say_address(address: string): void {
    this.address = address;
    history.replaceState(null, '', address_alone() + address);
  }

  /** From a link that is refused. */
  private async fall_back(refused: string): Promise<void> {
    const { scenario } = this.state;
    if (await this.play(as_shipped(scenario)) !== '') return;
    this.controls.complain(`What the link asks for is refused: ${sentence(refused)} This is ${scenario} as it is shipped.`);
  }

  private run_at(index: number): Run {
    return this.runs[index] ??= new Run(this.held, index === 0 ? 'The run' : 'The run beside it', {
      ended: () => void this.show_results(),
      edit: index === 0 ? (on) => this.edit(on) : null,
      moved: (path, position_m) => this.controls.move(path, position_m),
      dropped: (file) => void this.controls.take(file),
    });
  }

  private edit(on: boolean): void {
    this.editing = on;
    this.offer();
    if (on && this.runs[0]!.layout.handles.length === 0) this.controls.complain('Nothing can be moved here: of very many vehicles, and of a recording, nothing is.');
  }

  private orders(): Order[] {
    const { scenario, yaml, seed, set, beside, changes } = this.state;
    const file = file_of(this.state);
    const text = yaml ?? this.held.scenarios[scenario] ?? '';
    const order = (of: State['set'], on_the_way: State['changes']): Order =>
      ({ yaml: text, file, set: of, seed, filmed: true, thinkers: [0], changes: on_the_way });
    return beside === null ? [order(set, changes)] : [order(set, changes), order(beside, [])];
  }

  /** In the first run things are moved. */
  private offer(): void {
    this.runs[0]?.offer(this.editing ? this.runs[0].layout.handles : []);
  }

  /** What is refused is said and answered with, and what was shown before goes on. */
  private async play(state: State): Promise<string> {
    const newest = state.changes.at(-1)?.at_s ?? null;
    const goes_on = newest !== null && state.changes !== this.state.changes ? newest : null;
    this.state = state;
    this.recorded = null;
    const mine = ++this.turn;
    this.controls.show();
    this.controls.complain('');
    return this.show_begun(mine, this.begin_runs(mine, goes_on));
  }

  /** Begins what the state says, the first run to be played from this time on. Answers with the commands. */
  private async begin_runs(mine: number, goes_on: number | null): Promise<string[]> {
    const orders = this.orders();
    const commands: string[] = [];
    try {
      for (const [i, order] of orders.entries()) commands.push(await this.run_at(i).begin(order, i === 0 ? goes_on : null));
    } catch (error) {
      if (mine === this.turn && this.runs[1]?.scene === null) this.runs.splice(1).forEach((run) => run.end());
      throw error;
    }
    if (mine !== this.turn) return commands;
    this.runs.splice(orders.length).forEach((run) => run.end());
    const shown = this.runs.map((run) => run.element);
    if (shown.some((element, i) => this.shows.children[i] !== element)) this.shows.replaceChildren(...shown);
    if (this.runs[1] !== undefined) this.runs[0]!.lead(this.runs[1]);
    return commands;
  }

  /** Answers with what is refused; empty: nothing. */
  private async show_begun(mine: number, begun: Promise<string[]>): Promise<string> {
    try {
      const commands = await begun;
      if (mine !== this.turn) return '';
      this.controls.show_command(commands.join('\n'));
      this.controls.show_vehicles(this.runs[0]!.scene!, this.runs[0]!.layout);
      this.offer();
      void this.show_results();
      this.say_address(await address_of(this.state));
      return '';
    } catch (error) {
      if (mine !== this.turn) return '';
      this.controls.complain(reason_of(error));
      return reason_of(error);
    }
  }

  private async verify(bytes: Uint8Array, file: string): Promise<void> {
    const mine = ++this.turn;
    this.controls.complain('');
    try {
      const command = await this.runs[0]!.verify(bytes, file);
      if (mine !== this.turn) return;
      this.runs.splice(1).forEach((run) => run.end());
      this.state = as_shipped(this.state.scenario);
      this.recorded = file;
      this.say_address('');
      this.controls.show();
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
  const held = await held_data();
  let state = first_state;
  let told = '';
  try {
    state = await asked_in(location.hash, held) ?? first_state;
  } catch (error) {
    told = `The link cannot be read: ${sentence(reason_of(error))} This is the first scenario instead.`;
  }
  await new Player(held, state).begin(told);
}

main().catch((error: unknown) => give_up(`${reason_of(error)}.`));
