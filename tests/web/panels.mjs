// SPDX-License-Identifier: Apache-2.0
// What the panels of the playback compute, without a browser:
//
//   node --test tests/web/panels.mjs
//
// Needs `npm ci` in viewer/.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const viewer = fileURLToPath(new URL('../../viewer/', import.meta.url));
const { createServer } = await import(pathToFileURL(createRequire(`${viewer}package.json`).resolve('vite')));

let server;
let load;
before(async () => {
  server = await createServer({
    root: viewer, configFile: false, logLevel: 'error', appType: 'custom',
    server: { middlewareMode: true, ws: false, watch: null },
  });
  load = (path) => server.ssrLoadModule(`/src/playback/${path}`);
});
after(() => server.close());

/** A film of one column of times and whatever the curves read. */
const film_of = (times) => ({ count: times.length, generation: 0, time: (i) => times[i] });
const close = (a, b, within = 1e-12) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);

test('thinning keeps the least and the greatest value of every stretch', async () => {
  const { Store } = await load('charts/store.ts');
  const values = Array.from({ length: 10_000 }, (_, i) => Math.sin(i / 50));
  values[4321] = 99;
  values[7777] = -99;
  const store = new Store(film_of(values.map((_, i) => i / 10)), { series: [{}], read: (i, row) => { row[0] = values[i]; } });
  store.update();
  const { times, columns: [thin] } = store.thinned(0, 1000, 300);
  assert.equal(times.length, 600);
  assert.equal(Math.max(...thin), 99);
  assert.equal(Math.min(...thin), -99);
  for (let i = 1; i < times.length; ++i) assert.ok(times[i] > times[i - 1], 'times ascend');
  const stretch = thin.indexOf(99) & ~1;
  assert.ok(times[stretch] <= 432.1 && times[stretch + 1] >= 432.1, 'a peak stays in its stretch');
});

test('what is not known is a gap, and hides nothing that is known', async () => {
  const { Store } = await load('charts/store.ts');
  const values = Array.from({ length: 1000 }, (_, i) => (i < 455 ? Number.NaN : i));
  const store = new Store(film_of(values.map((_, i) => i)), { series: [{}], read: (i, row) => { row[0] = values[i]; } });
  store.update();
  const { columns: [thin] } = store.thinned(0, 1000, 100);
  assert.equal(thin.findIndex((value) => !Number.isNaN(value)), 90);
  assert.deepEqual([...thin.slice(90, 94)], [455, 459, 460, 469]);
});

test('what is zoomed into is not thinned, and reaches one frame beyond either side', async () => {
  const { Store } = await load('charts/store.ts');
  const times = Array.from({ length: 10_000 }, (_, i) => i / 10);
  const store = new Store(film_of(times), { series: [{}], read: (i, row) => { row[0] = i; } });
  store.update();
  const thinned = store.thinned(100, 110, 300);
  assert.deepEqual([...thinned.columns[0]], Array.from({ length: 102 }, (_, i) => 1000 + i));
});

test('a store reads each frame once, and all again when the film is replaced', async () => {
  const { Store } = await load('charts/store.ts');
  const film = film_of([0, 1, 2]);
  let reads = 0;
  const store = new Store(film, { series: [{}], read: (i, row) => { ++reads; row[0] = film.time(i); } });
  store.update();
  store.update();
  assert.equal(reads, 3);
  film.count = 4;
  film.time = (i) => i;
  store.update();
  assert.equal(reads, 4);
  film.time = (i) => 2 * i;
  store.update();
  assert.equal(reads, 8);
  assert.equal(store.value(0, 3), 6);
});

test('a film takes in more events and messages than a call can have arguments', async () => {
  const { Film } = await load('film.ts');
  const film = new Film([{ name: 'time_s', type: 'f64', per: 'frame', width: 1 }], 1);
  const many = Array.from({ length: 300_000 }, (_, i) => ({ time_s: i }));
  film.append({
    first: 0, count: 1, stride: 1, generation: 0, compression: 'none', data: Buffer.alloc(8).toString('base64'), events: many,
    thoughts: Buffer.from(JSON.stringify({ sketches: [], tracks: [], echoes: [], words: [], flights: many })).toString('base64'),
  });
  assert.equal(film.events.length, many.length);
  assert.equal(film.flights.at(-1).time_s, many.length - 1);
});

test('a vehicle has heard the last word of each of the others that has come in', async () => {
  const { Film } = await load('film.ts');
  const { words_heard } = await load('thoughts/perceived.ts');
  const film = new Film([{ name: 'time_s', type: 'f64', per: 'frame', width: 1 }], 3);
  const word = (time_s, vehicle) => ({ time_s, vehicle, word: { sent_s: time_s, text: `says ${time_s}`, awaited: [] } });
  const flight = (from, sent_s, unheard = false) => ({ from, to: 0, sent_s, begins_s: sent_s + 0.1, arrives_s: sent_s + 0.5, unheard });
  const thoughts = {
    sketches: [], tracks: [], echoes: [], words: [word(1, 1), word(2, 2), word(3, 1), word(4, 1)],
    // The second of vehicle 1 drowns; a message of vehicle 2 has no word.
    flights: [flight(1, 1), flight(2, 2), flight(1, 3, true), flight(1, 4), flight(2, 5), { ...flight(1, 1), to: 2 }],
  };
  film.append({
    first: 0, count: 1, stride: 1, generation: 0, compression: 'none', data: Buffer.alloc(8).toString('base64'), events: [],
    thoughts: Buffer.from(JSON.stringify(thoughts)).toString('base64'),
  });
  const texts = (time) => words_heard(film, 0, time).map(({ word: { text } }) => text);
  assert.deepEqual(texts(1.4), []);
  assert.deepEqual(texts(1.5), ['says 1']);
  assert.deepEqual(texts(4.2), ['says 1', 'says 2']);
  assert.deepEqual(texts(4.5), ['says 4', 'says 2']);
  assert.deepEqual(texts(5.5), ['says 4']);
});

test('the axis of a full turn is divided into quarters', async () => {
  const { multiples } = await load('../common/scale.ts');
  const { value_domain, value_step } = await load('charts/values.ts');
  const [low, high] = value_domain('heading', [5, 355]);
  assert.deepEqual(multiples(low, high, value_step('heading', [low, high])), [0, 90, 180, 270, 360]);
});

test('headings go on through north', async () => {
  const { unwrapped } = await load('charts/curves.ts');
  close(unwrapped(-10, Number.NaN), 350);
  close(unwrapped(5, 350), 365);
  close(unwrapped(-179, 181), 181);
  close(unwrapped(350, -3), -10);
});

test('zooming keeps the time pointed at in its place and stays inside the run', async () => {
  const { Span } = await load('charts/span.ts');
  let changes = 0;
  const span = new Span(() => { ++changes; });
  span.grow(0, 100);
  span.zoom(0.5, 30);
  assert.deepEqual(span.shown, [15, 65]);
  span.zoom(0.1, 15);
  assert.deepEqual(span.shown, [15, 20]);
  span.keep_in_view(18);
  assert.equal(changes, 2);
  span.keep_in_view(99.9);
  assert.equal(span.shown[1], 100);
  span.zoom(1000, 50);
  assert.deepEqual(span.shown, [0, 100]);
  assert.equal(span.is_zoomed, false);
});

test('a half-space cut by a plane forbids the same velocities as in three dimensions', async () => {
  const { cut_half_space, dot, horizontal_slice, vertical_slice } = await load('thoughts/slice.ts');
  const [point, normal] = [[0.3, -0.2, 0.1], [0.4, -0.5, 0.77]];
  const kinds = new Set();
  for (const slice of [horizontal_slice(0.25), vertical_slice(0.7, [0.5, -0.4, 0.25])]) {
    const cut = cut_half_space(slice, point, normal);
    for (let k = 0; k < 200; ++k) {
      const [x, y] = [Math.cos(k) * (k / 100), Math.sin(3 * k) * (k / 100)];
      const v = [0, 1, 2].map((i) => x * slice.right[i] + y * slice.up[i] + slice.fixed[i]);
      const allowed = dot(normal, v.map((component, i) => component - point[i])) >= 0;
      assert.equal(cut.normal[0] * x + cut.normal[1] * y >= cut.offset, allowed);
      kinds.add(allowed);
    }
  }
  assert.equal(kinds.size, 2);
});

test('the vertical plane goes through the velocity that it is to go through', async () => {
  const { projected, vertical_slice } = await load('thoughts/slice.ts');
  const through = [0.5, -0.4, 0.25];
  const slice = vertical_slice(0.7, through);
  const [x, y] = projected(slice, through);
  [0, 1, 2].forEach((i) => close(x * slice.right[i] + y * slice.up[i] + slice.fixed[i], through[i]));
});

test('the forbidden part of the square is what lies beyond the edge', async () => {
  const { forbidden_part } = await load('thoughts/slice.ts');
  const area = (points) => Math.abs(points.reduce((sum, [x, y], k) => {
    const [u, v] = points[(k + 1) % points.length];
    return sum + x * v - u * y;
  }, 0)) / 2;
  const half = forbidden_part({ normal: [1, 0], offset: 0.5 }, 1);
  close(area(half.outline), 3);
  assert.deepEqual(half.edge.map(([x]) => x), [0.5, 0.5]);
  close(area(forbidden_part({ normal: [1, 1], offset: -1 }, 1).outline), 0.5);
  assert.deepEqual(forbidden_part({ normal: [1, 0], offset: -2 }, 1), { outline: [], edge: [] });
  close(area(forbidden_part({ normal: [0, 0], offset: 1 }, 1).outline), 4);
});

test('a neighbour ahead to starboard that comes closer is told so', async () => {
  const { bearing_words, sight_of } = await load('thoughts/perceived.ts');
  const own = { position: [0, 0, 5], velocity: [0, 1, 0], yaw: Math.PI / 2 };
  const sight = sight_of({ position: [-3, 4, 5], velocity: [0, 0, 0] }, own);
  close(sight.range_m, 5);
  close(sight.closing_mps, 0.8);
  assert.equal(bearing_words(sight.bearing_rad), '37° stbd');
  assert.equal(bearing_words(-sight.bearing_rad), '37° port');
  assert.equal(bearing_words(0), 'ahead');
});

test('who a stroke is about is told by name', async () => {
  const { Meanings } = await load('thoughts/meanings.ts');
  const { who_is } = await load('thoughts/who.ts');
  const vehicles = [{ id: 7, name: 'anna' }, { id: 3, name: 'berta' }];
  const meanings = new Meanings(vehicles);
  assert.equal(meanings.words('allowed by vehicle 3'), 'allowed by berta');
  assert.equal(meanings.look('half_space', 'allowed by vehicle 3').colour, 'var(--c1)');
  assert.equal(meanings.words('allowed by contact 3'), 'allowed by contact 3');
  assert.equal(meanings.words('band of another class 2'), 'band of another class 2');
  assert.equal(who_is(0x4000_0002, vehicles).name, 'contact 2');
  assert.equal(who_is(0x8000_0001, vehicles).name, 'drifter 1');
});

test('what an obstacle allows is told apart from what vehicles allow', async () => {
  const { meaning_colour } = await load('meaning_colour.ts');
  const shown = ['chosen', 'preferred', 'own velocity', 'allowed by contact 1', 'allowed by an obstacle'].map(meaning_colour);
  assert.equal(new Set(shown).size, shown.length, shown.join());
});

test('names of quantities become words and units', async () => {
  const { heading_of } = await load('explanation/explanation.ts');
  assert.equal(heading_of('closing_speed_mps'), 'closing speed [m/s]');
  assert.equal(heading_of('neighbour'), 'neighbour');
  assert.equal(heading_of('range [m]'), 'range [m]');
});
