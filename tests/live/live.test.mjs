// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { Agent } from 'node:http';
import { connect } from 'node:net';
import { networkInterfaces, tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { ask, command, hang_up, interrupt, part, post, read_all, scenario, start, state, until } from './client.mjs';
import { document_of, frames_of } from './film.mjs';

const folder = mkdtempSync(join(tmpdir(), 'fairway-live-'));
const runs = [];
const live = async (...words) => {
  const run = await start(...words);
  runs.push(run);
  return run;
};
after(() => {
  rmSync(folder, { recursive: true });
  for (const run of runs) run.child.kill('SIGKILL');  // those of tests that failed; the others are no more
});

test('two readers see every frame once, as it is recorded, and looking changes no bit of it', async () => {
  const seen = join(folder, 'seen.mcap');
  const unseen = join(folder, 'unseen.mcap');
  const run = await live('--speed', '0', '--out', seen);
  const page = await ask(run, '/');
  const [parts, others] = await Promise.all([read_all(run), read_all(run)]);
  assert.equal(await interrupt(run), 0);
  assert.match(run.out, /min_separation_m/);  // the metrics, after all
  execFileSync(command, ['run', scenario, '--out', unseen]);
  assert.ok(readFileSync(seen).equals(readFileSync(unseen)), 'the recordings differ');  // their run hash is in them
  execFileSync(command, ['replay', seen, '--verify']);

  const csv = join(folder, 'seen.csv');
  execFileSync(command, ['replay', seen, '--csv', csv]);
  const [head, ...rows] = readFileSync(csv, 'utf8').trim().split('\n').map((line) => line.split(','));
  const at = (name) => {
    assert.ok(head.includes(name), `the CSV has no column ${name}: ${head}`);
    return head.indexOf(name);
  };
  const columns = ['x_m', 'y_m', 'z_m'].map(at);
  const document = document_of(page.body);
  assert.equal(document.film, null);
  const frames = frames_of(parts, document);
  assert.deepEqual(frames_of(others, document), frames);
  assert.equal(frames.length * 2, rows.length);
  assert.ok(frames.length > 500);
  frames.forEach((frame, i) => {
    frame.positions.forEach((position, v) => {
      const row = rows[2 * i + v];
      assert.equal(frame.time, Number(row[at('time_s')]));
      assert.deepEqual(position, columns.map((c) => Number(row[c])));
    });
  });
});

test('the page may ask its own server and nobody else', async () => {
  const run = await live('--paused');
  const page = await ask(run, '/');
  assert.equal(page.status, 200);
  assert.match(page.headers['content-type'], /^text\/html/);
  assert.equal(page.headers['x-content-type-options'], 'nosniff');
  assert.equal(page.headers['cache-control'], 'no-store');
  assert.equal(page.headers['cross-origin-resource-policy'], 'same-origin');
  assert.equal(page.headers['x-frame-options'], 'DENY');
  const policy = /http-equiv="Content-Security-Policy" content="([^"]*)"/.exec(page.body)[1];
  assert.match(policy, /default-src 'none'/);
  assert.equal(policy.split("connect-src 'self'").length, 2, policy);

  const refused = [
    ['/', { headers: { Host: `rebound.example:${run.port}` } }, 403],
    ['/', { headers: { Host: '127.0.0.1' } }, 403],
    ['/part?from=0&generation=0', { headers: { Origin: 'http://evil.example' } }, 403],
    ['/part?from=0&generation=0', { headers: { 'Sec-Fetch-Site': 'cross-site' } }, 403],
    ['/resume', { method: 'POST', headers: { 'X-Fairway': '1', Origin: 'null' } }, 403],
    ['/resume', { method: 'POST', headers: { 'X-Fairway': '1', 'Sec-Fetch-Site': 'same-site' } }, 403],
    ['/resume', { method: 'POST' }, 403],
    ['/resume', { method: 'OPTIONS', headers: { Origin: 'http://evil.example', 'Access-Control-Request-Headers': 'x-fairway' } }, 403],
    ['/resume', { method: 'OPTIONS' }, 405],
    ['/resume', {}, 405],
    ['/', { method: 'DELETE' }, 405],
    ['/quit', { method: 'POST', headers: { 'X-Fairway': '1' } }, 404],
    ['/part?from=-1&generation=0', {}, 400],
    ['/part?from=0', {}, 400],
  ];
  for (const [path, how, status] of refused) {
    const answer = await ask(run, path, how);
    assert.equal(answer.status, status, `${path} ${JSON.stringify(how)}`);
    assert.equal(answer.headers['access-control-allow-origin'], undefined);
    assert.match(answer.body, /^[^\n]+\n$/);
  }
  assert.equal((await state(run)).paused, true);
  assert.equal((await ask(run, '/', { headers: { Host: `localhost:${run.port}` } })).status, 200);
  assert.equal(await interrupt(run), 130);
});

test('it pauses, steps and resumes when told to', async () => {
  const run = await live('--paused', '--speed', '50');
  await until(async () => (await part(run)).part?.count === 1, 'the first frame');
  assert.equal((await post(run, '/step')).status, 204);
  await until(async () => (await part(run)).part.count === 2, 'one step');
  const stepped = await state(run);
  assert.ok(stepped.time_s > 0 && stepped.paused && stepped.speed === 50);
  assert.equal((await post(run, '/resume')).status, 204);
  await until(async () => (await state(run)).time_s > stepped.time_s + 1, 'the run to go on');
  assert.equal((await post(run, '/step')).status, 409);
  assert.equal((await post(run, '/pause')).status, 204);
  const held = await state(run);
  await new Promise((wake) => setTimeout(wake, 100));
  const later = await state(run);
  assert.ok(held.paused && later.time_s - held.time_s <= 0.2, 'at most the step that was under way');
  assert.equal(await interrupt(run), 130);
});

test('a hundred that hang up in the middle leave it serving', async () => {
  for (const words of [['--paused'], ['--speed', '0'], ['--speed', '5']]) {
    const run = await live(...words);
    const heads = { '/': 20_000, '/part?from=0&generation=0': 200, '/nothing': 10 };
    let cut = 0;
    await Promise.all(
      Array.from({ length: 100 }, async (_, k) => {
        const [path, bytes] = Object.entries(heads)[k % 3];
        const text = `GET ${path} HTTP/1.1\r\nHost: 127.0.0.1:${run.port}\r\n\r\n`;
        const heard = k % 5 === 0 ? await hang_up(run, text.slice(0, 9), 0) : await hang_up(run, text, k % 2 === 0 ? bytes : 0);
        if (heard > 0) ++cut;
      }),
    );
    assert.ok(cut > 10, `${cut} hung up in mid-answer`);
    assert.equal(run.child.exitCode, null);
    assert.equal((await ask(run, '/')).status, 200);
    assert.ok((await part(run)).part.count > 0);
    await interrupt(run);
    assert.equal(run.child.signalCode, null);
  }
});

test('many that connect and say nothing keep nobody out, and one that never reads keeps nobody waiting', async () => {
  const run = await live('--speed', '20');
  const silent = Array.from({ length: 200 }, (_, k) => {
    const socket = connect(run.port, '127.0.0.1');
    socket.on('error', () => {});
    socket.pause();
    if (k % 2 === 0) socket.write(`GET / HTTP/1.1\r\nHost: 127.0.0.1:${run.port}\r\n\r\n`.repeat(20));
    return socket;
  });
  const before = await state(run);
  await until(async () => (await state(run)).time_s > before.time_s + 2, 'the run to go on');
  for (const socket of silent) socket.destroy();
  await interrupt(run);
});

test('a request larger than any of ours ends its connection and no other', async () => {
  const run = await live('--paused');
  const agent = new Agent({ keepAlive: true, maxSockets: 1 });
  assert.equal((await ask(run, '/', { agent })).status, 200);
  const answer = await ask(run, '/', { headers: { 'X-Long': 'x'.repeat(9000) } }).catch((error) => error);
  assert.ok(answer.status === 431 || answer.code === 'ECONNRESET' || answer.code === 'EPIPE', String(answer.status ?? answer));
  assert.equal((await ask(run, '/', { agent })).status, 200);
  agent.destroy();
  await interrupt(run);
});

test('no other address of the machine reaches it', async () => {
  const run = await live('--paused');
  const addresses = Object.values(networkInterfaces()).flat().filter((i) => !i.internal).map((i) => i.address.split('%')[0]);
  for (const host of [...addresses, '::1', '127.0.0.2']) {
    const reached = await new Promise((resolve) => {
      const socket = connect({ host, port: run.port, timeout: 2000 });
      const end = (answer) => {
        socket.destroy();
        resolve(answer);
      };
      socket.on('connect', () => end(true));
      socket.on('error', () => end(false));
      socket.on('timeout', () => end(false));
    });
    assert.equal(reached, false, host);
  }
  await interrupt(run);
});

test('with --json the address goes to stderr, and with --until-done the run ends by itself', async () => {
  const run = await live('--json', '--until-done', '--speed', '0');
  assert.equal(await run.ended, 0);
  assert.match(run.err, /^live: http:\/\/127\.0\.0\.1:\d+\/\n/);
  assert.equal(JSON.parse(run.out).scenario, 'head_on');
});

test('a port that is taken, flags that mean nothing and whatever a run refuses are one clear line and exit code 2', async () => {
  const run = await live('--paused');
  for (const words of [['--live', '--port', String(run.port)], ['--live', '--port', '70000'], ['--live', '--speed', '-1'],
    ['--live', '--speed', 'nan'], ['--live', '--algorithm', 'orca4d'], ['--live', '--out', '/nowhere/run.mcap'], ['--port', '8080'], ['--paused']]) {
    const { status, stdout, stderr } = spawnSync(command, ['run', scenario, ...words], { encoding: 'utf8' });
    assert.equal(status, 2, words.join(' '));
    assert.equal(stdout, '');
    assert.match(stderr, /^fairway: [^\n]+\n$/);
  }
  await interrupt(run);
});
