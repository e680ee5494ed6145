// SPDX-License-Identifier: Apache-2.0
// Writes sample/report.json: every kind of block with invented but plausible numbers, the same on every run.
import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { avoidance_runs, gap_curves } from './motion.mjs';
import { velocity_image } from './velocities.mjs';

let state = 20231;
const uniform = () => {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return state / 2 ** 32;
};
const normal = () => uniform() + uniform() + uniform() + uniform() - 2;
const round = (value, digits = 2) => Number(value.toFixed(digits));

function quantile(sorted, part) {
  const at = part * (sorted.length - 1);
  const below = Math.floor(at);
  return sorted[below] + (at - below) * ((sorted[below + 1] ?? sorted[below]) - sorted[below]);
}

// A box as the report gets it: whiskers at the furthest values within 1.5 interquartile ranges.
function box(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const [q1, median, q3] = [0.25, 0.5, 0.75].map((part) => quantile(sorted, part));
  const inside = sorted.filter((v) => v >= q1 - 1.5 * (q3 - q1) && v <= q3 + 1.5 * (q3 - q1));
  return {
    min: round(inside[0]), q1: round(q1), median: round(median), q3: round(q3), max: round(inside.at(-1)),
    mean: round(sorted.reduce((a, b) => a + b) / sorted.length),
    outliers: sorted.filter((v) => v < inside[0] || v > inside.at(-1)).map((v) => round(v)), count: sorted.length,
  };
}
const sample = (count, centre, spread, tail = 0.04) => Array.from({ length: count }, () =>
  Math.max(0, centre + spread * normal() + (uniform() < tail ? spread * (2 + 4 * uniform()) : 0)));

// The runs that marks and rows lead to: one entry for those that differ in their seeds alone.
const runs = [];
let run_count = 0;
function planned(label, count, playbacks) {
  const name = label.toLowerCase().replaceAll(' + ', '+').replaceAll(' ', '/');
  runs.push({
    label, command: `fairway study cubes --only ${name}/`, seeds: Array.from({ length: count }, (_, i) => i + 1),
    ...(playbacks === undefined ? {} : { playbacks }),
  });
  run_count += count;
  return [run_count - count, run_count - 1];
}

const methods = ['APF', 'ORCA', 'APF + SAW', 'ORCA + SAW'];
const limit = { label: 'time limit', value: 592 };

const tuned_runs = new Map();
/** 45 runs for each value of a parameter, the same in every panel. */
function tuned(name, value) {
  const label = `tuning apf ${name.toLowerCase()}=${value}`;
  if (!tuned_runs.has(label)) tuned_runs.set(label, planned(label, 45));
  return tuned_runs.get(label);
}

function tuning_panels() {
  const parameters = [
    { name: 'CRIT_DIST', unit: ' [m]', values: ['6', '7', '10', '20'], factor: [1, 1.12, 1.7, 2.9] },
    { name: 'ORI_ERROR', unit: ' [rad]', values: ['0.4', '0.6', '0.8'], factor: [1.5, 1.25, 1.1] },
    { name: 'W2', unit: '', values: ['0.5', '2.5', '500'], factor: [1.15, 1.3, 1.65] },
  ];
  const quantities = [
    { title: 'Navigation time', y: 'time [s]', base: 118, spread: 38, y_max: 620, lines: [limit] },
    { title: 'Avoidance time', y: 'time [s]', base: 62, spread: 36, y_max: 620, lines: [limit] },
    { title: 'Avoided collisions', y: 'count per vehicle', base: 24, spread: 15, y_max: 260, lines: [] },
    { title: 'Distance', y: 'distance [m]', base: 43, spread: 14, y_max: 260, lines: [] },
  ];
  return parameters.flatMap(({ name, unit, values, factor }) => quantities.map(({ title, y, base, spread, y_max, lines }) => ({
    kind: 'boxes', title: `${title} by ${name}`, y_label: y, y_max, categories: values, category_label: name + unit, lines,
    series: [{
      label: 'APF', boxes: values.map((value, i) => {
        const shown = sample(45, base * factor[i], spread * factor[i]);
        return { ...box(shown), runs: [tuned(name, value)], values: shown.map((each) => round(each)) };
      }),
    }],
    marks: name === 'CRIT_DIST' && title === 'Navigation time'
      ? [{ series: 'APF', category: '6', value: 121.4, label: 'published' }, { series: 'APF', category: '20', value: 401.2, label: 'published' }] : [],
  })));
}

function robot_boxes(title, y_label, centre, lines = []) {
  const robots = Array.from({ length: 8 }, (_, i) => `robot${i}`);
  return {
    kind: 'boxes', title, y_label, categories: robots, category_label: '', lines, marks: [],
    series: methods.map((label, m) => ({
      label, boxes: robots.map((_, r) => box(sample(20, centre(m, r), centre(m, r) * (m === 0 ? 0.16 : 0.08)))),
    })),
  };
}

const cases = ['cube20_4', 'cube20_8', 'cube20_8_retuned', 'cube60_4', 'cube60_8', 'cube60_8_retuned'];
const published = [
  [101.8, 97.2, 128.4, 171.9], [139.7, 116.5, 224.6, 331.8], [158.2, 119.0, 236.1, 241.5],
  [238.9, 231.7, 251.3, 306.4], [262.1, 239.4, 338.0, 472.7], [271.6, 240.8, 341.5, 455.9],
];
const shift = [
  [0.013, -0.008, 0.041, -0.032], [0.022, 0.013, -0.118, 0.274], [-0.057, 0.006, 0.036, 0.091],
  [0.004, -0.011, 0.018, null], [0.083, 0.017, 0.064, -0.196], [-0.041, 0.002, 0.052, 0.381],
];

function comparison_rows() {
  return cases.flatMap((name, c) => methods.map((method, m) => {
    const deviation = shift[c][m];
    const reference = deviation === null ? null : published[c][m];
    const measured = published[c][m] * (1 + (deviation ?? 0.02));
    const half = measured * (0.012 + 0.03 * uniform() + (m > 1 ? 0.02 : 0));
    const size = Math.abs(deviation ?? 0);
    const verdict = deviation === null ? 'no_reference'
      : size < 0.025 ? 'reproduced' : size < 0.07 ? 'within_spread' : size < 0.2 ? 'partly' : 'not_reproduced';
    const behind = planned(`${name} ${method}`, 20, name === 'cube20_8' && method === 'ORCA' ? { 6: 'runs/cube20_8-orca-7.html' } : undefined);
    return {
      $runs: [behind], $values: sample(20, measured, 6 * half).map((each) => round(each, 1)),
      case: name, method, published: reference, measured: round(measured, 1), low: round(measured - half, 1),
      high: round(measured + half, 1), runs: 20, deviation, verdict,
      note: verdict === 'not_reproduced' ? 'the order in which vehicles wait is not published' : '',
    };
  }));
}

const rows = comparison_rows();
const eight = rows.find((row) => row.case === 'cube20_8' && row.method === 'ORCA');
const seventh = eight.$runs[0][0] + 6;
const report = {
  title: 'Four avoidance methods in a cube, as published and as measured',
  subtitle: 'Sample data: the numbers on this page are invented. They show what a report of a study looks like: ' +
    'parameters of two methods swept, then four combinations compared with 4 and 8 vehicles.',
  version: 'fairway 0.1.0',
  command: 'fairway study cubes --seeds 20',
  facts: [
    { label: 'Runs', value: '840' }, { label: 'Vehicles', value: '4 and 8' }, { label: 'Cases × methods', value: '24' },
    { label: 'Reproduced or within spread', value: '17 of 23' }, { label: 'Collisions', value: '22' }, { label: 'Simulated time', value: '61.4 h' },
  ],
  sections: [
    {
      id: 'comparison', title: 'Published against measured',
      paragraphs: [
        'Vehicles start on the corners of a cube and swap places through its centre. Each row below is one case and method: the ' +
        'published mean navigation time, the mean over our runs with its 95 % interval, and what follows from the two.',
        'A value counts as reproduced when the published number lies inside the interval, and as within spread when it lies inside ' +
        'the range of the single runs. Figure 1 shows the same numbers.',
      ],
      blocks: [
        { kind: 'note', tone: 'info', text: 'Intervals are bootstrapped over seeds; runs of different methods with the same seed start from the same positions, so differences between methods are paired.' },
        {
          kind: 'table', title: 'Navigation time, published and measured', filter: ['case', 'method'],
          note: 'Mean over all vehicles of a run, then over runs. Deviation is measured over published, less one.',
          columns: [
            { key: 'case', label: 'Case', type: 'text' }, { key: 'method', label: 'Method', type: 'text' },
            { key: 'published', label: 'Published', unit: 's', type: 'number', digits: 1 },
            { key: 'measured', label: 'Measured', unit: 's', type: 'number', digits: 1 },
            { key: 'low', label: 'Low', unit: 's', type: 'number', digits: 1 }, { key: 'high', label: 'High', unit: 's', type: 'number', digits: 1 },
            { key: 'deviation', label: 'Deviation', type: 'deviation' }, { key: 'verdict', label: 'Verdict', type: 'verdict' },
            { key: 'runs', label: 'Runs', type: 'number', digits: 0 }, { key: 'note', label: 'Note', type: 'text' },
          ],
          rows,
        },
        {
          kind: 'intervals', title: 'Mean navigation time with 95 % intervals', y_label: 'navigation time [s]', categories: cases,
          series: methods.map((label) => ({
            label,
            points: cases.map((name) => {
              const row = rows.find((entry) => entry.case === name && entry.method === label);
              return name === 'cube60_4' && label === 'ORCA + SAW' ? null
                : { value: row.measured, low: row.low, high: row.high, published: row.published, runs: row.$runs, values: row.$values };
            }),
          })),
        },
      ],
    },
    {
      id: 'tuning', title: 'Parameter setting of APF',
      paragraphs: ['Every combination of three parameters, five runs each, with four vehicles in the small cube. Rows are the ' +
        'parameters, columns the quantities; the dashed line is the time after which a vehicle counts as stuck.'],
      blocks: [{ kind: 'grid', title: 'APF in the parameter setting phase, 180 runs', columns: 4, blocks: tuning_panels() }],
    },
    {
      id: 'robots', title: 'Every vehicle by itself',
      paragraphs: ['With eight vehicles and the stop-and-wait rule, the vehicles of low priority pay for the others.'],
      blocks: [
        robot_boxes('Navigation time by vehicle and method, small cube', 'navigation time [s]',
          (m, r) => [150, 118, 165 + 18 * r, 190 + 38 * r][m], [limit]),
        {
          kind: 'grid', columns: 2, title: 'Effort by vehicle and method', blocks: [
            robot_boxes('Avoided collisions', 'count', (m, r) => [46, 11, 30 + r, 21 + 2 * r][m]),
            robot_boxes('Distance travelled', 'distance [m]', (m, r) => [58, 39, 47 + 0.6 * r, 41 + 0.4 * r][m]),
          ],
        },
      ],
    },
    {
      id: 'velocities', title: 'What a vehicle may do',
      paragraphs: ['The velocities of one vehicle at one moment: red ones end in contact with another vehicle, the others are the ' +
        'darker the further they are from the desired one.'],
      blocks: [
        velocity_image('Velocities of robot2 at 52 s', 81, [[0.75, 0.4], [-2.2, 0.5], [2.7, 0.22]]),
        {
          kind: 'grid', columns: 3, title: 'Velocities of robot2 while the others come nearer',
          blocks: [48, 52, 56].map((time, i) => velocity_image(`At ${time} s`, 41, [[0.95, 0.25 + 0.2 * i], [-2.2, 0.3 + 0.2 * i]])),
        },
      ],
    },
    {
      id: 'runs', title: 'Single runs',
      paragraphs: ['The run with the smallest gap of each kind. Drag the view to turn it, or use the arrow keys; the slider moves through time.'],
      blocks: [
        { kind: 'trajectories', title: 'Eight vehicles with ORCA through the small cube, seed 7', runs: [seventh], ...avoidance_runs() },
        { kind: 'lines', title: 'Smallest gap between any two vehicles', x_label: 'time [s]', y_label: 'gap [m]', series: gap_curves(methods), lines: [{ label: 'collision', value: 2 }] },
        { kind: 'note', tone: 'warning', text: 'Two runs of APF ended in contact: vehicles 2 and 5 met head-on while both turned on the spot.' },
        {
          kind: 'table', title: 'Contacts', columns: [
            { key: 'seed', label: 'Seed', type: 'number', digits: 0 }, { key: 'method', label: 'Method', type: 'text' },
            { key: 'pair', label: 'Vehicles', type: 'text' }, { key: 'time', label: 'Time', unit: 's', type: 'number', digits: 1 },
            { key: 'gap', label: 'Gap', unit: 'm', type: 'number', digits: 3 },
          ],
          rows: [
            { seed: 3, method: 'APF', pair: '2, 5', time: 61.4, gap: 1.914 }, { seed: 11, method: 'APF', pair: '0, 6', time: 58.2, gap: 1.87 },
            { seed: 11, method: 'ORCA', pair: '1, 7', time: 64.9, gap: 1.992 }, { seed: 17, method: 'ORCA', pair: '3, 4', time: null, gap: null },
          ],
        },
      ],
    },
    {
      id: 'settings', title: 'Settings with long names',
      paragraphs: ['Labels that would be cut to the same text keep what tells them apart.'],
      blocks: [
        {
          kind: 'boxes', title: 'Effort by setting', y_label: 'effort', category_label: '', lines: [], marks: [],
          categories: ['cube20_8, step_s 0.05, crit_dist_m 6', 'cube20_8, step_s 0.05, crit_dist_m 10', 'cube20_8, step_s 0.1, crit_dist_m 6', 'cube20_8, step_s 0.1, crit_dist_m 10'],
          series: methods.map((label, i) => ({ label, boxes: [60, 64, 70, 75].map((centre) => box(sample(20, centre + 4 * i, 5))) })),
        },
        {
          kind: 'table', title: 'Differences from APF, paired by seed', filter: ['method'],
          columns: [
            { key: 'method', label: 'Method', type: 'text' }, { key: 'mean', label: 'Mean', type: 'number', digits: 1 },
            { key: 'p', label: 'p, Holm', type: 'p' }, { key: 'effect', label: 'Effect', type: 'number', digits: 2 },
          ],
          rows: [
            { method: 'ORCA', mean: -12.4, p: 0.0000031, effect: -0.94 }, { method: 'APF + SAW', mean: 1.2, p: 0.41, effect: 0.12 },
            { method: 'ORCA + SAW', mean: -3.5, p: null, effect: null },
          ],
        },
      ],
    },
  ],
};

report.runs = runs;
const target = fileURLToPath(new URL('./report.json', import.meta.url));
writeFileSync(target, JSON.stringify(report) + '\n');
