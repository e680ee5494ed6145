// SPDX-License-Identifier: Apache-2.0
// A run that serves its page, and clients of it: polite ones, and one that hangs up.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { request } from 'node:http';
import { connect } from 'node:net';

const { FAIRWAY: command, SCENARIO: scenario } = process.env;
export { command, scenario };

/** Starts `fairway run SCENARIO --live words...`; resolves once it has printed its address. */
export async function start(...words) {
  const child = spawn(command, ['run', scenario, '--live', ...words], { stdio: ['ignore', 'pipe', 'pipe'] });
  const run = { child, out: '', err: '' };
  child.stdout.on('data', (data) => (run.out += data));
  child.stderr.on('data', (data) => (run.err += data));
  run.ended = once(child, 'close').then(([code]) => code);
  await until(() => / http:\/\/127\.0\.0\.1:\d+\/\n/.test(run.out + run.err) || child.exitCode !== null, 'an address');
  run.port = Number(/127\.0\.0\.1:(\d+)/.exec(run.out + run.err)?.[1]);
  return run;
}

/** Interrupts as Ctrl-C does, and gives the exit code. */
export async function interrupt(run) {
  run.child.kill('SIGINT');
  return run.ended;
}

export async function until(holds, what, patience_ms = 30000) {
  const end = Date.now() + patience_ms;
  while (!(await holds())) {
    if (Date.now() > end) throw new Error(`waited in vain for ${what}`);
    await new Promise((wake) => setTimeout(wake, 10));
  }
}

/** One request; headers may be anything, Host too. */
export function ask(run, path, { method = 'GET', headers = {}, agent = false } = {}) {
  return new Promise((resolve, reject) => {
    const asked = request({ host: '127.0.0.1', port: run.port, path, method, headers, agent }, (answer) => {
      const chunks = [];
      answer.on('data', (chunk) => chunks.push(chunk));
      answer.on('end', () => resolve({ status: answer.statusCode, headers: answer.headers, body: Buffer.concat(chunks).toString() }));
      answer.on('error', reject);
    });
    asked.on('error', reject);
    asked.end();
  });
}

export const post = (run, path, headers = {}) => ask(run, path, { method: 'POST', headers: { 'X-Fairway': '1', ...headers } });

export async function part(run, from = 0, generation = 0) {
  const answer = await ask(run, `/part?from=${from}&generation=${generation}`);
  if (answer.status !== 200) throw new Error(`${answer.status}: ${answer.body}`);
  return JSON.parse(answer.body);
}

export const state = async (run) => (await part(run, 0)).state;

/** Reads parts as the page does until the run is over and there are no more: the parts. */
export async function read_all(run, on_part = () => {}) {
  const parts = [];
  let have = 0;
  let generation = 0;
  for (;;) {
    const answer = await part(run, have, generation);
    if (answer.part === null) {
      if (answer.state.done) return parts;
      await new Promise((wake) => setTimeout(wake, 20));
      continue;
    }
    if (answer.part.first === 0) parts.length = 0;
    parts.push(answer.part);
    have = answer.part.first + answer.part.count;
    generation = answer.part.generation;
    on_part(answer);
  }
}

/** Asks, and hangs up with a reset after `bytes` of the answer; 0: at once. */
export function hang_up(run, text, bytes) {
  return new Promise((resolve) => {
    const socket = connect(run.port, '127.0.0.1');
    let heard = 0;
    socket.on('error', () => {});
    socket.on('close', () => resolve(heard));
    socket.on('connect', () => {
      socket.write(text, () => bytes === 0 && socket.resetAndDestroy());
    });
    socket.on('data', (data) => {
      heard += data.length;
      if (heard >= bytes) socket.resetAndDestroy();
    });
  });
}
