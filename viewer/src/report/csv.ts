// SPDX-License-Identifier: Apache-2.0
import { csv_text } from '../common/csv';
import type { Column, TableBlock } from './model';

export function heading(column: Column): string {
  return column.unit === '' ? column.label : `${column.label} [${column.unit}]`;
}

/** The table as CSV with full precision; `rows` are those to be written, in their order. */
export function to_csv({ columns }: TableBlock, rows: TableBlock['rows']): string {
  return csv_text([columns.map(heading), ...rows.map((row) => columns.map(({ key }) => row[key]))]);
}
