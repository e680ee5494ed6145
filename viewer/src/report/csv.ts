// SPDX-License-Identifier: Apache-2.0
import { csv_field } from '../common/csv';
import type { Column, TableBlock } from './model';

export function heading(column: Column): string {
  return column.unit === '' ? column.label : `${column.label} [${column.unit}]`;
}

/** The table as CSV with full precision; `rows` are those to be written, in their order. */
export function to_csv({ columns }: TableBlock, rows: TableBlock['rows']): string {
  const lines = [columns.map((column) => csv_field(heading(column))).join(',')];
  for (const row of rows) lines.push(columns.map((column) => csv_field(row[column.key])).join(','));
  return lines.join('\r\n') + '\r\n';
}
