// SPDX-License-Identifier: Apache-2.0
// The report document, as C++ writes it and decode.ts reads it. viewer/README.md describes each key.

export interface Document {
  title: string;
  subtitle: string;
  version: string;
  command: string;
  facts: { label: string; value: string }[];
  sections: Section[];
}

/** One run: what it was called, and the command line that makes it alone. */
export interface Run {
  label: string;
  seed: string;
  /** Empty where it is not known. */
  command: string;
  /** A page beside this one that plays it. */
  playback: string | null;
}
/** The runs behind a mark or a row, in order; `values` is empty or has as many for each of them. */
export interface Made {
  runs: readonly Run[];
  values: readonly (number | null)[];
}

export interface Section {
  id: string;
  title: string;
  paragraphs: string[];
  blocks: Block[];
}

export type Block =
  | TableBlock | ChartBlock | GridBlock | NoteBlock | ProblemBlock;
export type ChartBlock = BoxesBlock | IntervalsBlock | LinesBlock | RasterBlock | TrajectoriesBlock;

export type ColumnType = 'text' | 'number' | 'p' | 'verdict' | 'deviation';
export type Cell = string | number | null;
export interface Column {
  key: string;
  label: string;
  unit: string;
  type: ColumnType;
  digits: number | null;
}
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

export interface Box {
  min: number;
  q1: number;
  median: number;
  q3: number;
  max: number;
  mean: number | null;
  outliers: number[];
  count: number | null;
  made: Made | null;
}
export interface Rule {
  label: string;
  value: number;
}
export interface Mark {
  series: string;
  category: string;
  value: number;
  label: string;
}
export interface BoxesBlock {
  kind: 'boxes';
  title: string;
  y_label: string;
  y_max: number | null;
  categories: string[];
  category_label: string;
  series: { label: string; boxes: (Box | null)[] }[];
  lines: Rule[];
  marks: Mark[];
}

export interface IntervalPoint {
  value: number;
  low: number;
  high: number;
  published: number | null;
  made: Made | null;
}
export interface IntervalsBlock {
  kind: 'intervals';
  title: string;
  y_label: string;
  y_max: number | null;
  categories: string[];
  category_label: string;
  series: { label: string; points: (IntervalPoint | null)[] }[];
  lines: Rule[];
}

export interface LinesBlock {
  kind: 'lines';
  title: string;
  x_label: string;
  y_label: string;
  series: { label: string; x: (number | null)[]; y: (number | null)[] }[];
  lines: Rule[];
  made: Made | null;
}

export type Range = readonly [low: number, high: number];
export interface RasterBlock {
  kind: 'raster';
  title: string;
  x_label: string;
  y_label: string;
  /** The outer edges of the image. */
  x: Range;
  y: Range;
  width: number;
  height: number;
  /** Six hexadecimal digits per cell, row by row from the top, each row from the left. */
  rgb: string;
  marks: { label: string; x: number; y: number }[];
}

export type Point = readonly [number, number, number];
export interface Vehicle {
  label: string;
  n: number[];
  e: number[];
  d: number[];
  t: number[];
  made: Made | null;
}
export interface TrajectoriesBlock {
  kind: 'trajectories';
  title: string;
  vehicles: Vehicle[];
  goals: Point[];
  spheres: { centre: Point; radius: number; label: string }[];
  made: Made | null;
}

export interface GridBlock {
  kind: 'grid';
  title: string;
  columns: number;
  blocks: Block[];
}

export interface NoteBlock {
  kind: 'note';
  tone: 'info' | 'warning';
  text: string;
}

/** A block that could not be read: the reason takes its place. */
export interface ProblemBlock {
  kind: 'problem';
  text: string;
}
