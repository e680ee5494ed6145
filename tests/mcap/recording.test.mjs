// SPDX-License-Identifier: Apache-2.0
//
// npm ci && node --test
//
// Runs a scenario with the fairway command, exports the recording, and lets independent readers compare
// the two. FAIRWAY is the command (default build/bin/fairway), SCENARIO the scenario (default: the first
// file in scenarios/).

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { compare } from "./read_recording.mjs";

const root = new URL("../..", import.meta.url).pathname;
const fairway = process.env.FAIRWAY ?? join(root, "build/bin/fairway");

function firstScenario() {
  const folder = join(root, "scenarios");
  const [first] = readdirSync(folder).filter((name) => name.endsWith(".yaml")).sort();
  return join(folder, first);
}

const scenario = process.env.SCENARIO ?? firstScenario();
let folder;
before(() => (folder = mkdtempSync(join(tmpdir(), "fairway-mcap-"))));
after(() => rmSync(folder, { recursive: true }));

function record(name) {
  const recording = join(folder, name);
  execFileSync(fairway, ["run", scenario, "--out", recording], { stdio: ["ignore", "ignore", "inherit"] });
  return recording;
}

test("independent readers find in a recording what its CSV export says", async () => {
  const recording = record("run.mcap");
  const csv = join(folder, "run.csv");
  execFileSync(fairway, ["replay", recording, "--csv", csv], { stdio: ["ignore", "ignore", "inherit"] });
  const { frames, vehicles, rows } = await compare(recording, csv);
  assert.ok(frames > 0);
  assert.equal(rows, frames * vehicles);
});

test("the same run gives the same bytes", () => {
  assert.ok(readFileSync(record("first.mcap")).equals(readFileSync(record("second.mcap"))));
});
