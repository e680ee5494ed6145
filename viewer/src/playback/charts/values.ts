// SPDX-License-Identifier: Apache-2.0
// The vertical axes: where they end, what divides them, and how a value is told.
import { nice_domain, nice_step } from '../../common/scale';
import type { ChartKind } from './curves';

/** The ends of an axis that holds the values and starts and ends on round numbers. */
export function value_domain(kind: ChartKind['key'], values: number[]): [number, number] {
  if (kind !== 'heading') return nice_domain(values, 4);
  const known = values.filter(Number.isFinite);
  if (known.length === 0) return [0, 360];
  const [low, high] = [Math.min(...known), Math.max(...known)];
  const step = high - low > 300 ? 90 : high - low > 120 ? 45 : 15;
  return [Math.floor(low / step) * step, Math.max(Math.ceil(high / step), Math.floor(low / step) + 1) * step];
}

export function value_step(kind: ChartKind['key'], [low, high]: readonly [number, number]): number {
  if (kind !== 'heading') return nice_step(high - low, 4);
  return [15, 30, 45, 90, 180].find((step) => (high - low) / step <= 5) ?? 360;
}

/** A direction is told within a full turn, however often the vehicle has turned. */
export function told(kind: ChartKind['key'], value: number): number {
  return kind === 'heading' ? ((value % 360) + 360) % 360 : value;
}
