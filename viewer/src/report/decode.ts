// SPDX-License-Identifier: Apache-2.0
// The document from JSON text. What cannot be read is said where it would have stood: a block that is
// wrong becomes a message in its place, and the others are shown.
import { decode_made, decode_runs } from './decode_runs';
import type {
  Block, BoxesBlock, Cell, Column, Document, GridBlock, IntervalsBlock, LinesBlock, Made, NoteBlock, Point, Range, RasterBlock,
  Row, Rule, Run, Section, TableBlock, TrajectoriesBlock,
} from './model';
import { DataError, Reader } from '../common/reader';

const numbers_or_null = (entry: Reader): number | null => entry.number_or_null();

function rule(at: Reader): Rule {
  return { label: at.at('label').text(''), value: at.at('value').number() };
}

function cell(at: Reader): Cell {
  if (at.absent) return null;
  if (typeof at.value === 'boolean') return at.value ? 'yes' : 'no';
  return typeof at.value === 'number' ? at.number() : at.text();
}

function column(at: Reader): Column {
  const digits = at.at('digits').number_or_null();
  return {
    key: at.at('key').text(),
    label: at.at('label').text(at.at('key').text()),
    unit: at.at('unit').text(''),
    type: at.at('type').absent ? 'text' : at.at('type').one_of(['text', 'number', 'p', 'verdict', 'deviation']),
    digits: digits === null ? null : Math.max(0, Math.min(12, Math.round(digits))),
  };
}

/** The runs behind what is read at `at`. */
const made_at = (at: Reader, runs: readonly Run[]): Made | null => decode_made(at.at('runs'), at.at('values'), runs);

function table(at: Reader, runs: readonly Run[]): TableBlock {
  const columns = at.at('columns').list(column);
  const keys = columns.map((entry) => entry.key);
  const made = new Map<Row, Made>();
  const rows = at.at('rows').list((entry) => {
    const row: Row = Object.fromEntries(keys.map((key) => [key, cell(entry.at(key))]));
    const behind = decode_made(entry.at('$runs'), entry.at('$values'), runs);
    if (behind !== null) made.set(row, behind);
    return row;
  });
  return {
    kind: 'table',
    title: at.at('title').text(''),
    note: at.at('note').text(''),
    columns,
    rows,
    filter: at.at('filter').list((entry) => entry.one_of(keys), true),
    made,
  };
}

function boxes(at: Reader, runs: readonly Run[]): BoxesBlock {
  const categories = at.at('categories').list((entry) => String(cell(entry)));
  return {
    kind: 'boxes',
    title: at.at('title').text(''),
    y_label: at.at('y_label').text(''),
    y_max: at.at('y_max').number_or_null(),
    categories,
    category_label: at.at('category_label').text(''),
    series: at.at('series').list((entry) => ({
      label: entry.at('label').text(),
      boxes: entry.at('boxes').list_for(categories.length, 'categories', (box) =>
        box.absent || box.at('median').absent ? null : {
          min: box.at('min').number(),
          q1: box.at('q1').number(),
          median: box.at('median').number(),
          q3: box.at('q3').number(),
          max: box.at('max').number(),
          mean: box.at('mean').number_or_null(),
          outliers: box.at('outliers').list((value) => value.number(), true),
          count: box.at('count').number_or_null(),
          made: made_at(box, runs),
        }),
    })),
    lines: at.at('lines').list(rule, true),
    marks: at.at('marks').list((entry) => ({
      series: entry.at('series').text(),
      category: String(cell(entry.at('category'))),
      value: entry.at('value').number(),
      label: entry.at('label').text('published'),
    }), true),
  };
}

function intervals(at: Reader, runs: readonly Run[]): IntervalsBlock {
  const categories = at.at('categories').list((entry) => String(cell(entry)));
  return {
    kind: 'intervals',
    title: at.at('title').text(''),
    y_label: at.at('y_label').text(''),
    y_max: at.at('y_max').number_or_null(),
    categories,
    category_label: at.at('category_label').text(''),
    series: at.at('series').list((entry) => ({
      label: entry.at('label').text(),
      points: entry.at('points').list_for(categories.length, 'categories', (point) => {
        if (point.absent || point.at('value').absent) return null;
        const value = point.at('value').number();
        return {
          value,
          low: point.at('low').number_or_null() ?? value,
          high: point.at('high').number_or_null() ?? value,
          published: point.at('published').number_or_null(),
          made: made_at(point, runs),
        };
      }),
    })),
    lines: at.at('lines').list(rule, true),
  };
}

function lines(at: Reader, runs: readonly Run[]): LinesBlock {
  return {
    kind: 'lines',
    title: at.at('title').text(''),
    x_label: at.at('x_label').text(''),
    y_label: at.at('y_label').text(''),
    series: at.at('series').list((entry) => {
      const x = entry.at('x').list(numbers_or_null);
      return { label: entry.at('label').text(), x, y: entry.at('y').list_for(x.length, 'values of x', numbers_or_null) };
    }),
    lines: at.at('lines').list(rule, true),
    made: made_at(at, runs),
  };
}

function range(at: Reader): Range {
  const [low, high] = at.list_for(2, 'ends', (entry) => entry.number());
  if (low! >= high!) throw new DataError(`${at.path}: the first end, ${low}, is not below the second, ${high}`);
  return [low!, high!];
}

const most_cells_along_a_side = 401;

function raster(at: Reader): RasterBlock {
  const width = at.at('width').whole_number(1, most_cells_along_a_side);
  const height = at.at('height').whole_number(1, most_cells_along_a_side);
  const rgb = at.at('rgb').text();
  const digits = 6 * width * height;
  if (rgb.length !== digits) {
    throw new DataError(`${at.path}.rgb: ${rgb.length} digits for ${width} by ${height} cells, which take ${digits}`);
  }
  if (!/^[0-9a-f]*$/i.test(rgb)) at.at('rgb').fail('hexadecimal digits');
  return {
    kind: 'raster',
    title: at.at('title').text(''),
    x_label: at.at('x_label').text(''),
    y_label: at.at('y_label').text(''),
    x: range(at.at('x')),
    y: range(at.at('y')),
    width,
    height,
    rgb,
    marks: at.at('marks').list((entry) => ({
      label: entry.at('label').text(), x: entry.at('x').number(), y: entry.at('y').number(),
    }), true),
  };
}

function point(at: Reader): Point {
  const [n, e, d] = at.list_for(3, 'coordinates', (entry) => entry.number());
  return [n!, e!, d!];
}

function trajectories(at: Reader, runs: readonly Run[]): TrajectoriesBlock {
  return {
    kind: 'trajectories',
    title: at.at('title').text(''),
    vehicles: at.at('vehicles').list((entry) => {
      const n = entry.at('n').list((value) => value.number());
      const same = (key: string): number[] =>
        entry.at(key).list_for(n.length, 'values of n', (value) => value.number());
      const d = entry.at('d').absent ? n.map(() => 0) : same('d');
      const t = entry.at('t').absent ? [] : same('t');
      return { label: entry.at('label').text(), n, e: same('e'), d, t, made: made_at(entry, runs) };
    }),
    goals: at.at('goals').list(point, true),
    spheres: at.at('spheres').list((entry) => ({
      centre: point(entry.at('centre')),
      radius: entry.at('radius').number(),
      label: entry.at('label').text(''),
    }), true),
    made: made_at(at, runs),
  };
}

function grid(at: Reader, runs: readonly Run[]): GridBlock {
  const columns = at.at('columns').absent ? 2 : at.at('columns').number();
  return {
    kind: 'grid',
    title: at.at('title').text(''),
    columns: Math.max(1, Math.min(6, Math.round(columns))),
    blocks: at.at('blocks').list((entry) => block(entry, runs)),
  };
}

function note(at: Reader): NoteBlock {
  return {
    kind: 'note',
    tone: at.at('tone').absent ? 'info' : at.at('tone').one_of(['info', 'warning']),
    text: at.at('text').text(),
  };
}

const readers = { table, boxes, intervals, lines, raster, trajectories, grid, note };
const kinds = Object.keys(readers) as (keyof typeof readers)[];

function block(at: Reader, runs: readonly Run[]): Block {
  try {
    return readers[at.at('kind').one_of(kinds)](at, runs);
  } catch (error) {
    if (!(error instanceof DataError)) throw error;
    return { kind: 'problem', text: `This part of the data cannot be shown. ${error.message}` };
  }
}

function section(at: Reader, runs: readonly Run[]): Section {
  return {
    id: at.at('id').text(''),
    title: at.at('title').text(),
    paragraphs: at.at('paragraphs').list((entry) => entry.text(), true),
    blocks: at.at('blocks').list((entry) => block(entry, runs), true),
  };
}

/** Throws DataError with the first thing that keeps the document as a whole from being shown. */
export function decode(json: string): Document {
  const at = Reader.of_json(json);
  const runs = decode_runs(at.at('runs'));
  return {
    title: at.at('title').text(),
    subtitle: at.at('subtitle').text(''),
    version: at.at('version').text(''),
    command: at.at('command').text(''),
    facts: at.at('facts').list((fact) => ({
      label: fact.at('label').text(),
      value: String(cell(fact.at('value')) ?? '–'),
    }), true),
    sections: at.at('sections').list((entry) => section(entry, runs)),
  };
}
