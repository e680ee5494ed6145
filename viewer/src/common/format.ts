// SPDX-License-Identifier: Apache-2.0

const minus = '\u2212';
const thin_space = '\u2009';

/** A number with so many decimals, a true minus sign, and thin spaces between thousands from 10 000 on. */
export function fixed(value: number, digits: number): string {
  const text = Math.abs(value).toFixed(digits);
  const [whole = '', decimals] = text.split('.');
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, thin_space) : whole;
  const sign = value < 0 && Number(text) !== 0 ? minus : '';
  return sign + grouped + (decimals === undefined ? '' : '.' + decimals);
}

/** A number for reading: about four significant digits, no trailing zeros. */
export function short(value: number): string {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return value.toExponential(2).replace('-', minus);
  const digits = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : size >= 1 ? 3 : 4;
  const text = fixed(value, digits);
  return text.includes('.') ? text.replace(/\.?0+$/, '') : text;
}

/** +1.3 % from the ratio 0.013. */
export function signed_percent(ratio: number): string {
  const percent = ratio * 100;
  const digits = Math.abs(percent) >= 100 ? 0 : 1;
  const text = fixed(percent, digits);
  return (Number(percent.toFixed(digits)) > 0 ? '+' : '') + text + '\u00a0%';
}

/** The p value of a test, to four decimals; no p value is nothing. */
export function p_value(p: number): string {
  return p < 0.0001 ? '<0.0001' : fixed(p, 4);
}

/** Decimals with which every value of a column shows at least three significant digits, two at most. */
export function column_digits(values: number[]): number {
  if (values.every((value) => Number.isInteger(value))) return 0;
  const largest = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  return largest >= 100 ? 1 : largest >= 1 ? 2 : 3;
}

export function finite(value: number | null | undefined): value is number {
  return typeof value === 'number' && Number.isFinite(value);
}
