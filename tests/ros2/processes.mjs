// SPDX-License-Identifier: Apache-2.0
// Programs under test, each with all that it said; whatever is still running goes with the test.
import { spawn } from "node:child_process";

const root = new URL("../../", import.meta.url).pathname;
const running = new Set();
process.on("exit", () => running.forEach((child) => child.kill("SIGKILL")));

/// Starts a program of the build, or a script of this folder. `ended` is its exit code.
export function start(program, ...words) {
  const [command, first] = program.endsWith(".mjs")
    ? [process.execPath, [new URL(program, import.meta.url).pathname]] : [`${root}build/bin/${program}`, []];
  const child = spawn(command, [...first, ...words.map(String)], { cwd: root });
  const said = { child, out: "", err: "" };
  running.add(child);
  child.stdout.on("data", (text) => (said.out += text));
  child.stderr.on("data", (text) => (said.err += text));
  said.ended = new Promise((resolve) => child.on("close", (code) => {
    running.delete(child);
    resolve(code);
  }));
  return said;
}

/// Its line of JSON, when it has ended.
export async function told(peer) {
  const code = await peer.ended;
  if (code !== 0) throw new Error(`exit code ${code}: ${peer.err}`);
  return JSON.parse(peer.out.trim().split("\n").at(-1));
}

export async function stop(...programs) {
  programs.forEach(({ child }) => child.kill("SIGTERM"));
  await Promise.all(programs.map(({ ended }) => ended));
}

export const wait = (seconds) => new Promise((resolve) => setTimeout(resolve, 1000 * seconds));

/// Until `is` holds, looked at ten times a second.
export async function until(is, seconds, what) {
  for (let i = 0; i < 10 * seconds; ++i, await wait(0.1)) if (is()) return;
  throw new Error(`not within ${seconds} s: ${what}`);
}
