// SPDX-License-Identifier: Apache-2.0
// The page of a live run, served by a small server that does as `fairway run --live` does; tests/live/browser.test.mjs orders a real one.
import { createServer } from 'node:http';
import { desk, ViewPage } from './view_page.mjs';

const bytes_of = { f64: 8, f32: 4, u8: 1 };
const chunk = 60;

/** Frames [first, first + count) of a whole film, as a part of their own. */
function part_of(sample, first, count, generation) {
  const whole = Buffer.from(sample.film.data, 'base64');
  const pieces = [];
  let at = 0;
  for (const { type, per, width } of sample.columns) {
    const size = bytes_of[type] * width * (per === 'vehicle' ? sample.scene.vehicles.length : 1);
    pieces.push(whole.subarray(at + first * size, at + (first + count) * size));
    at += size * sample.film.count;
  }
  const [from, to] = [first * sample.period_s - 1e-6, (first + count) * sample.period_s - 1e-6];
  return {
    first, count, stride: 1, generation, data: Buffer.concat(pieces).toString('base64'), compression: 'none', thoughts: '',
    events: sample.film.events.filter(({ time_s }) => time_s >= from && time_s < to),
  };
}

/** Serves the page and so many frames; `under_way` counts questions at once. */
function serve(html, sample) {
  const run = { frames: 120, done: false, divergence: '', generation: 0, under_way: 0, most: 0, asked: 0 };
  const answer = (query) => {
    const from = Number(query.get('from'));
    const first = Number(query.get('generation')) === run.generation ? from : 0;
    const count = Math.min(chunk, run.frames - first);
    return {
      part: count > 0 ? part_of(sample, first, count, run.generation) : null,
      state: { paused: false, done: run.done, time_s: run.frames * sample.period_s, speed: 2, divergence: run.divergence },
    };
  };
  const server = createServer((request, response) => {
    const { pathname, searchParams } = new URL(request.url, 'http://localhost');
    if (pathname === '/part') {
      ++run.asked;
      run.most = Math.max(run.most, ++run.under_way);
      setTimeout(() => {
        --run.under_way;
        response.writeHead(200, { 'content-type': 'application/json' }).end(JSON.stringify(answer(searchParams)));
      }, 10);
    } else if (pathname === '/') {
      response.writeHead(200, { 'content-type': 'text/html' }).end(html);
    } else {
      response.writeHead(404).end();
    }
  });
  return new Promise((done) => server.listen(0, '127.0.0.1', () => done({ server, run, address: `http://127.0.0.1:${server.address().port}/` })));
}

export async function look_at_live(browser, sample) {
  const html = browser.render(JSON.stringify({ ...sample, film: null, explanation: null }))
    .replace("default-src 'none';", "default-src 'none'; connect-src 'self';");
  const { server, run, address } = await serve(html, sample);
  const options = { ...desk, scheme: 'light', harmless: /GPU stall|GL Driver Message|ERR_CONNECTION_(REFUSED|RESET)/ };
  await browser.open(address, 'a live run', options, async (page, expect) => {
    const view = new ViewPage(page);
    const until = (what, wanted) => page.waitForFunction(what, wanted, { timeout: 20000 }).then(() => true, () => false);
    const shown = () => page.evaluate(() => window.fairway.state().index);
    expect(await until((n) => window.fairway?.film.count === n, 120), 'the frames that were there do not come');
    expect(await until((n) => window.fairway.state().index === n, 119), `it shows frame ${await shown()}, not the newest`);
    run.frames = 150;
    expect(await until((n) => window.fairway.state().index === n, 149), `it does not follow, at frame ${await shown()}`);
    await view.seek_frame(20);
    run.frames = 170;
    expect(await until((n) => window.fairway.film.count === n, 170) && await shown() === 20, 'scrubbing back does not hold');
    await page.click('.live-controls .live');
    expect(await shown() === 169, 'Live does not return to the newest frame');
    run.generation = 1;
    run.frames = 90;
    expect(await until(() => window.fairway.film.generation === 1 && window.fairway.film.count === 90), 'a thinned film does not replace the old one');
    expect(await shown() === 89, `after that it shows frame ${await shown()}`);
    const before = run.asked;
    const began = performance.now();
    await page.waitForTimeout(1000);
    const most = 21 * (performance.now() - began) / 1000;
    expect(run.asked - before <= most && run.asked > before, `${run.asked - before} questions where ${most} are too many`);
    expect(run.most === 1, `${run.most} questions at once`);
    server.close();
    server.closeAllConnections();
    expect(await until(() => document.querySelector('.live-status').textContent.includes('server is gone')), 'it does not say that the server is gone');
    expect(await page.evaluate(() => window.fairway.film.count) === 90, 'it loses what it had');
  });
  server.close();

  const broken = await serve(html, sample);
  await browser.open(broken.address, 'a live run that diverges', options, async (page, expect) => {
    const until = (wanted) => page.waitForFunction((text) => document.querySelector('.live-status')?.textContent === text, wanted, { timeout: 20000 })
      .then(() => true, () => false);
    await page.waitForFunction(() => window.fairway !== undefined);
    Object.assign(broken.run, { done: true, divergence: 'diverged: auv_0 at 12.1 s: its speed is beyond 200 m/s' });
    expect(await until(`The run ${broken.run.divergence}`), `a run that broke says: ${await page.textContent('.live-status')}`);
  });
  broken.server.close();
  broken.server.closeAllConnections();
}

/** Of a recorded run that broke: said at its last frame, and not before. */
export async function look_at_divergence(browser, sample) {
  const divergence = 'diverged: auv_0 at 12.1 s: its speed is beyond 200 m/s';
  const path = browser.write('diverged.html', JSON.stringify({ ...sample, explanation: null, divergence }));
  await browser.open(path, 'a run that diverged', { ...desk, scheme: 'light' }, async (page, expect) => {
    await page.waitForFunction(() => window.fairway !== undefined);
    const ending = page.locator('.live-status');
    expect(!await ending.isVisible(), 'it is said before the end');
    await page.evaluate(() => window.fairway.seek(window.fairway.film.end));
    expect(await ending.isVisible() && await ending.textContent() === `The run ${divergence}`, `at the end it says ${await ending.textContent()}`);
  });
}
