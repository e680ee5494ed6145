// SPDX-License-Identifier: Apache-2.0
// A table as LaTeX, for a paper: booktabs, numbers as the page shows them.
import { column_digits, fixed, p_value, signed_percent } from '../common/format';
import { verdicts } from './cells';
import { heading } from './csv';
import type { Cell, Column, Row, TableBlock } from './model';

const escapes: Record<string, string> = {
  '\\': '\\textbackslash{}', '{': '\\{', '}': '\\}', '$': '\\$', '&': '\\&', '#': '\\#', '%': '\\%', '_': '\\_',
  '~': '\\textasciitilde{}', '^': '\\textasciicircum{}', '<': '$<$', '>': '$>$', '|': '$|$', '"': "''",
  '\u2212': '$-$', '\u00a0': '~', '\u2009': '\\,', '–': '--', '—': '---', '…': '\\ldots{}', '‘': '`', '’': "'",
  '“': '``', '”': "''", '°': '$^\\circ$', '²': '$^2$', '³': '$^3$', 'µ': '$\\mu$', '·': '$\\cdot$', '×': '$\\times$',
  '±': '$\\pm$', '≈': '$\\approx$', '≤': '$\\le$', '≥': '$\\ge$', '→': '$\\to$',
};

/** Text in which nothing means anything to LaTeX but what it says; the rest stays as it is, in UTF-8. */
function escaped(text: string): string {
  return [...text.replaceAll(/\s*\n\s*/g, ' ')].map((character) => escapes[character] ?? character).join('');
}

/** A text column in which some text is longer than a line can spare wraps. */
function alignment(column: Column, rows: readonly Row[]): string {
  if (column.type === 'number' || column.type === 'p' || column.type === 'deviation') return 'r';
  const long = (column.type === 'text' || column.type === 'remark') && rows.some((row) => String(row[column.key] ?? '').length > 30);
  return long ? 'p{14em}' : 'l';
}

/** The text of a cell as the page shows it; `digits` is that of all of its column. */
function shown(column: Column, value: Cell, digits: number): string {
  if (value === null || value === '') return '--';
  if (column.type === 'verdict') return escaped(verdicts[value]?.words ?? String(value));
  if (typeof value === 'string') return escaped(value);
  if (column.type === 'p') return escaped(p_value(value));
  return escaped(column.type === 'deviation' ? signed_percent(value) : fixed(value, digits));
}

/** `rows` are those to be written, in their order; `name` becomes part of the label. */
export function to_latex(block: TableBlock, rows: readonly Row[], name: string): string {
  const digits = block.columns.map((column) => column.digits ??
    column_digits(block.rows.map((row) => row[column.key]).filter((value) => typeof value === 'number')));
  const line = (cells: string[]): string => `    ${cells.join(' & ')} \\\\`;
  return [
    '% \\usepackage{booktabs}',
    '\\begin{table}',
    '  \\centering',
    `  \\caption{${escaped(block.title)}}`,
    `  \\label{tab:${name}}`,
    `  \\begin{tabular}{${block.columns.map((column) => alignment(column, rows)).join('')}}`,
    '    \\toprule',
    line(block.columns.map((column) => escaped(heading(column)))),
    '    \\midrule',
    ...rows.map((row) => line(block.columns.map((column, i) => shown(column, row[column.key] ?? null, digits[i]!)))),
    '    \\bottomrule',
    '  \\end{tabular}',
    '\\end{table}',
    '',
  ].join('\n');
}
