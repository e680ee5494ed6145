// SPDX-License-Identifier: Apache-2.0
// Whole fleets through DDS: a simulator and a process for each avoider.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import test from "node:test";
import { start, stop, told, until, wait } from "./processes.mjs";

const folder = mkdtempSync(`${tmpdir()}/fairway-ros2-`);
process.on("exit", () => rmSync(folder, { recursive: true }));
const pair = ["north_bound", "south_bound"];
const cube = Array.from({ length: 8 }, (_, i) => `robot${i}`);

/// A run through DDS; what the simulator said.
async function run(scenario, vehicles, settings, ofAvoiders, during = async () => {}) {
  const file = `scenarios/${scenario}.yaml`;
  const sim = start("fairway_sim_ros2", "--scenario", file, "--until_done", "true", "--wait_for_subscribers",
    vehicles.length, ...settings);
  const avoiders = vehicles.map((vehicle) => start("fairway_avoider_ros2", "--scenario", file, "--vehicle", vehicle, ...ofAvoiders));
  await during(sim, avoiders);
  const code = await sim.ended;
  await stop(...avoiders);
  return { code, out: sim.out, err: sim.err, avoiders };
}

const value = (out, name) => Number(out.match(new RegExp(`^ +${name} +(\\S+)$`, "m"))[1]);

/// The lines of a recording as CSV, by what the vehicles were and did, without what was ordered.
async function states(recording) {
  const csv = `${recording}.csv`;
  assert.equal(await start("fairway", "replay", recording, "--csv", csv).ended, 0);
  const [head, ...lines] = readFileSync(csv, "utf8").trim().split("\n").map((line) => line.split(","));
  const ordered = head.map((name) => /^command_|^mode$|^astern$/.test(name));
  return lines.map((line) => line.filter((_, i) => !ordered[i]).join());
}

test("in lockstep 2 vehicles do in ENU what the plain run does", async () => {
  const plain = start("fairway", "run", "scenarios/head_on.yaml");
  const { code, out, err } = await run("head_on", pair, ["--speed", 0, "--lockstep", "true"], ["--lockstep", "true"]);
  await plain.ended;
  assert.equal(code, 0, out + err);
  assert.equal(value(out, "pair_collision_count"), 0);
  assert.equal(value(out, "makespan_s"), value(plain.out, "makespan_s"));
  assert.ok(Math.abs(value(out, "min_separation_m") - value(plain.out, "min_separation_m")) < 1e-5);
});

test("in lockstep 8 vehicles go in NED where the plain run goes, to the bit", async () => {
  const plain = `${folder}/plain.mcap`, graph = `${folder}/graph.mcap`;
  assert.equal(await start("fairway", "run", "scenarios/cube20_8.yaml", "--out", plain).ended, 0);
  const { code, out, err } = await run("cube20_8", cube,
    ["--speed", 0, "--lockstep", "true", "--frame", "ned", "--record", graph, "--lockstep_timeout_s", 20],
    ["--lockstep", "true", "--frame", "ned"]);
  assert.equal(code, 0, out + err);
  console.log(out.split("\n")[0]);
  const [expected, found] = [await states(plain), await states(graph)];
  assert.ok(expected.length > 20000);
  assert.equal(found.findIndex((line, i) => line !== expected[i]), -1);
  assert.equal(found.length, expected.length);
});

for (const [scenario, vehicles, speed] of [["head_on", pair, 10], ["cube20_8", cube, 8]])
  test(`running free at ${speed} times real time, ${vehicles.length} vehicles reach their goals without a collision`, async () => {
    const { code, out, err } = await run(scenario, vehicles, ["--speed", speed], ["--use_sim_time", "true"]);
    assert.notEqual(code, 2, err);
    assert.equal(value(out, "pair_collision_count"), 0, out);
    assert.equal(value(out, "arrived_ratio"), 1, out);
    console.log(`${scenario} at ${speed}: least separation ${value(out, "min_separation_m")} m, makespan ${value(out, "makespan_s")} s`);
  });

test("a vehicle whose avoider is killed holds, and the other passes it safely", async () => {
  const states = () => watch.out.split("\n").slice(0, -1).map((line) => JSON.parse(line));
  const watch = start("foxglove_peer.mjs", "follow", 200, "/fairway/state");
  const { out } = await run("head_on", pair, ["--speed", 10], ["--use_sim_time", "true"], async (sim, [, killed]) => {
    await until(() => states().some(({ time_s: time }) => time > 30), 60, "the south bound is off the other's goal");
    killed.child.kill("SIGKILL");
    const before = states().length;
    await until(() => states().slice(before).some(({ vehicles: [north, south] }) => south.holding && !north.holding), 60,
      "the south bound alone holds");
    await until(() => states().at(-1).vehicles[0].phase === "arrived", 120, "the north bound arrives");
    sim.child.kill("SIGTERM");
  });
  await stop(watch);
  const { vehicles: [, south], collisions } = states().at(-1);
  assert.equal(south.holding, true);
  assert.equal(collisions, 0);
  assert.equal(out, "", "it was interrupted, for the dead vehicle never arrives");
});
