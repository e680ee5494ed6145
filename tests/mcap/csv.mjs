// SPDX-License-Identifier: Apache-2.0
// The CSV exports.

import assert from "node:assert/strict";

/** Rows of a CSV file (RFC 4180) as objects by column name. */
export function parseCsv(text) {
  const rows = [];
  let row = [];
  let field = "";
  let quoted = false;
  for (let i = 0; i < text.length; ++i) {
    const c = text[i];
    if (quoted) {
      if (c !== '"') field += c;
      else if (text[i + 1] === '"') field += text[++i];
      else quoted = false;
    } else if (c === '"') {
      quoted = true;
    } else if (c === "," || c === "\n") {
      row.push(field);
      field = "";
      if (c === "\n") {
        rows.push(row);
        row = [];
      }
    } else {
      field += c;
    }
  }
  const [columns, ...values] = rows;
  return values.map((fields) => Object.fromEntries(columns.map((name, i) => [name, fields[i]])));
}

/** A double as the CSV spells it. */
export function number(text) {
  if (text === "inf") return Infinity;
  if (text === "-inf") return -Infinity;
  if (text === "nan") return NaN;
  assert.notEqual(text, "", "a number is missing");
  return Number(text);
}
