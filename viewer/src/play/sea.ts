// SPDX-License-Identifier: Apache-2.0
// Current and waves as controls: what they write are the keys of the scenario's water.
import { h } from '../common/dom';
import { value_of, with_value, type Changes } from './changes';
import type { Parameter } from './module';
import { make_parameters } from './parameters';
import { key_of } from './schema';

const uniform = 'water.current_mps';
const wandering = 'water.current';
const waves = 'water.waves';

/** What the controls stand at. */
interface Sea {
  north: number;
  east: number;
  /** Of the current's speed, which wanders if this is not 0. */
  deviation: number;
  height: number;
  period: number;
}
const calm: Sea = { north: 0, east: 0, deviation: 0, height: 0, period: 5 };

const number_after = (text: string | null, key: string): number => Number(new RegExp(`${key}: (-?[\\d.]+)`).exec(text ?? '')?.[1] ?? 0);

function sea_in(changes: Changes): Sea {
  const [north = 0, east = 0] = (value_of(changes, uniform) ?? '').replace(/[[\]]/g, '').split(',').map(Number);
  const wander = value_of(changes, wandering);
  const towards = (number_after(wander, 'direction_deg') * Math.PI) / 180;
  const speed = number_after(wander, 'mean_speed_mps');
  const wave = value_of(changes, waves);
  return {
    north: wander === null ? north : Number((speed * Math.cos(towards)).toFixed(6)), east: wander === null ? east : Number((speed * Math.sin(towards)).toFixed(6)),
    deviation: number_after(wander, 'deviation_mps'),
    height: number_after(wave, 'significant_height_m'), period: wave === null ? calm.period : number_after(wave, 'peak_period_s'),
  };
}

/** Only one kind of current may be given. */
function with_sea(changes: Changes, { north, east, deviation, height, period }: Sea): Changes {
  const flows = north !== 0 || east !== 0;
  const degrees = Number(((Math.atan2(east, north) * 180) / Math.PI).toFixed(2));
  const wander = `{gauss_markov: {mean_speed_mps: ${Number(Math.hypot(north, east).toPrecision(6))}, deviation_mps: ${deviation}, direction_deg: ${degrees}}}`;
  const wave = `{spectrum: jonswap, significant_height_m: ${height}, peak_period_s: ${period}}`;
  const still = with_value(changes, uniform, flows && deviation === 0 ? `[${north}, ${east}, 0]` : null);
  return with_value(with_value(still, wandering, deviation > 0 ? wander : null), waves, height > 0 ? wave : null);
}

/** `changed` hears of the changes with another sea. */
export function make_sea(schema: unknown, changes: Changes, changed: (changes: Changes) => void): HTMLElement {
  const sea = sea_in(changes);
  const current = key_of(schema, ['water'], 'current_mps');
  const called = (name: string, parameter: Parameter, meaning: string, reach?: number): Parameter =>
    ({ ...parameter, name, meaning, range: reach === undefined ? parameter.range! : [parameter.range![0] === 0 ? 0 : -reach, reach] });
  const of = (within: string, name: string): Parameter => key_of(schema, ['water', within], name);
  const shown: [keyof Sea, Parameter][] = [
    ['north', called('current north', current, 'How fast it runs north', 1)],
    ['east', called('current east', current, 'How fast it runs east', 1)],
    ['deviation', called('current wanders by', of('gauss_markov', 'deviation_mps'), of('gauss_markov', 'deviation_mps').meaning, 0.5)],
    ['height', called('wave height', of('waves', 'significant_height_m'), of('waves', 'significant_height_m').meaning, 3)],
    ['period', { ...called('wave period', of('waves', 'peak_period_s'), of('waves', 'peak_period_s').meaning), range: [2, 15], default: calm.period }],
  ];
  const given = new Map(shown.filter(([key]) => sea[key] !== calm[key]).map(([key, { name }]) => [name, String(sea[key])]));
  return h('div', {}, make_parameters(shown.map(([, parameter]) => parameter), given, (name, value) => {
    const [key] = shown.find(([, parameter]) => parameter.name === name)!;
    changed(with_sea(changes, { ...sea, [key]: value === null ? calm[key] : Number(value) }));
  }));
}
