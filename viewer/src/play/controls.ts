// SPDX-License-Identifier: Apache-2.0
// What can be chosen and changed. Every change begins the run anew, or is one from the instant that is shown on.
import { buoy } from '../common/buoy';
import { h } from '../common/dom';
import { reason_of } from '../common/reason';
import { action_button, copy_text, save_blob } from '../common/save';
import { theme_toggle } from '../common/theme';
import type { Scene } from '../playback/model';
import { make_changed } from './changed';
import { chosen_paths, method_of, method_path, parameters_in, value_of, with_method, with_parameter, with_value, type Changes, type Chosen } from './changes';
import { as_given, chooser, chooser_or, method_choices, type Choice } from './chooser';
import type { Held } from './data';
import type { Layout, Names, Parameter } from './module';
import { make_parameters } from './parameters';
import { make_sea } from './sea';
import type { State } from './state';

/** More vehicles than these are not listed one by one. */
const most_listed = 32;

/** What the page around them does with them. */
export interface Hands {
  state(): State;
  /** Begins anew with this. */
  set(state: State): void;
  /** The instant that is shown [s]. */
  now_s(): number;
  describe(method: string): Promise<{ parameters: Parameter[] }>;
  link(): Promise<string>;
  /** Simulates a recording again and compares. */
  verify(bytes: Uint8Array, file: string): Promise<void>;
  /** Why the vehicle that is chosen in the picture did so, at the time that is shown. */
  explain(): Promise<HTMLElement>;
  /** MCAP, of the run that is shown. */
  recording(): Promise<Blob>;
}

export class Controls {
  readonly element = h('aside', { class: 'controls', 'aria-label': 'What is played' });
  private readonly choices = h('div');
  private readonly changed = h('div');
  private readonly trouble = h('div', { class: 'note problem', role: 'alert', hidden: true });
  private readonly parameters = h('div');
  private readonly sea = h('div');
  private readonly vehicles = h('div');
  private readonly yaml = h('textarea', { spellcheck: 'false', 'aria-label': 'The scenario as YAML' });
  private readonly command = h('code', { class: 'command' });
  private readonly on_the_way = h('p', { hidden: true });
  private readonly why = h('div', { 'aria-live': 'polite' });
  private readonly results = h('div', { class: 'results' });
  /** Whether changes of methods, goals and the exchange are from the instant that is shown on. */
  private later = false;

  constructor(private readonly held: Held, private readonly names: Names, private readonly hands: Hands) {
    const use = h('button', { type: 'button', click: () => this.use_yaml(this.yaml.value) }, 'Run this YAML');
    const shipped = h('button', { type: 'button', click: () => this.use_yaml(null) }, 'As shipped');
    this.element.addEventListener('dragover', (event) => event.preventDefault());
    this.element.addEventListener('drop', (event) => {
      event.preventDefault();
      void this.take(event.dataTransfer?.files[0]);
    });
    const opened = h('input', { type: 'file', accept: '.mcap,.yaml', 'aria-label': 'A recording or a scenario' });
    opened.addEventListener('change', () => void this.take(opened.files?.[0]));
    this.element.append(
      h('header', {}, h('span', { class: 'brand' }, buoy(), 'Fairway'), theme_toggle()),
      h('h1', {}, 'Play a scenario'),
      h('p', {}, 'The simulator itself runs in this page, and comes to the same bits as the command. Nothing is sent anywhere.'),
      this.trouble, this.choices, this.changed,
      h('details', { open: true }, h('summary', {}, 'What it came to'), this.results),
      h('details', {}, h('summary', {}, 'Why it did so'),
        h('p', {}, 'Choose a vehicle in the picture and go to an instant.'),
        h('div', { class: 'buttons' }, h('button', { type: 'button', click: () => void this.explain() }, 'Explain this instant')), this.why),
      h('details', {}, h('summary', {}, 'Parameters of the method'), this.parameters),
      h('details', {}, h('summary', {}, 'A method for each vehicle'), this.vehicles),
      h('details', {}, h('summary', {}, 'Current and waves'), this.sea),
      h('details', {}, h('summary', {}, 'The scenario as YAML'), this.yaml, h('div', { class: 'buttons' }, use, shipped,
        action_button('Copy', 'Copy the YAML', 'Copied', () => copy_text(this.yaml.value)))),
      h('details', { open: true }, h('summary', {}, 'The same run elsewhere'), this.command, this.on_the_way, h('div', { class: 'buttons' },
        action_button('Copy command', 'Copy the command that makes the same run', 'Copied', () => copy_text(this.command.textContent ?? '')),
        action_button('Copy link', 'Copy a link to this page as it is set', 'Copied', async () => copy_text(await hands.link())),
        action_button('Save recording', 'Save the run as MCAP', 'Saved', () => this.save()))),
      h('details', {}, h('summary', {}, 'A recording or scenario of yours'),
        h('p', {}, 'A recording (MCAP) is simulated again here, compared frame by frame, and played. A scenario (YAML) is run. Either can be dropped here as well.'), opened));
  }

  /** Shows how the run is set. */
  show(): void {
    const state = this.hands.state();
    this.why.replaceChildren();
    this.yaml.value = state.yaml ?? this.held.scenarios[state.scenario] ?? '';
    const methods = method_choices(this.names);
    const seed = h('input', { type: 'number', min: '0', step: '1', value: state.seed ?? '', placeholder: as_given, 'aria-label': 'Seed' });
    seed.addEventListener('change', () => this.hands.set({ ...state, seed: seed.value === '' ? null : seed.value }));
    this.choices.replaceChildren(
      chooser('Scenario', Object.keys(this.held.scenarios).map((path): Choice => [path, path.replace(/^.*\/|\.yaml$/g, ''),
        path.includes('/failures/') ? 'Where methods fail' : 'Scenarios']), state.scenario,
      (scenario) => this.hands.set({ ...state, scenario, yaml: null, set: [], beside: null, changes: [] })),
      chooser('A change counts', [['', 'from the beginning'], ['later', 'from the instant that is shown']], this.later ? 'later' : '',
        (when) => { this.later = when !== ''; }),
      chooser_or('Method', methods, method_of(this.all()), (name) => this.change((set) => with_method(set, name))),
      chooser('Beside it, under the same seed', [['', 'nothing'], ...methods], state.beside === null ? '' : method_of(state.beside) ?? '',
        (name) => this.hands.set({ ...state, beside: name === '' ? null : with_method(state.set, name) })),
      this.chosen_for_all('Vehicles', 'model', this.names.vehicles),
      this.chosen_for_all('How they hear each other', 'exchange', this.names.exchanges),
      h('label', {}, 'Seed', seed));
    this.changed.replaceChildren(make_changed(state, (next) => this.hands.set(next)));
    this.on_the_way.hidden = state.changes.length === 0;
    this.on_the_way.textContent = `From ${state.changes[0]?.at_s ?? 0} s on this run is changed on its way. No command does that: this one makes it up to there.`;
    this.sea.replaceChildren(make_sea(this.names.schema, state.set, (set) => this.set_for_both((changes) =>
      set.filter(([path]) => path.startsWith('water.')).reduce((all, [path, value]) => with_value(all, path, value),
        changes.filter(([path]) => !path.startsWith('water.'))))));
    void this.show_parameters();
  }

  /** Of the run that has begun: a method for each vehicle, and how many a fleet has. */
  show_vehicles(scene: Scene, { fleet_count }: Layout): void {
    const set = this.all();
    const methods = method_choices(this.names);
    const rows = scene.vehicles.length > most_listed ? [h('p', {}, `There are ${scene.vehicles.length} of them.`)]
      : scene.vehicles.map(({ name }, i) => chooser_or(name, methods, value_of(set, method_path(i)),
        (method) => this.change((changes) => with_value(changes, method_path(i), method))));
    if (fleet_count !== null) {
      const count = h('input', { type: 'number', min: '1', step: '1', value: String(fleet_count), 'aria-label': 'How many the fleet has' });
      count.addEventListener('change', () => this.set_for_both((changes) => with_value(changes, 'fleet.count', count.value)));
      rows.unshift(h('label', {}, 'How many the fleet has', count));
    }
    this.vehicles.replaceChildren(...rows);
  }

  /** Something was moved in the picture: a goal perhaps on the way. */
  move(path: string, position_m: readonly number[]): void {
    const value = `[${position_m.join(', ')}]`;
    if (this.later && path.includes('.mission[')) this.change((changes) => with_value(changes, path, value));
    else this.set_for_both((changes) => with_value(changes, path, value));
  }

  show_command(text: string): void {
    this.command.textContent = text;
  }

  show_results(...content: HTMLElement[]): void {
    this.results.replaceChildren(...content);
  }

  /** A line of the simulator about what it refuses; where it names a place in the YAML, that is shown. Empty: all is well. */
  complain(line: string): void {
    this.trouble.hidden = line === '';
    this.trouble.replaceChildren(h('b', {}, 'Not run'), h('p', {}, line));
    const place = /^[^:]*:(\d+):(\d+): /.exec(line);
    this.yaml.classList.toggle('wrong', place !== null);
    if (place === null) return;
    const before = this.yaml.value.split('\n').slice(0, Number(place[1]) - 1).join('\n').length;
    const from = before + (place[1] === '1' ? 0 : 1) + Number(place[2]) - 1;
    this.yaml.closest('details')?.setAttribute('open', '');
    this.yaml.focus();
    const end = this.yaml.value.indexOf('\n', from);
    this.yaml.setSelectionRange(from, end < 0 ? this.yaml.value.length : end);
  }

  private async explain(): Promise<void> {
    try {
      this.why.replaceChildren(await this.hands.explain());
    } catch (error) {
      this.why.replaceChildren(h('p', {}, reason_of(error)));
    }
  }

  private async save(): Promise<boolean> {
    try {
      save_blob('run.mcap', await this.hands.recording());
      return true;
    } catch (error) {
      this.complain(reason_of(error));
      return false;
    }
  }

  /** What is changed in the first run by its end. */
  private all(): Changes {
    const { set, changes } = this.hands.state();
    return changes.reduce((all: Changes, later) => later.set.reduce((now: Changes, [path, value]) => with_value(now, path, value), all), set);
  }

  /** In the first run, from the beginning or from the instant that is shown on: what was changed later than that is gone. */
  private change(edit: (changes: Changes) => Changes): void {
    const state = this.hands.state();
    if (!this.later) return this.hands.set({ ...state, set: edit(state.set) });
    const at_s = this.hands.now_s();
    const same = state.changes.find((change) => change.at_s === at_s);
    const set = edit(same?.set ?? []);
    const before = state.changes.filter((change) => change.at_s < at_s);
    this.hands.set({ ...state, changes: set.length === 0 ? before : [...before, { at_s, set }] });
  }

  /** In both runs, from the beginning. */
  private set_for_both(edit: (changes: Changes) => Changes): void {
    const state = this.hands.state();
    this.hands.set({ ...state, set: edit(state.set), beside: state.beside === null ? null : edit(state.beside) });
  }

  /** Chosen by name for both runs; the exchange perhaps on the way. */
  private chosen_for_all(label: string, what: Chosen, kinds: readonly { name: string; title: string }[]): HTMLElement {
    const choices = kinds.map(({ name, title }): Choice => [name, `${name}: ${title}`]);
    const path = chosen_paths[what];
    return chooser_or(label, choices, value_of(this.all(), path), (name) => {
      const edit = (changes: Changes): Changes => with_value(changes, path, name);
      if (this.later && what === 'exchange') this.change(edit);
      else this.set_for_both(edit);
    });
  }

  private async show_parameters(): Promise<void> {
    const set = this.all();
    const method = method_of(set);
    if (method === null) {
      this.parameters.replaceChildren(h('p', {}, 'Choose a method to change its parameters; the scenario may give each vehicle another.'));
      return;
    }
    const { parameters } = await this.hands.describe(method);
    this.parameters.replaceChildren(make_parameters(parameters, parameters_in(set), (name, value) =>
      this.change((changes) => with_parameter(changes, name, value))));
  }

  private use_yaml(yaml: string | null): void {
    this.hands.set({ ...this.hands.state(), yaml });
  }

  private async take(file: File | undefined): Promise<void> {
    if (file === undefined) return;
    if (file.name.endsWith('.mcap')) await this.hands.verify(new Uint8Array(await file.arrayBuffer()), file.name);
    else this.use_yaml(await file.text());
  }
}
