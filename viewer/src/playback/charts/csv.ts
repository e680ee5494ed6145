// SPDX-License-Identifier: Apache-2.0
import { csv_text } from '../../common/csv';
import type { ChartKind, Curves } from './curves';
import type { Store } from './store';

/** The curves at every frame, to seven significant digits: the film keeps most of them in single precision. */
export function curves_csv({ unit, title }: ChartKind, { series }: Curves, store: Store): string {
  const rows = Array.from({ length: store.count }, (_, i) =>
    [Number(store.time(i).toPrecision(12)), ...series.map((_, k) => Number(store.value(k, i).toPrecision(7)))]
      .map((value) => (Number.isFinite(value) ? value : null)));
  return csv_text([['time [s]', ...series.map(({ label }) => `${title.toLowerCase()} ${label} [${unit}]`)], ...rows]);
}
