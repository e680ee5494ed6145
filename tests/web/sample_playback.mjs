// SPDX-License-Identifier: Apache-2.0
// A playback with one of everything, made of invented numbers.
import { Buffer } from 'node:buffer';

const period = 0.1;
const frames = 1200;
const shapes = ['auv', 'torpedo', 'rov', 'transport', 'catamaran', 'point'];
const round = (x, parts = 1e4) => Math.round(x * parts) / parts;

const vehicles = shapes.map((shape, id) => ({
  id, name: `${shape}_${id}`, model: shape, avoider: ['orca3d', 'rvo', 'avoa', 'rrt_star', 'teb', 'apf+stop_and_wait'][id], shape,
  length_m: [1.6, 1.6, 1.4, 4.5, 2, 1][id], beam_m: [0.5, 0.19, 0.9, 4.5, 1.1, 1][id], radius_m: 1.5, cooperative: id !== 5,
  parts: shape === 'transport' ? [[2, 2], [2, -2], [-2, -2], [-2, 2]].map(([x_m, y_m]) => ({ x_m, y_m, z_m: 0, yaw_rad: 0 })) : [],
}));

const columns = [
  { name: 'time_s', type: 'f64', per: 'frame', width: 1 },
  { name: 'current_mps', type: 'f32', per: 'frame', width: 4 },
  { name: 'position_m', type: 'f64', per: 'vehicle', width: 3 },
  { name: 'attitude', type: 'f32', per: 'vehicle', width: 4 },
  { name: 'velocity_mps', type: 'f32', per: 'vehicle', width: 3 },
  { name: 'command_mps', type: 'f32', per: 'vehicle', width: 3 },
  { name: 'goal_m', type: 'f32', per: 'vehicle', width: 3 },
  { name: 'force_n', type: 'f32', per: 'vehicle', width: 3 },
  { name: 'power_w', type: 'f32', per: 'vehicle', width: 1 },
  { name: 'mode', type: 'u8', per: 'vehicle', width: 1 },
  { name: 'phase', type: 'u8', per: 'vehicle', width: 1 },
  { name: 'alert', type: 'u8', per: 'vehicle', width: 1 },
  { name: 'shortfall', type: 'u8', per: 'vehicle', width: 1 },
  { name: 'progress', type: 'u8', per: 'vehicle', width: 1 },
  { name: 'no_progress_s', type: 'f32', per: 'vehicle', width: 1 },
  { name: 'progress_with', type: 'f32', per: 'vehicle', width: 1 },
];

// Everyone crosses a circle to the opposite side; those who float stay at the surface.
const radius = 25;
const depth_of = (id) => (vehicles[id].shape === 'catamaran' ? 0 : 5 + id);
function place(id, t) {
  const angle = (2 * Math.PI * id) / vehicles.length;
  const along = radius - 0.45 * t;
  const side = 2.5 * Math.sin(t / 12 + id);
  return [along * Math.cos(angle) - side * Math.sin(angle), along * Math.sin(angle) + side * Math.cos(angle),
    depth_of(id) + (depth_of(id) === 0 ? 0 : 0.6 * Math.sin(t / 9 + id))];
}
const goal = (id) => place(id, 2 * radius / 0.45).map((x, k) => (k === 2 ? depth_of(id) : x));
const velocity = (id, t) => place(id, t + 0.05).map((x, k) => (x - place(id, t - 0.05)[k]) / 0.1);
const distance = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

const values = Object.fromEntries(columns.map(({ name }) => [name, []]));
const events = [];
const before = vehicles.map(() => 0);
for (let i = 0; i < frames; ++i) {
  const t = i * period;
  values.time_s.push(t);
  values.current_mps.push(0.2, 0.05 * Math.sin(t / 30), 0.1, 0);
  for (const { id } of vehicles) {
    const p = place(id, t);
    const v = velocity(id, t);
    const yaw = Math.atan2(v[1], v[0]);
    const nearest = Math.min(...vehicles.filter((other) => other.id !== id).map((other) => distance(p, place(other.id, t))));
    const alert = nearest <= 3 ? 2 : nearest <= 8 ? 1 : 0;
    if (alert !== before[id]) events.push({ time_s: round(t), vehicle: id, other: (id + 1) % vehicles.length, kind: alert === 2 ? 'collision' : alert === 1 ? 'detected' : 'avoided' });
    before[id] = alert;
    values.position_m.push(...p);
    values.attitude.push(Math.cos(yaw / 2), 0, 0, Math.sin(yaw / 2));
    values.velocity_mps.push(...v);
    values.command_mps.push(...v.map((x) => 1.1 * x));
    values.goal_m.push(...goal(id));
    values.force_n.push(10 + 5 * Math.sin(t), 2 * Math.cos(t), 0);
    values.power_w.push(30 + 10 * Math.sin(t / 3 + id));
    values.mode.push(id === 0 && t > 40 && t < 80 ? 2 : alert > 0 ? 1 : 0);
    values.phase.push(2);
    values.alert.push(alert);
    values.shortfall.push(shapes[id] === 'torpedo' && alert > 0 ? 2 : 0);
    // the fleet is stuck for a while near the middle, each vehicle in another way
    const stuck = t > 40 && t < 80;
    values.progress.push(stuck ? id % 5 : 0);
    values.no_progress_s.push(stuck ? t - 10 : 0);
    values.progress_with.push(stuck && [2, 3].includes(id % 5) ? (id + 1) % vehicles.length : -1);
  }
}
const arrays = { f64: Float64Array, f32: Float32Array, u8: Uint8Array };
const bytes = Buffer.concat(columns.map(({ name, type }) => Buffer.from(arrays[type].from(values[name]).buffer)));

// What each would draw: velocities near its own, planes, a cone, a tree, a picture.
function strokes(id, t) {
  const [n, e, d] = place(id, t);
  const [vn, ve] = velocity(id, t);
  const marks = [
    { kind: 'velocity', meaning: 'preferred', points: [[vn, ve, 0]] },
    { kind: 'velocity', meaning: 'chosen', points: [[0.9 * vn + 0.1, 0.9 * ve - 0.1, 0]] },
  ];
  if (id === 0) marks.push({ kind: 'half_space', meaning: 'allowed by vehicle 1', points: [[0.2, 0.1, 0], [-0.8, 0.6, 0]] },
    { kind: 'half_space', meaning: 'allowed by vehicle 2', points: [[-0.1, 0.3, 0], [0, -1, 0]] });
  if (id === 1) marks.push({ kind: 'region', meaning: 'velocity obstacle', points: [[0.8, 0.5, 0], [0.2, 0.1, 0], [0.3, -0.1, 0], [0.9, -0.2, 0]] });
  if (id === 2) {
    const side = 31;
    const rgb = Buffer.alloc(3 * side * side);
    for (let k = 0; k < side * side; ++k) rgb.set([255 * ((k % side) / side), 255 * (k / side / side), 160], 3 * k);
    marks.push({ kind: 'image', meaning: 'protective zones', side, reach: 1, yaw: Math.atan2(ve, vn), rgb: rgb.toString('base64') });
    for (let k = 0; k < 12; ++k) marks.push({ kind: 'velocity', meaning: 'particle', points: [[vn + 0.1 * Math.cos(k), ve + 0.1 * Math.sin(k), 0]] });
  }
  if (id === 3) {
    const branches = [];
    for (let k = 0; k < 60; ++k) branches.push([n + 0.2 * k, e + Math.sin(k), d], [n + 0.2 * k + 1, e + Math.sin(k + 1), d]);
    marks.push({ kind: 'tree', meaning: 'search tree', points: branches },
      { kind: 'path', meaning: 'trajectory', points: [[n, e, d], goal(id)] });
  }
  if (id === 4) for (const side of [-2, 2]) {
    marks.push({ kind: 'path', meaning: side < 0 ? 'band' : 'band of another class',
      points: Array.from({ length: 12 }, (_, k) => [n + k * vn * 2, e + k * ve * 2 + side * Math.sin((k / 11) * Math.PI), d]) });
  }
  if (id === 5) marks.push({ kind: 'sphere', meaning: 'stop-and-wait range', points: [[n, e, d]], radius: 6 });
  return marks;
}
const thoughts = { sketches: [], tracks: [], echoes: [], words: [], flights: [] };
const rounded = (_, value) => (typeof value === 'number' ? round(value, 1e5) : value);
for (let i = 0; i < frames; i += 5) {
  const t = round(i * period);
  for (const { id } of vehicles) {
    thoughts.sketches.push({ time_s: t, vehicle: id, strokes: strokes(id, t) });
    thoughts.tracks.push({ time_s: t, vehicle: id, tracks: vehicles.filter((other) => other.id !== id).map((other) => ({
      id: other.id, position: place(other.id, t - 1), velocity: velocity(other.id, t - 1), radius: 1.5, age_s: 1, sigma_m: 0.8, reacts: true })) });
  }
  thoughts.echoes.push({ time_s: t, vehicle: 0, echoes: Array.from({ length: 9 }, (_, k) => [12 + Math.sin(k + t), (k - 4) / 10]) });
  if (i % 50 === 0) thoughts.words.push({ time_s: t, vehicle: 0, word: { sent_s: t, text: `has counted to ${i}`, awaited: [1, 3] } });
  if (i % 50 === 0) thoughts.flights.push(...[1, 2, 3, 4, 5].map((to) => ({ from: 0, to, sent_s: t, begins_s: t + 0.3, arrives_s: t + 0.8, unheard: to === 3 })));
}

const sphere = (position, r, velocity = [0, 0, 0], charted = true) => ({ kind: 'sphere', charted, position, radius: r, velocity, from: [0, 0, 0], to: [0, 0, 0], vertices: [] });
export const playback = {
  title: 'sample', summary: 'six vehicles cross a circle; invented numbers', version: '0.0.0', command: 'node sample/playback.mjs', seed: '1',
  period_s: period, duration_s: frames * period,
  scene: {
    vehicles,
    obstacles: [sphere([12, -8, 6], 2), sphere([-10, 12, 4], 1.5, [0.1, 0, 0], false),
      { ...sphere([0, 0, 0], 0), kind: 'segment', from: [-15, -20, 0], to: [-5, -28, 0] },
      { ...sphere([0, 0, 0], 0), kind: 'polygon', vertices: [[20, 20, 0], [26, 20, 0], [26, 26, 0], [20, 26, 0]] }],
    exam: { crit_dist_m: 8, safety_distance_m: 3 },
    waves: [{ amplitude_m: 0.25, frequency_radps: 1.2, number_radpm: 0.147, phase_rad: 0.3, direction: [1, 0] },
      { amplitude_m: 0.12, frequency_radps: 1.9, number_radpm: 0.368, phase_rad: 1.1, direction: [0.8, 0.6] }],
    current_depths_m: [0, 15],
    sonar: { min_range_m: 1, max_range_m: 30, half_field_rad: 1.13, half_aperture_rad: 0.17 },
  },
  columns,
  film: { first: 0, count: frames, stride: 1, generation: 0, data: bytes.toString('base64'), compression: 'none', events,
    thoughts: Buffer.from(JSON.stringify(thoughts, rounded)).toString('base64') },
  notice: '', divergence: '',
  explanation: { vehicle: 0, time_s: 40, headline: 'auv_0 turns to starboard: the neighbour torpedo_1 leaves it no other velocity.',
    sections: [{ title: 'Situation', lines: ['Two neighbours within 8 m.'], table: { columns: ['neighbour', 'range_m'], rows: [['torpedo_1', 5.3]] } }] },
};
