// SPDX-License-Identifier: Apache-2.0

/** One field of a line of CSV, quoted where it has to be. */
export function csv_field(value: string | number | null | undefined): string {
  const text = value === null || value === undefined ? '' : String(value);
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
