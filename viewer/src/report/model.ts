// SPDX-License-Identifier: Apache-2.0
// The report document, as C++ writes it: each part is declared by its reader, and its type follows. viewer/README.md describes each
// key. What cannot be read is said where it would have stood: a block that is wrong becomes a message in its place, and the others
// are shown.
import {
  DataError, fail, fields, list, list_for, number, one_of, optional, or_null, pair, read_json, record, some, text, triple, whole,
  type Of, type Read,
} from '../common/read';

const label_or_none = optional(text, '');
const rule = record({ label: label_or_none, value: number });
export type Rule = Of<typeof rule>;

export type Cell = string | number | null;
const cell: Read<Cell> = (value, path) => {
  if (value === undefined || value === null) return null;
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  return (typeof value === 'number' ? number : text)(value, path);
};
const name: Read<string> = (value, path) => String(cell(value, path));
const names = list(name);

/** A page beside the report or below it, never a place elsewhere or a script. */
const playback: Read<string> = (value, path) => {
  const page = text(value, path);
  const beside = /^[\w.+=-]+(\/[\w.+=-]+)*\.html$/.test(page) && !page.split('/').includes('..');
  return beside ? page : fail(value, path, 'the path of a page below this one');
};
const seed: Read<string> = (value, path) => String((typeof value === 'number' ? whole(0) : text)(value, path));

/** One run: what it was called, and the command line that makes it alone. */
export interface Run {
  label: string;
  seed: string;
  /** Empty where it is not known. */
  command: string;
  /** A page beside this one that plays it. */
  playback: string | null;
}

/** One entry stands for all runs that differ in their seeds alone; the seed ends the command. */
const alike: Read<Run[]> = (value, path) => {
  const { label, command, seeds, playbacks } = record({
    label: label_or_none, command: label_or_none, seeds: list(seed), playbacks: optional(fields, {}),
  })(value, path);
  const pages = new Map(Object.entries(playbacks).map(([key, page]) => {
    if (seeds[Number(key)] === undefined) throw new DataError(`${path}.playbacks: no seed stands at ${key}`);
    return [Number(key), playback(page, `${path}.playbacks.${key}`)];
  }));
  return seeds.map((each, i) =>
    ({ label, seed: each, command: command === '' ? '' : command + each, playback: pages.get(i) ?? null }));
};

/** The runs behind a mark or a row, in order; `values` is empty or has as many for each of them, of what `values_label` says. */
export interface Made {
  runs: readonly Run[];
  values: readonly (number | null)[];
  values_label: string;
}

/** `runs` is a list of places in `all` and of [first, last] places, `values` has one or more numbers for each run. */
function made_of(found: Record<string, unknown>, path: string, all: readonly Run[], sign = ''): Made | null {
  const [runs, values] = [`${sign}runs`, `${sign}values`];
  const place: Read<number> = (value, at) =>
    all.length === 0 ? fail(value, at, 'nothing, for the document lists no runs') : whole(0, all.length - 1)(value, at);
  const places: Read<readonly Run[]> = (value, at) => {
    if (!Array.isArray(value)) return [all[place(value, at)]!];
    const [first, last] = list_for(2, 'ends', place)(value, at);
    if (last! < first!) throw new DataError(`${at}: ${last} comes before ${first}`);
    return all.slice(first, last! + 1);
  };
  const made = some(places)(found[runs], `${path}.${runs}`).flat();
  if (made.length === 0) return null;
  const numbers = some(or_null(number))(found[values], `${path}.${values}`);
  if (numbers.length % made.length !== 0) {
    throw new DataError(`${path}.${values}: ${numbers.length} entries for ${made.length} runs`);
  }
  return { runs: made, values: numbers, values_label: label_or_none(found[`${sign}values_label`], `${path}.${sign}values_label`) };
}

/** What `read` gives, with the runs behind it. */
const behind = <T>(runs: readonly Run[], read: Read<T>): Read<T & { made: Made | null }> => (value, path) =>
  ({ ...read(value, path), made: made_of(fields(value, path), path, runs) });

const column = (value: unknown, path: string) => {
  const found = record({
    key: text, label: or_null(text), unit: label_or_none,
    type: optional(one_of(['text', 'remark', 'number', 'p', 'verdict', 'deviation']), 'text' as const), digits: or_null(number),
  })(value, path);
  const digits = found.digits === null ? null : Math.max(0, Math.min(12, Math.round(found.digits)));
  return { ...found, label: found.label ?? found.key, digits };
};
export type Column = ReturnType<typeof column>;
export type Row = Record<string, Cell>;
export interface TableBlock {
  kind: 'table';
  title: string;
  note: string;
  columns: Column[];
  rows: Row[];
  filter: string[];
  /** Of the rows that lead to their runs. */
  made?: ReadonlyMap<Row, Made>;
}

const table = (runs: readonly Run[]): Read<TableBlock> => (value, path) => {
  const { columns, ...found } = record({ title: label_or_none, note: label_or_none, columns: list(column) })(value, path);
  const keys = columns.map(({ key }) => key);
  const made = new Map<Row, Made>();
  const cells = record(Object.fromEntries(keys.map((key) => [key, cell])));
  const row: Read<Row> = (entry, at) => {
    const read: Row = cells(entry, at);
    const from = made_of(fields(entry, at), at, runs, '$');
    if (from !== null) made.set(read, from);
    return read;
  };
  return { kind: 'table', ...found, columns, ...record({ rows: list(row), filter: some(one_of(keys)) })(value, path), made };
};

/** What charts over categories share, with `one` series as its categories make it. */
const categorical = <T>(one: (categories: number) => Read<T>) => (value: unknown, path: string) => {
  const { categories } = record({ categories: names })(value, path);
  return record({
    title: label_or_none, y_label: label_or_none, y_max: or_null(number), categories: names, category_label: label_or_none,
    series: list(one(categories.length)), lines: some(rule),
  })(value, path);
};
/** Null where there is nothing, or nothing at `key`. */
const unless_absent = <T>(key: string, read: Read<T>): Read<T | null> => or_null((value, path) =>
  (fields(value, path)[key] ?? null) === null ? null : read(value, path));

const box = (runs: readonly Run[]) => behind(runs, record({
  min: number, q1: number, median: number, q3: number, max: number, mean: or_null(number), outliers: some(number), count: or_null(number),
}));
export type Box = Of<ReturnType<typeof box>>;
const mark = record({ series: text, category: name, value: number, label: optional(text, 'published') });
const boxes = (runs: readonly Run[]) => (value: unknown, path: string) => ({
  kind: 'boxes' as const,
  ...categorical((count) =>
    record({ label: text, boxes: list_for(count, 'categories', unless_absent('median', box(runs))) }))(value, path),
  ...record({ marks: some(mark) })(value, path),
});
export type BoxesBlock = ReturnType<ReturnType<typeof boxes>>;

const interval = (runs: readonly Run[]) => behind(runs, (value, path) => {
  const { low, high, ...found } = record({
    value: number, low: or_null(number), high: or_null(number), published: or_null(number),
  })(value, path);
  return { ...found, low: low ?? found.value, high: high ?? found.value };
});
export type IntervalPoint = Of<ReturnType<typeof interval>>;
const intervals = (runs: readonly Run[]) => (value: unknown, path: string) => ({
  kind: 'intervals' as const,
  ...categorical((count) =>
    record({ label: text, points: list_for(count, 'categories', unless_absent('value', interval(runs))) }))(value, path),
});
export type IntervalsBlock = ReturnType<ReturnType<typeof intervals>>;

const heat_cell = (runs: readonly Run[]) => behind(runs, record({
  value: number, low: or_null(number), high: or_null(number), text: label_or_none, mark: label_or_none, note: label_or_none,
}));
export type HeatCell = Of<ReturnType<typeof heat_cell>>;
const heat = (runs: readonly Run[]) => (value: unknown, path: string) => {
  const { categories } = record({ categories: names })(value, path);
  return {
    kind: 'heat' as const,
    ...record({
      title: label_or_none, categories: names, category_label: label_or_none, value_label: label_or_none, text_label: label_or_none,
      /** The values that have the colours at both ends. */
      range: pair('ends'),
      /** With '%' the values are ratios that are shown in percent. */
      unit: optional(one_of(['', '%']), '' as const),
      /** Of each column the title of the figure that shows more of it. */
      see: optional(list_for(categories.length, 'categories', text), []),
      series: list(record({ label: text, cells: list_for(categories.length, 'categories', unless_absent('value', heat_cell(runs))) })),
    })(value, path),
  };
};
export type HeatBlock = ReturnType<ReturnType<typeof heat>>;

const curve = (value: unknown, path: string) => {
  const found = record({ label: text, x: list(or_null(number)) })(value, path);
  return { ...found, ...record({ y: list_for(found.x.length, 'values of x', or_null(number)) })(value, path) };
};
const lines = (runs: readonly Run[]) => behind(runs, (value, path) => ({
  kind: 'lines' as const,
  ...record({
    title: label_or_none, x_label: label_or_none, y_label: label_or_none, series: list(curve), lines: some(rule),
    /** Series of one point each that nobody is better than in x and y. */
    front: some(text),
  })(value, path),
}));
export type LinesBlock = Of<ReturnType<typeof lines>>;

export type Range = readonly [low: number, high: number];
const range: Read<Range> = (value, path) => {
  const [low, high] = pair('ends')(value, path);
  if (low >= high) throw new DataError(`${path}: the first end, ${low}, is not below the second, ${high}`);
  return [low, high];
};
const side = whole(1, 401);
const raster = () => (value: unknown, path: string) => {
  const found = record({
    title: label_or_none, x_label: label_or_none, y_label: label_or_none,
    width: side, height: side,
    /** Six hexadecimal digits per cell, row by row from the top, each row from the left. */
    rgb: text,
    /** The outer edges of the image. */
    x: range, y: range,
    marks: some(record({ label: text, x: number, y: number })),
  })(value, path);
  const digits = 6 * found.width * found.height;
  if (found.rgb.length !== digits) {
    throw new DataError(`${path}.rgb: ${found.rgb.length} digits for ${found.width} by ${found.height} cells, which take ${digits}`);
  }
  if (!/^[0-9a-f]*$/i.test(found.rgb)) fail(found.rgb, `${path}.rgb`, 'hexadecimal digits');
  return { kind: 'raster' as const, ...found };
};
export type RasterBlock = ReturnType<ReturnType<typeof raster>>;

export type Point = readonly [n: number, e: number, d: number];
const track = (value: unknown, path: string) => {
  const found = record({ label: text, n: list(number) })(value, path);
  const same = list_for(found.n.length, 'values of n', number);
  return { ...found, ...record({ e: same, d: optional(same, found.n.map(() => 0)), t: optional(same, []) })(value, path) };
};
/** Seen from above; `side` is not of the document, since what is not at one depth is shown from the south as well. */
const trajectories = (runs: readonly Run[]) => behind(runs, (value, path) => ({
  kind: 'trajectories' as const,
  side: 'above' as 'above' | 'south',
  ...record({
    title: label_or_none, vehicles: list(behind(runs, track)), goals: some(triple),
    spheres: some(record({ centre: triple, radius: number, label: label_or_none })),
  })(value, path),
}));
export type TrajectoriesBlock = Of<ReturnType<typeof trajectories>>;

export interface GridBlock {
  kind: 'grid';
  title: string;
  columns: number;
  blocks: Block[];
}
const grid = (runs: readonly Run[]): Read<GridBlock> => (value, path) => {
  const found = record({ title: label_or_none, columns: optional(number, 2), blocks: list(block(runs)) })(value, path);
  return { kind: 'grid', ...found, columns: Math.max(1, Math.min(6, Math.round(found.columns))) };
};

const note = () => (value: unknown, path: string) => ({
  kind: 'note' as const, ...record({ tone: optional(one_of(['info', 'warning']), 'info' as const), text })(value, path),
});

/** A block that could not be read: the reason takes its place. */
export interface ProblemBlock {
  kind: 'problem';
  text: string;
}
export type ChartBlock = BoxesBlock | HeatBlock | IntervalsBlock | LinesBlock | RasterBlock | TrajectoriesBlock;
export type Block = TableBlock | ChartBlock | GridBlock | ReturnType<ReturnType<typeof note>> | ProblemBlock;

const readers = { table, boxes, heat, intervals, lines, raster, trajectories, grid, note };
const kind = record({ kind: one_of(Object.keys(readers) as (keyof typeof readers)[]) });

function block(runs: readonly Run[]): Read<Block> {
  return (value, path) => {
    try {
      return readers[kind(value, path).kind](runs)(value, path);
    } catch (error) {
      if (!(error instanceof DataError)) throw error;
      return { kind: 'problem', text: `This part of the data cannot be shown. ${error.message}` };
    }
  };
}

const fact = record({ label: text, value: (value, path) => String(cell(value, path) ?? '–') });
const document = (runs: readonly Run[]) => record({
  title: text, subtitle: label_or_none, version: label_or_none, command: label_or_none, facts: some(fact),
  sections: list(record({ id: label_or_none, title: text, paragraphs: some(text), blocks: some(block(runs)) })),
});
export type Document = Of<ReturnType<typeof document>>;

/** Throws DataError with the first thing that keeps the document as a whole from being shown. */
export function decode(json: string): Document {
  return read_json(json, (value, path) => document(record({ runs: some(alike) })(value, path).runs.flat())(value, path));
}
