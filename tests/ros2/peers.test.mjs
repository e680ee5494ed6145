// SPDX-License-Identifier: Apache-2.0
// Topics exchanged with two implementations of DDS that are not ours: Fast DDS, and an RTPS in TypeScript.
import assert from "node:assert/strict";
import test from "node:test";
import { start, stop, told, wait } from "./processes.mjs";

const eight = Array.from({ length: 8 }, (_, i) => `auv_${i}`);

test("no odometry is lost: 8 vehicles at 50 Hz for 20 s, to three kinds of subscribers at once", async () => {
  const ours = start("ros2_our_peer", "listen", 34, ...eight);
  const fast = start("ros2_fastdds_peer", "listen", 34, ...eight);
  const fox = start("foxglove_peer.mjs", "listen", 34, ...eight);
  await wait(1);
  const { sent, unsent } = await told(start("ros2_our_peer", "talk", 20, 50, 3, ...eight));
  assert.equal(unsent, 0);
  assert.equal(sent, 1000);
  for (const [name, peer] of Object.entries({ ours, fast, fox })) {
    const counts = await told(peer);
    assert.deepEqual(Object.keys(counts).sort(), eight, name);
    for (const vehicle of eight) {
      const { received, lost, last } = counts[vehicle];
      assert.deepEqual({ received, lost, last }, { received: sent, lost: 0, last: sent - 1 }, `${name} of ${vehicle}`);
    }
  }
});

test("what Fast DDS and the RTPS in TypeScript send, we receive, all of it", async () => {
  const ours = start("ros2_our_peer", "listen", 16, "fast_a", "fast_b", "fox_a", "fox_b");
  await wait(1);
  const fast = start("ros2_fastdds_peer", "talk", 5, 50, "fast_a", "fast_b");
  const fox = start("foxglove_peer.mjs", "talk", 5, 50, "fox_a", "fox_b");
  await told(fast);
  const { sent } = await told(fox);
  const counts = await told(ours);
  for (const vehicle of ["fast_a", "fast_b"]) {
    // its first messages went out before the two had found each other
    assert.ok(counts[vehicle].received > 100, JSON.stringify(counts));
    assert.equal(counts[vehicle].lost, 0, JSON.stringify(counts));
  }
  for (const vehicle of ["fox_a", "fox_b"]) {
    const { received, lost } = counts[vehicle];
    assert.deepEqual({ received, lost }, { received: sent, lost: 0 });
  }
});

test("a vehicle of the simulator goes where Fast DDS tells it to, another where the RTPS in TypeScript does", async () => {
  const sim = start("fairway_sim_ros2", "--scenario", "scenarios/head_on.yaml", "--speed", 4);
  await wait(1);
  const [north, south] = await Promise.all([told(start("ros2_fastdds_peer", "steer", 6, "north_bound")),
    told(start("foxglove_peer.mjs", "steer", 6, "south_bound"))]);
  await stop(sim);
  for (const peer of [north, south]) {
    assert.ok(peer.heard > 100, JSON.stringify(peer));
    assert.ok(peer.moved_m > 3 && peer.moved_m < 13, JSON.stringify(peer));
  }
});

test("nobody's vehicle stays where it is", async () => {
  const sim = start("fairway_sim_ros2", "--scenario", "scenarios/head_on.yaml", "--speed", 4);
  await wait(1);
  const peer = await told(start("ros2_fastdds_peer", "steer", 3, "nobody"));
  const { words } = await told(start("foxglove_peer.mjs", "words", 2, "/fairway/state"));
  await stop(sim);
  assert.equal(peer.heard, 0);
  assert.deepEqual(JSON.parse(words).vehicles.map(({ holding }) => holding), [true, true]);
});

test("an avoider takes a vehicle that Fast DDS is to its goal", async () => {
  const avoider = start("fairway_avoider_ros2", "--vehicle", "auv", "--algorithm", "orca3d", "--max_speed_mps", 0.5);
  const peer = await told(start("ros2_fastdds_peer", "be", 14, "auv", 3, 2, -1));
  await stop(avoider);
  assert.ok(peer.heard > 150, JSON.stringify(peer));
  assert.ok(peer.moved_m > 2 && peer.from_goal_m < 1.2, JSON.stringify(peer));
});

test("an avoider that only advises commands nothing", async () => {
  const avoider = start("fairway_avoider_ros2", "--vehicle", "auv", "--algorithm", "orca3d",
    "--ros-args", "-p", "advisory:=true", "-p", "max_speed_mps:=0.5");
  const peer = await told(start("ros2_fastdds_peer", "be", 5, "auv", 3, 2, -1));
  await stop(avoider);
  assert.deepEqual({ heard: peer.heard, moved_m: peer.moved_m }, { heard: 0, moved_m: 0 });
});

test("the graph knows our nodes by name, with all their topics", async () => {
  const sim = start("fairway_sim_ros2", "--scenario", "scenarios/head_on.yaml");
  const avoider = start("fairway_avoider_ros2", "--scenario", "scenarios/head_on.yaml", "--vehicle", "north_bound",
    "--ros-args", "-r", "__node:=pilot", "--log-level", "info");
  await wait(1);
  const nodes = await told(start("foxglove_peer.mjs", "nodes", 3));
  await stop(sim, avoider);
  // 3 of the fleet and a command each, and clock, tf, markers, state, and 3 of each vehicle; the pilot has two for a goal
  assert.deepEqual(nodes, { "/fairway_sim_ros2": { reads: 5, writes: 10 }, "/north_bound/pilot": { reads: 9, writes: 4 } });
});

test("what is wrong is said in one line, with exit code 2", async () => {
  const cases = [
    [["fairway_sim_ros2"], /^fairway_sim_ros2: scenario: expected the file/],
    [["fairway_sim_ros2", "--scenario", "scenarios/head_on.yaml", "--spedd", 2], /spedd: unknown setting; did you mean speed\?/],
    [["fairway_sim_ros2", "--scenario", "scenarios/head_on.yaml", "--speed", "fast"], /speed: is "fast"; expected a number/],
    [["fairway_sim_ros2", "--scenario"], /--scenario: expected a value/],
    [["fairway_avoider_ros2", "--vehicle", "auv", "--algorithm", "orca4d"], /orca4d.*orca3d/],
    [["fairway_avoider_ros2", "--vehicle", "auv", "--ros-args", "-p", "frame:=xyz"], /frame: is "xyz"; expected one of enu, ned/],
    [["fairway_avoider_ros2", "--scenario", "scenarios/head_on.yaml", "--vehicle", "north_bond"], /north_bond.*north_bound/],
  ];
  for (const [[program, ...words], expected] of cases) {
    const said = start(program, ...words);
    assert.equal(await said.ended, 2, words.join(" "));
    assert.match(said.err, expected);
    assert.equal(said.err.trim().split("\n").length, 1, said.err);
  }
});
