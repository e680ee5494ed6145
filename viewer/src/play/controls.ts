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
import { take_drops } from './drop';
import type { Layout, Names, Parameter } from './module';
import { make_parameters } from './parameters';
import { make_sea } from './sea';
import { as_shipped, file_of, type State } from './state';

/** More vehicles than these are not listed one by one. */
const most_listed = 32;
/** How a recording begins: https://mcap.dev/spec */
const mcap_begins = [0x89, 0x4d, 0x43, 0x41, 0x50];

/** What the page around them does with them. */
export interface Hands {
  state(): State;
  /** The name of the recording that is shown; null: a run as the state says is. */
  recorded(): string | null;
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

function text_in(bytes: Uint8Array, name: string): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw new Error(`${name} is neither a recording (MCAP) nor text in UTF-8; save a scenario in that encoding`);
  }
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
  private readonly copy_link = action_button('Copy link', 'Copy a link to this page as it is set', 'Copied', async () => copy_text(await this.hands.link()));
  /** Whether changes of methods, goals and the exchange are from the instant that is shown on. */
  private later = false;

  constructor(private readonly held: Held, private readonly names: Names, private readonly hands: Hands) {
    const use = h('button', { type: 'button', click: () => this.use_yaml(this.yaml.value) }, 'Run this YAML');
    const shipped = h('button', { type: 'button', click: () => this.use_yaml(null) }, 'As shipped');
    take_drops(window, (file) => void this.take(file));
    const opened = h('input', { type: 'file', accept: '.mcap,.yaml,.yml', 'aria-label': 'A recording or a scenario' });
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
        this.copy_link,
        action_button('Save recording', 'Save the run as MCAP', 'Saved', () => this.save()))),
      h('details', {}, h('summary', {}, 'A recording or scenario of yours'),
        h('p', {}, 'A recording (MCAP) is simulated again here, compared frame by frame, and played. A scenario (YAML) is run. Either can be dropped anywhere on the page as well.'), opened));
  }

  /** Shows how the run is set. */
  show(): void {
    const state = this.hands.state();
    this.why.replaceChildren();
    const recorded = this.hands.recorded();
    this.copy_link.hidden = recorded !== null;
    if (recorded !== null) {
      this.show_recorded(recorded);
      return;
    }
    this.yaml.value = state.yaml ?? this.held.scenarios[state.scenario] ?? '';
    const methods = method_choices(this.names);
    const seed = h('input', { type: 'number', min: '0', step: '1', value: state.seed ?? '', placeholder: as_given, 'aria-label': 'Seed' });
    seed.addEventListener('change', () => this.hands.set({ ...state, seed: seed.value === '' ? null : seed.value }));
    this.choices.replaceChildren(
      this.scenario_chooser(state.file),
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

  /** `opened` is shown in place of a shipped one's name. */
  private scenario_chooser(opened: string | null): HTMLElement {
    const state = this.hands.state();
    const shipped = Object.keys(this.held.scenarios).map((path): Choice => [path, path.replace(/^.*\/|\.yaml$/g, ''),
      path.includes('/failures/') ? 'Where methods fail' : 'Scenarios']);
    return chooser('Scenario', opened === null ? shipped : [['', opened], ...shipped], opened === null ? state.scenario : '', (scenario) => {
      if (scenario !== '') this.hands.set({ ...as_shipped(scenario), seed: state.seed });
    });
  }

  /** Of a recording nothing is set. */
  private show_recorded(name: string): void {
    const note = (): HTMLElement => h('p', {}, 'A recording is shown as it was made. Choose a scenario to change something.');
    this.yaml.value = '';
    this.on_the_way.hidden = true;
    this.choices.replaceChildren(this.scenario_chooser(name), note());
    this.changed.replaceChildren();
    for (const part of [this.sea, this.parameters, this.vehicles]) part.replaceChildren(note());
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
    const name = `${file_of(this.hands.state())}:`;
    const place = line.startsWith(name) ? /^(\d+):(\d+): /.exec(line.slice(name.length)) : null;
    this.yaml.classList.toggle('wrong', place !== null);
    if (place === null) return;
    const lines = this.yaml.value.split('\n');
    const above = lines.slice(0, Number(place[1]) - 1).reduce((sum, each) => sum + each.length + 1, 0);
    // Columns count characters, of which some are two units of a text here.
    const from = above + Array.from(lines[Number(place[1]) - 1] ?? '').slice(0, Number(place[2]) - 1).join('').length;
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
    try {
      const { parameters } = await this.hands.describe(method);
      this.parameters.replaceChildren(make_parameters(parameters, parameters_in(set), (name, value) =>
        this.change((changes) => with_parameter(changes, name, value))));
    } catch (error) {
      this.parameters.replaceChildren(h('p', {}, `${reason_of(error)}.`));
    }
  }

  private use_yaml(yaml: string | null): void {
    const state = this.hands.state();
    this.hands.set({ ...state, yaml, file: yaml === null ? null : state.file });
  }

  /** A recording, or a scenario to be run as it is. */
  async take(file: File | undefined): Promise<void> {
    if (file === undefined) return;
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      if (mcap_begins.every((byte, i) => bytes[i] === byte) || /\.mcap$/i.test(file.name)) await this.hands.verify(bytes, file.name);
      else this.hands.set({ ...as_shipped(this.hands.state().scenario), yaml: text_in(bytes, file.name), file: file.name });
    } catch (error) {
      this.complain(reason_of(error));
    }
  }
}
