// SPDX-License-Identifier: Apache-2.0

export interface Scale {
  (value: number): number;
  domain: readonly [number, number];
}

/** A straight line from the domain to pixels. */
export function linear(domain: readonly [number, number], range: readonly [number, number]): Scale {
  const slope = (range[1] - range[0]) / (domain[1] - domain[0] || 1);
  const scale = (value: number): number => range[0] + (value - domain[0]) * slope;
  return Object.assign(scale, { domain });
}

/** The step among 1, 2, 5 times a power of ten that divides `span` into about `count` parts. */
export function nice_step(span: number, count: number): number {
  const raw = span / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(raw));
  const lead = raw / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

/** Round values inside [low, high]. */
export function ticks(low: number, high: number, count: number): number[] {
  return high > low ? multiples(low, high, nice_step(high - low, count)) : [low];
}

/** The multiples of `step` inside [low, high]. */
export function multiples(low: number, high: number, step: number): number[] {
  const values: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + step * 1e-9; ++i) {
    values.push(Number((i * step).toPrecision(12)));
  }
  return values;
}

/** The label of a tick, with as many decimals as the step needs. */
export function tick_digits(values: number[]): number {
  const step = values.length > 1 ? Math.abs(values[1]! - values[0]!) : 1;
  return Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9)));
}

/** A domain that holds the values, ends on round numbers and starts at zero where zero is near. */
export function nice_domain(values: number[], count: number, top?: number): [number, number] {
  const known = values.filter(Number.isFinite);
  // Long curves have more values than a call can have arguments.
  let low = known.length > 0 ? known.reduce((a, b) => Math.min(a, b)) : 0;
  let high = top ?? (known.length > 0 ? known.reduce((a, b) => Math.max(a, b)) : 1);
  if (low >= 0 && low < 0.6 * high) low = 0;
  if (!(high > low)) [low, high] = low === 0 ? [0, 1] : [low - Math.abs(low) * 0.1, low + Math.abs(low) * 0.1];
  const step = nice_step(high - low, count);
  const bottom = Math.floor(low / step + 1e-9) * step;
  return [bottom, top ?? Math.ceil(high / step - 1e-9) * step];
}

/** Equal bands along [from, to], and slots for `parts` series inside each. */
export function bands(count: number, parts: number, from: number, to: number, padding: number) {
  const width = (to - from) / Math.max(1, count);
  const inner = width * (1 - padding);
  const slot = inner / Math.max(1, parts);
  return {
    width,
    slot,
    centre: (band: number) => from + (band + 0.5) * width,
    slot_centre: (band: number, part: number) => from + band * width + (width - inner) / 2 + (part + 0.5) * slot,
  };
}
