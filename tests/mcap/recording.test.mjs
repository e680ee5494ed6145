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

const quiet = { stdio: ["ignore", "ignore", "inherit"] };

function record(name, ...flags) {
  return recordOf(scenario, name, ...flags);
}

function recordOf(file, name, ...flags) {
  const recording = join(folder, name);
  execFileSync(fairway, ["run", file, "--out", recording, ...flags], quiet);
  return recording;
}

/** Exports of a recording by the names of their flags. */
function exported(recording, ...kinds) {
  return kinds.map((kind) => {
    const file = `${recording}.${kind}.csv`;
    execFileSync(fairway, ["replay", recording, `--${kind}`, file], quiet);
    return file;
  });
}

test("independent readers find in a recording what its CSV export says", async () => {
  const recording = record("run.mcap");
  const { frames, vehicles, rows } = await compare(recording, ...exported(recording, "csv"));
  assert.ok(frames > 0);
  assert.equal(rows, frames * vehicles);
});

test("and what was perceived, where it is recorded", async () => {
  const recording = record("perceived.mcap", "--perception");
  const csvs = exported(recording, "csv", "tracks", "echoes");
  const { frames, vehicles, perceived } = await compare(recording, ...csvs);
  assert.ok(perceived.tracks > frames, "tracks in most frames");
  assert.ok(perceived.messages < 2 * frames * vehicles, "written only where it changes");
});

test("and what was drawn, with what was perceived or without", async () => {
  const recording = record("drawn.mcap", "--sketch");
  const { frames, vehicles, drawn, perceived } = await compare(recording, ...exported(recording, "csv"));
  assert.equal(perceived, undefined);
  assert.ok(drawn.strokes > frames, "strokes in most frames");
  assert.ok(drawn.choices > frames / 2, "choices in many frames");
  assert.ok(drawn.messages < 2 * frames * vehicles, "written only where it changes");

  const both = record("both.mcap", "--sketch", "--perception");
  const again = await compare(both, ...exported(both, "csv", "tracks", "echoes"));
  assert.deepEqual(again.drawn, drawn);
  assert.ok(again.perceived.tracks > 0);
});

for (const flags of [[], ["--perception"], ["--sketch"]]) {
  test(`the same run gives the same bytes ${flags.join(" ")}`, () => {
    assert.ok(readFileSync(record("first.mcap", ...flags)).equals(readFileSync(record("second.mcap", ...flags))));
  });
}

test("and what methods said, each in a turn of its own", async () => {
  const pledged = join(root, "scenarios/pledge_cube.yaml");
  const recording = recordOf(pledged, "said.mcap");
  const { words } = await compare(recording, ...exported(recording, "csv"));
  assert.ok(words.size > 100);
  const silent = record("silent.mcap");
  assert.equal((await compare(silent, ...exported(silent, "csv"))).words.size, 0);
});
