// SPDX-License-Identifier: Apache-2.0
// What can be chosen and changed. Every change begins the run anew.
import { buoy } from '../common/buoy';
import { h } from '../common/dom';
import { action_button, copy_text, save_blob } from '../common/save';
import { theme_toggle } from '../common/theme';
import { chosen_of, method_of, parameters_in, with_chosen, with_method, with_parameter, type Changes, type Chosen } from './changes';
import type { Held } from './data';
import type { Names, Parameter } from './module';
import { make_parameters } from './parameters';
import type { State } from './state';

const as_given = 'as the scenario says';

type Choice = [value: string, label: string, group?: string];

function chooser(label: string, choices: Choice[], value: string, change: (value: string) => void): HTMLElement {
  const select = h('select', { 'aria-label': label });
  for (const [name, text, group] of choices) {
    const option = h('option', { value: name, selected: name === value }, text);
    const last = select.lastElementChild;
    if (group === undefined) select.append(option);
    else if (last instanceof HTMLOptGroupElement && last.label === group) last.append(option);
    else select.append(h('optgroup', { label: group }, option));
  }
  select.addEventListener('change', () => change(select.value));
  return h('label', {}, label, select);
}

/** What the page around them does with them. */
export interface Hands {
  state(): State;
  /** Begins anew with this. */
  set(state: State): void;
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
  private readonly trouble = h('div', { class: 'note problem', role: 'alert', hidden: true });
  private readonly parameters = h('div');
  private readonly yaml = h('textarea', { spellcheck: 'false', 'aria-label': 'The scenario as YAML' });
  private readonly command = h('code', { class: 'command' });
  private readonly why = h('div', { 'aria-live': 'polite' });
  private readonly results = h('div', { class: 'results' });

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
      this.trouble, this.choices,
      h('details', { open: true }, h('summary', {}, 'What it came to'), this.results),
      h('details', {}, h('summary', {}, 'Why it did so'),
        h('p', {}, 'Choose a vehicle in the picture and go to an instant.'),
        h('div', { class: 'buttons' }, h('button', { type: 'button', click: () => void this.explain() }, 'Explain this instant')), this.why),
      h('details', {}, h('summary', {}, 'Parameters of the method'), this.parameters),
      h('details', {}, h('summary', {}, 'The scenario as YAML'), this.yaml, h('div', { class: 'buttons' }, use, shipped,
        action_button('Copy', 'Copy the YAML', 'Copied', () => copy_text(this.yaml.value)))),
      h('details', { open: true }, h('summary', {}, 'The same run elsewhere'), this.command, h('div', { class: 'buttons' },
        action_button('Copy command', 'Copy the command that makes the same run', 'Copied', () => copy_text(this.command.textContent ?? '')),
        action_button('Copy link', 'Copy a link to this page as it is set', 'Copied', async () => copy_text(await hands.link())),
        action_button('Save recording', 'Save the run as MCAP', 'Saved', async () => save_blob('run.mcap', await hands.recording())))),
      h('details', {}, h('summary', {}, 'A recording or scenario of yours'),
        h('p', {}, 'A recording (MCAP) is simulated again here, compared frame by frame, and played. A scenario (YAML) is run. Either can be dropped here as well.'), opened));
  }

  /** Shows how the run is set. */
  show(): void {
    const state = this.hands.state();
    this.why.replaceChildren();
    this.yaml.value = state.yaml ?? this.held.scenarios[state.scenario] ?? '';
    const change = (changed: Partial<State>): void => this.hands.set({ ...state, ...changed });
    const seed = h('input', { type: 'number', min: '0', step: '1', value: state.seed ?? '', placeholder: as_given, 'aria-label': 'Seed' });
    seed.addEventListener('change', () => change({ seed: seed.value === '' ? null : seed.value }));
    const methods = this.method_choices();
    this.choices.replaceChildren(
      chooser('Scenario', Object.keys(this.held.scenarios).map((path): Choice => [path, path.replace(/^.*\/|\.yaml$/g, ''),
        path.includes('/failures/') ? 'Where methods fail' : 'Scenarios']), state.scenario,
      (scenario) => change({ scenario, yaml: null, set: [], beside: null })),
      chooser('Method', [['', as_given], ...methods], method_of(state.set) ?? '',
        (name) => change({ set: with_method(state.set, name === '' ? null : name) })),
      chooser('Beside it, under the same seed', [['', 'nothing'], ...methods], state.beside === null ? '' : method_of(state.beside) ?? '',
        (name) => change({ beside: name === '' ? null : with_method(state.set, name) })),
      this.chosen_for_all('Vehicles', 'model', this.names.vehicles),
      this.chosen_for_all('How they hear each other', 'exchange', this.names.exchanges),
      h('label', {}, 'Seed', seed));
    void this.show_parameters(state.set);
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
      this.why.replaceChildren(h('p', {}, error instanceof Error ? error.message : String(error)));
    }
  }

  /** Chosen by name for both runs. */
  private chosen_for_all(label: string, what: Chosen, kinds: readonly { name: string; title: string }[]): HTMLElement {
    const state = this.hands.state();
    const choices = kinds.map(({ name, title }): Choice => [name, `${name}: ${title}`]);
    return chooser(label, [['', as_given], ...choices], chosen_of(state.set, what) ?? '', (chosen) => {
      const name = chosen === '' ? null : chosen;
      this.hands.set({
        ...state, set: with_chosen(state.set, what, name), beside: state.beside === null ? null : with_chosen(state.beside, what, name),
      });
    });
  }

  private method_choices(): Choice[] {
    const base = this.names.algorithms.filter(({ wraps }) => !wraps);
    const around = this.names.algorithms.filter(({ wraps }) => wraps);
    return [
      ...base.map(({ name, title }): Choice => [name, `${name}: ${title}`, 'Methods']),
      ...around.map(({ name, title }): Choice => [`orca3d+${name}`, `orca3d+${name}: ${title}`, 'A strategy around a method']),
    ];
  }

  private async show_parameters(changes: Changes): Promise<void> {
    const method = method_of(changes);
    if (method === null) {
      this.parameters.replaceChildren(h('p', {}, 'Choose a method to change its parameters; the scenario may give each vehicle another.'));
      return;
    }
    const { parameters } = await this.hands.describe(method);
    const state = this.hands.state();
    this.parameters.replaceChildren(make_parameters(parameters, parameters_in(changes), (name, value) =>
      this.hands.set({ ...state, set: with_parameter(state.set, name, value) })));
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
