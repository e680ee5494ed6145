// SPDX-License-Identifier: Apache-2.0
// A method's parameters as controls: names, units, ranges, defaults and meanings are those that the simulator declares.
import { h } from '../common/dom';
import type { Parameter } from './module';

const slider_steps = 200;

/** A range without an end is shown up to ten times the default. */
function ends({ range, default: usual }: Parameter): [number, number] {
  const reach = 10 * Math.max(Math.abs(Number(usual)), 0.1);
  const [low, high] = range ?? [null, null];
  const bounded = (bound: number | null, otherwise: number): number => (bound === null || Math.abs(bound) > 1e3 * reach ? otherwise : bound);
  return [bounded(low, Number(usual) < 0 ? -reach : 0), bounded(high, reach)];
}

function numeric(parameter: Parameter, value: string, change: (value: string) => void): HTMLElement[] {
  const [low, high] = ends(parameter);
  const step = parameter.type === 'integer' ? 1 : (high - low) / slider_steps;
  const slider = h('input', { type: 'range', min: String(low), max: String(high), step: String(step), 'aria-label': parameter.name });
  const field = h('input', { type: 'number', step: 'any', 'aria-label': `${parameter.name}, typed` });
  slider.value = value;
  field.value = value;
  slider.addEventListener('input', () => { field.value = String(Number(Number(slider.value).toPrecision(4))); });
  slider.addEventListener('change', () => change(field.value));
  field.addEventListener('change', () => {
    slider.value = field.value;
    change(field.value);
  });
  return [slider, field];
}

function control(parameter: Parameter, value: string, change: (value: string) => void): HTMLElement[] {
  if (parameter.type === 'number' || parameter.type === 'integer') return numeric(parameter, value, change);
  const choices = parameter.choices ?? ['true', 'false'];
  const choice = h('select', { 'aria-label': parameter.name }, ...choices.map((name) => h('option', { value: name, selected: name === value }, name)));
  choice.addEventListener('change', () => change(choice.value));
  return [choice];
}

/** `given` are values by name that differ from the defaults; `changed` hears of a new one, null where it is the default again. */
export function make_parameters(parameters: readonly Parameter[], given: ReadonlyMap<string, string>,
                                changed: (name: string, value: string | null) => void): HTMLElement {
  const rows = parameters.filter((parameter) => parameter.type !== 'list').map((parameter) => {
    const usual = String(parameter.default);
    const unit = parameter.unit === undefined || parameter.unit === '' ? '' : ` [${parameter.unit}]`;
    return h('div', { class: given.has(parameter.name) ? 'parameter changed' : 'parameter', title: `${parameter.meaning}. Default ${usual}.` },
      h('span', { class: 'name' }, `${parameter.name}${unit}`),
      ...control(parameter, given.get(parameter.name) ?? usual, (value) => changed(parameter.name, value === usual ? null : value)),
      h('small', {}, parameter.meaning));
  });
  return h('div', { class: 'parameters' }, ...rows);
}
