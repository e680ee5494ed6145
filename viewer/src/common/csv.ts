// SPDX-License-Identifier: Apache-2.0

type Field = string | number | null | undefined;

function quoted(value: Field): string {
  const text = value === null || value === undefined ? '' : String(value);
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Lines of CSV, each field quoted where it has to be. */
export function csv_text(rows: readonly (readonly Field[])[]): string {
  return rows.map((row) => row.map(quoted).join(',') + '\r\n').join('');
}
