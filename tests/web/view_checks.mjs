// SPDX-License-Identifier: Apache-2.0
// What must hold on every page of `fairway view`. Each check gets a ViewPage, `expect(condition, what)` and how it was opened.
import { readFileSync } from 'node:fs';
import { distance, hue } from './picture.mjs';
import { plain, printed } from './view_page.mjs';

/** As colours of the palette return after the eighth. */
const palette = 8;

async function vehicles_are_where_they_should_be(view, expect) {
  const film = await view.film();
  await view.camera('top');
  await view.layers();
  await view.page.keyboard.press('f');
  await view.seek_frame(0);
  const before = await view.settled();
  const old_places = (await view.state()).vehicles.map(({ place }) => place);
  await view.seek_frame(Math.floor(film.count / 3));
  const after = await view.settled();
  const { vehicles } = await view.state();
  const colours = await view.page.evaluate((count) => {
    const style = getComputedStyle(document.documentElement);
    return Array.from({ length: count }, (_, i) => style.getPropertyValue(`--c${i}`).trim());
  }, palette);
  expect(after.colours() > 4, `the picture has ${after.colours()} colours`);
  const inside = vehicles.flatMap(({ place }, i) => place !== null && place.x > 0 && place.y > 0 && place.x < after.width && place.y < after.height ? [{ place, i }] : []);
  expect(inside.length === film.vehicles, `${inside.length} of ${film.vehicles} vehicles are in the picture`);
  const far = ({ place }) => old_places.every((old) => old !== null && Math.hypot(old.x - place.x, old.y - place.y) > 25);
  const moved = inside.filter(far);
  expect(moved.length > 0, 'no vehicle is where none was before');
  for (const { place, i } of moved) {
    const now = after.disc(place, 9);
    const then = before.disc(place, 9);
    const changed = now.filter((colour, k) => distance(colour, then[k]) > 25).length;
    expect(changed >= 8, `vehicle ${i}: ${changed} pixels differ from the empty water at ${JSON.stringify(place)}`);
    const wanted = hue(colours[i % palette].match(/[0-9a-f]{2}/gi).map((part) => parseInt(part, 16)));
    const alike = now.filter((colour) => hue(colour) !== null && Math.abs(((hue(colour) - wanted + 540) % 360) - 180) < 30).length;
    expect(wanted === null || alike >= 3, `vehicle ${i}: ${alike} pixels of its colour ${colours[i % palette]} at ${JSON.stringify(place)}`);
  }
}

async function spheres_surround_vehicles(view, expect) {
  await view.layers();
  const bare = await view.settled();
  await view.layers('spheres');
  const with_spheres = await view.settled();
  const { vehicles } = await view.state();
  const tint = { clear: [60, 200], detected: [15, 55], collided: [-25, 14] };
  let alike = 0;
  for (const { place, alert } of vehicles) {
    const without = bare.disc(place, 12);
    const changed = with_spheres.disc(place, 12).filter((colour, k) => distance(colour, without[k]) > 3);
    expect(changed.length > 40, `a sphere changes ${changed.length} pixels around ${JSON.stringify(place)}`);
    const hues = changed.map(hue).filter((angle) => angle !== null).map((angle) => (angle > 330 ? angle - 360 : angle));
    const [low, high] = tint[alert];
    if (hues.filter((angle) => angle >= low && angle <= high).length > 0.2 * hues.length) ++alike;
  }
  expect(alike >= 0.6 * vehicles.length, `${alike} of ${vehicles.length} spheres have the colour of their alert`);
}

/** Red less green around a vehicle: green, orange and red are in this order. */
async function redness(view, frame, vehicle) {
  await view.seek_frame(frame);
  const picture = await view.settled();
  const { place, alert } = (await view.state()).vehicles[vehicle];
  const colours = picture.disc(place, 30);
  return { alert, value: colours.reduce((sum, [r, g]) => sum + r - g, 0) / colours.length };
}

async function alerts_change_at_their_frame(view, expect) {
  const { events } = await view.film();
  await view.layers('spheres');
  let seen = 0;
  for (const [kind, alert] of [['detected', 'detected'], ['collision', 'collided']]) {
    const event = events.find((entry) => entry.kind === kind && entry.time_s > 1);
    if (event === undefined) continue;
    const frame = await view.frame_of(event.time_s);
    const [earlier, before, now] = [await redness(view, frame - 2, event.vehicle), await redness(view, frame - 1, event.vehicle), await redness(view, frame, event.vehicle)];
    const said = `${kind} of vehicle ${event.vehicle} at frame ${frame}`;
    expect(before.alert !== alert && now.alert === alert, `${said}: ${before.alert}, then ${now.alert}`);
    const [drift, jump] = [Math.abs(before.value - earlier.value), now.value - before.value];
    expect(jump > 1.5 && jump > 3 * drift, `${said}: the sphere grew redder by ${jump.toFixed(2)}, by ${drift.toFixed(2)} the frame before`);
    ++seen;
  }
  expect(events.length === 0 || seen > 0, 'no event was looked at');
}

async function numbers_are_those_of_the_film(view, expect) {
  const { count } = await view.film();
  for (const index of [0, Math.floor(count / 7), Math.floor(count / 2), count - 1]) {
    await view.seek_frame(index);
    const state = await view.state();
    const { time, vehicles } = await view.values(index);
    expect(state.index === index && state.time === time, `sought frame ${index}, at ${state.index}, t = ${state.time}`);
    const shown = await view.page.evaluate(() => ({
      now: document.querySelector('.now').textContent, at: document.querySelector('.at-time').textContent,
      positions: [...document.querySelectorAll('.vehicle .place')].map((row) => [...row.querySelectorAll('b')].map((b) => b.textContent)),
      brief: document.querySelector('.vehicles .brief') !== null,
    }));
    expect(plain(shown.now) === printed(time) && plain(shown.at) === printed(time), `t = ${time} is printed as ${shown.now}, ${shown.at}`);
    vehicles.forEach(({ position }, v) => {
      const wanted = position.map(printed).join();
      expect(state.vehicles[v].position.map(plain).join() === wanted, `vehicle ${v} at ${wanted} is ${state.vehicles[v].position}`);
      if (!shown.brief) expect(shown.positions[v].map(plain).join() === wanted, `vehicle ${v} at ${wanted} is printed at ${shown.positions[v]}`);
    });
  }
}

async function what_a_vehicle_cannot_do_is_said(view, expect) {
  const words = ['', 'commanded slower than it can go', 'commanded astern, which it cannot go', 'commanded sideways, which it cannot go'];
  const frames = await view.page.evaluate(() => {
    const { film } = window.fairway;
    const found = new Map();
    for (let i = 0; i < film.count; ++i) {
      for (let v = 0; v < film.vehicles; ++v) {
        const kind = film.value('shortfall', i, v);
        if (!found.has(kind)) found.set(kind, { i, v, kind });
      }
    }
    return [...found.values()];
  });
  for (const { i, v, kind } of frames) {
    await view.seek_frame(i);
    const card = view.page.locator('.vehicle').nth(v).locator('.shortfall');
    expect(await card.textContent() === words[kind] && await card.isVisible() === (kind > 0),
      `frame ${i}, vehicle ${v}: shortfall ${kind} is said as "${await card.textContent()}"`);
  }
}

async function no_progress_is_said(view, expect) {
  const frames = await view.page.evaluate(() => {
    const { film } = window.fairway;
    const found = new Map();
    for (let i = 0; i < film.count; ++i) {
      for (let v = 0; v < film.vehicles; ++v) {
        const [state, since, other] = ['progress', 'no_progress_s', 'progress_with'].map((name) => film.value(name, i, v));
        const key = `${state} ${other >= 0}`;
        if (!found.has(key)) found.set(key, { i, v, state, since, other });
      }
    }
    return [...found.values()];
  });
  const names = await view.page.locator('.vehicle .name').allTextContents();
  for (const { i, v, state, since, other } of frames) {
    await view.seek_frame(i);
    const who = names[other] ?? `obstacle ${other - names.length}`;
    const how = other < 0 ? (state === 4 ? 'trapped' : 'it holds on purpose') : `${state === 2 ? 'waiting for' : 'deadlocked with'} ${who}`;
    const wanted = state < 2 ? '' : `no progress for ${since.toFixed(1)} s: ${how}`;
    const card = view.page.locator('.vehicle').nth(v).locator('.progress');
    const text = plain(await card.textContent());
    expect(text === wanted && await card.isVisible() === (state > 1), `frame ${i}, vehicle ${v}: progress ${state} is said as "${text}", expected "${wanted}"`);
  }
}

async function who_waits_for_whose_word_is_drawn_and_said(view, expect) {
  const { page } = view;
  // the first frame in which somebody holds and waits, and the first in which it does not hold though it last said so
  const [waits, goes] = await page.evaluate(() => [2, 0].map((mode) => {
    const { film } = window.fairway;
    for (let i = 0; i < film.count; ++i) {
      for (let v = 0; v < film.vehicles; ++v) {
        const word = film.words.at(v, film.time(i))?.word;
        if (word?.awaited.length > 0 && film.value('mode', i, v) === mode) return { i, v, ...word };
      }
    }
    return null;
  }));
  if (waits === null) return;
  await page.keyboard.press('Escape');
  await view.layers('messages');
  const key = page.locator('.picture', { hasText: 'whose word it waits for' });
  await view.seek_frame(waits.i);
  const drawn = await view.settled();
  expect(await key.count() === 1, `frame ${waits.i}: the key does not say who waits`);
  await view.layers();
  expect((await view.settled()).differs_from(drawn) > 20, `frame ${waits.i}: nothing is drawn of who waits`);
  await page.locator('.vehicle').nth(waits.v).click();
  await page.waitForTimeout(400);
  const said = plain(await page.locator('.perceived .words').textContent());
  const names = await page.locator('.vehicle .name').allTextContents();
  expect(said.includes(`at ${waits.sent_s.toFixed(2)} s: ${waits.text}`), `its last word is not said, but "${said}"`);
  expect(said.includes(`waits for words of ${waits.awaited.map((v) => names[v]).join(', ')}`), `whom it waits for is not said, but "${said}"`);
  await page.keyboard.press('Escape');
  if (goes === null) return;
  await view.layers('messages');
  await view.seek_frame(goes.i);
  await view.settled();
  expect(await key.count() === 0, `frame ${goes.i}: who goes on is drawn as waiting`);
}

async function what_is_not_heard_is_named(view, expect) {
  const { page } = view;
  const flight = await page.evaluate(() => window.fairway.film.flights.find(({ unheard }) => unheard) ?? null);
  if (flight === null) return;
  await page.keyboard.press('Escape');
  await view.layers('messages');
  await page.evaluate((time) => window.fairway.seek(time), flight.begins_s);
  await view.settled();
  const key = await page.locator('.stage-key').textContent();
  expect(key.includes('a message under way') && key.includes('one that is not heard: its receiver transmits, or another is in its way'), `the key names both: ${key}`);
  await page.locator('.vehicle').nth(flight.to).click();
  await page.waitForTimeout(400);
  expect((await page.locator('.perceived').textContent()).includes('not heard: the receiver transmits, or another message is in its way'), 'and it is said');
  await page.keyboard.press('Escape');
}

async function it_plays(view, expect) {
  await view.seek_frame(0);
  await view.page.keyboard.press('ArrowUp');
  await view.page.keyboard.press('ArrowUp');
  const before = await view.settled();
  const began = Date.now();
  await view.page.keyboard.press(' ');
  expect((await view.state()).playing, 'space does not play');
  await view.page.waitForFunction(() => window.fairway.state().time > 4, null, { timeout: 20000 });
  await view.page.keyboard.press(' ');
  const longest = 4 * (Date.now() - began) / 1000;
  const state = await view.state();
  const { time } = await view.values(state.index);
  expect(!state.playing && state.speed === 4, `at ${state.speed}, ${state.playing ? 'playing' : 'at rest'}`);
  expect(state.time > 3.5 && state.time < longest, `after ${longest / 4} s at 4 times the pace it is ${state.time} s`);
  expect(state.time === time, `at rest between frames, at ${state.time}`);
  expect((await view.settled()).differs_from(before) > 20, 'nothing moved in the picture');
  await view.page.keyboard.press('ArrowDown');
  await view.page.keyboard.press('ArrowDown');
}

async function it_ends_and_begins_again(view, expect) {
  const { count } = await view.film();
  await view.seek_frame(count - 3);
  await view.page.click('.play');
  await view.page.waitForFunction(() => !window.fairway.state().playing, null, { timeout: 20000 });
  expect((await view.state()).index === count - 1, 'it does not stop at the end');
  await view.page.click('.play');
  const again = view.page.waitForFunction((half) => {
    const { playing, index } = window.fairway.state();
    return playing && index < half;
  }, count / 2, { timeout: 20000 });
  expect(await again.then(() => true, () => false), `after the end it plays from frame ${(await view.state()).index}`);
  await view.page.click('.play');
}

async function keys_and_scrubber_move_time(view, expect) {
  const { count, events } = await view.film();
  const index = async () => (await view.state()).index;
  const { page } = view;
  await page.click('.stage-area', { position: { x: 5, y: 200 } });
  await page.keyboard.press('End');
  expect(await index() === count - 1, 'End does not end');
  await page.keyboard.press('ArrowLeft');
  expect(await index() === count - 2, 'left is not one frame');
  await page.keyboard.press('Home');
  await page.keyboard.press('Shift+ArrowRight');
  const one = (await view.state()).time - (await view.values(0)).time;
  expect(Math.abs(one - 1) < 0.51, `shift and right go ${one} s`);
  const box = await page.locator('.scrubber').boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height - 12);
  expect(Math.abs(await index() - (count - 1) / 2) <= 0.01 * count + 2, `half the scrubber is frame ${await index()} of ${count}`);
  await page.keyboard.press('ArrowRight');
  expect(await page.inputValue('.scrubber') === String(await index()), 'the scrubber is elsewhere');
  if (events.length === 0) return;
  const first = page.locator('.events button').first();
  if (!(await first.isVisible())) await page.click('#events summary');
  await first.click();
  expect(await index() === await view.frame_of(events[0].time_s), `the first event goes to frame ${await index()}`);
}

async function choosing_changes_the_picture(view, expect) {
  const { page } = view;
  await view.camera('orbit');
  await view.layers('trails', 'spheres', 'goals', 'sketch');
  await page.keyboard.press('f');
  const { count, vehicles, sketches } = await view.film();
  await view.seek_frame(Math.floor(count / 3));
  await page.keyboard.press('Escape');
  const nobody = await view.settled();
  const cards = page.locator('.vehicle');
  await cards.nth(0).click();
  expect((await view.state()).chosen.join() === '0' && await cards.nth(0).getAttribute('aria-pressed') === 'true', 'a click does not choose');
  const one = await view.settled();
  expect(one.differs_from(nobody) > 10, 'a chosen vehicle looks like any other');
  if (sketches) {
    await page.keyboard.press('k');
    expect((await view.settled()).differs_from(one) > 10, 'a sketch makes no difference to the picture');
    await page.keyboard.press('k');
  }
  if (vehicles > 1) {
    await cards.nth(1).click({ modifiers: ['Shift'] });
    expect((await view.state()).chosen.join() === '0,1', 'shift does not add');
  }
  await page.keyboard.press('Escape');
  expect((await view.state()).chosen.length === 0, 'Escape chooses somebody');
  await view.camera('top');
  const places = (await view.settled(), (await view.state()).vehicles.map(({ place }) => place));
  const alone = places.findIndex((place, i) => places.every((other, k) => k === i || Math.hypot(place.x - other.x, place.y - other.y) > 40));
  if (alone >= 0) {
    await page.locator('.picture').click({ position: places[alone] });
    expect((await view.state()).chosen.join() === String(alone), `a click in the picture on vehicle ${alone} chooses ${(await view.state()).chosen}`);
    await page.keyboard.press('Escape');
  }
}

async function cameras_and_layers_change_the_picture(view, expect) {
  await view.layers('trails', 'spheres', 'grid');
  let last = null;
  for (const kind of ['orbit', 'top', 'side', 'follow']) {
    await view.camera(kind);
    const picture = await view.settled();
    expect((await view.state()).camera === kind, `the camera is ${(await view.state()).camera}, not ${kind}`);
    expect(picture.colours() > 4, `from ${kind} there is nothing to see`);
    if (last !== null) expect(picture.differs_from(last) > 200, `${kind} looks like the camera before`);
    last = picture;
  }
  await view.camera('orbit');
  let before = await view.settled();
  for (const layer of ['spheres', 'trails', 'grid']) {
    await view.page.click(`[data-layer="${layer}"]`);
    const after = await view.settled();
    expect(after.differs_from(before) > 20, `the layer ${layer} makes no difference`);
    before = after;
  }
}

async function the_theme_changes_the_picture(view, expect, { scheme }) {
  const dark = async () => Number((await view.page.evaluate(() => getComputedStyle(document.body).backgroundColor)).match(/\d+/)[0]) < 100;
  expect(await dark() === (scheme === 'dark'), 'the page does not follow the system');
  const before = await view.settled();
  await view.page.click('.theme-toggle');
  expect(await dark() !== (scheme === 'dark'), 'the theme does not toggle');
  expect((await view.settled()).differs_from(before) > before.width * before.height / 4, 'the picture does not follow the theme');
  await view.page.click('.theme-toggle');
}

async function it_fits_a_phone(view, expect) {
  const { page } = view;
  const size = page.viewportSize();
  for (const width of [390, size.width]) {
    await page.setViewportSize({ width, height: 844 });
    const picture = await view.settled();
    expect(picture.colours() > 4, `at ${width} px nothing is drawn`);
    const found = await page.evaluate(() => {
      const root = document.documentElement;
      const wide = [...document.querySelectorAll('.playback *')].filter((e) => e.closest('svg, dialog, .picture, .charts-strip, #thoughts, #explanation') === null &&
        e.checkVisibility() && e.getBoundingClientRect().right > root.clientWidth + 1);
      const small = [...document.querySelectorAll('.playback :is(button, summary, select)')].filter((e) => e.closest('.charts-strip, #thoughts, #explanation, dialog') === null &&
        e.checkVisibility() && Math.min(e.getBoundingClientRect().height, e.getBoundingClientRect().width) < 39.5);
      const canvas = document.querySelector('.picture canvas').getBoundingClientRect();
      return { scroll: root.scrollWidth, client: root.clientWidth, canvas: [canvas.width, canvas.height],
        wide: wide.slice(0, 3).map((e) => `${e.tagName}.${e.className}`), small: small.slice(0, 3).map((e) => `${e.tagName} ${e.textContent}`) };
    });
    const box = await page.locator('.picture').boundingBox();
    expect(found.scroll <= found.client && found.wide.length === 0, `at ${width} px it is too wide: ${JSON.stringify(found)}`);
    expect(Math.abs(found.canvas[0] - box.width) <= 1 && Math.abs(found.canvas[1] - box.height) <= 1, `the canvas is ${found.canvas} in ${JSON.stringify(box)}`);
    if (width < 500) expect(found.small.length === 0, `too small to touch: ${found.small.join(', ')}`);
  }
  await page.setViewportSize(size);
}

async function controls_have_names(view, expect) {
  const found = await view.page.evaluate(() => ({
    nameless: [...document.querySelectorAll('button, select, input')].filter((e) => !(e.getAttribute('aria-label') || e.closest('label') || e.textContent.trim())).length,
    h1: document.querySelectorAll('h1').length, bad: /NaN|undefined/.test(document.body.innerText),
  }));
  expect(found.nameless === 0 && found.h1 === 1, `controls without a name, headings: ${JSON.stringify(found)}`);
  expect(!found.bad, 'NaN or undefined on the page');
  await view.page.keyboard.press('?');
  expect(await view.page.locator('dialog').isVisible(), 'no help');
  await view.page.keyboard.press('Escape');
  expect(!(await view.page.locator('dialog').isVisible()), 'the help stays');
}

async function downloads_are_complete(view, expect) {
  const { page } = view;
  const { count, vehicles } = await view.film();
  const take = async (label) => {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`.saving button:has-text("${label}")`)]);
    return readFileSync(await download.path());
  };
  const lines = (await take('Save the frames')).toString().trim().split('\r\n');
  expect(lines.length === count * vehicles + 1, `${lines.length} lines for ${count} frames of ${vehicles} vehicles`);
  const names = lines[0].split(',');
  const row = Math.floor(count / 2);
  const fields = lines[1 + row * vehicles + vehicles - 1].split(',');
  const { time, vehicles: there } = await view.values(row);
  const found = ['time_s', 'n_m', 'e_m', 'd_m'].map((name) => Number(fields[names.indexOf(name)]));
  expect(found.join() === [time, ...there[vehicles - 1].position].join(), `the saved line says ${found}`);
  const png = await take('Save the picture');
  expect(png.length > 1000 && png.toString('latin1', 1, 4) === 'PNG', 'the picture is no PNG');
}

export const checks = [
  controls_have_names, vehicles_are_where_they_should_be, spheres_surround_vehicles, alerts_change_at_their_frame, numbers_are_those_of_the_film,
  what_a_vehicle_cannot_do_is_said, no_progress_is_said, who_waits_for_whose_word_is_drawn_and_said, what_is_not_heard_is_named, it_plays, it_ends_and_begins_again, keys_and_scrubber_move_time, choosing_changes_the_picture, cameras_and_layers_change_the_picture,
  the_theme_changes_the_picture, it_fits_a_phone, downloads_are_complete,
];
/** In the other theme: what depends on it. */
export const theme_checks = [vehicles_are_where_they_should_be, spheres_surround_vehicles, the_theme_changes_the_picture];
/** In a window that was narrow from the start. */
export const phone_checks = [it_fits_a_phone];
