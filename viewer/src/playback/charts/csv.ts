// SPDX-License-Identifier: Apache-2.0
import { csv_field } from '../../common/csv';
import type { ChartKind, Curves } from './curves';
import type { Store } from './store';

/** The curves at every frame, to seven significant digits: the film keeps most of them in single precision. */
export function curves_csv({ unit, title }: ChartKind, { series }: Curves, store: Store): string {
  const lines = [['time [s]', ...series.map(({ label }) => `${title.toLowerCase()} ${label} [${unit}]`)].map(csv_field).join(',')];
  for (let i = 0; i < store.count; ++i) {
    const cells = [Number(store.time(i).toPrecision(12)), ...series.map((_, k) => Number(store.value(k, i).toPrecision(7)))];
    lines.push(cells.map((value) => (Number.isFinite(value) ? String(value) : '')).join(','));
  }
  return lines.join('\r\n') + '\r\n';
}
