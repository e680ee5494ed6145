// SPDX-License-Identifier: Apache-2.0

import assert from "node:assert/strict";

import { number } from "./csv.mjs";
import { HeldMessages } from "./held_messages.mjs";

/** How many points a stroke of each kind has. */
const pointsOfKind = {
  VELOCITY: (n) => n === 1,
  HALF_SPACE: (n) => n === 2,
  REGION: (n) => n > 2,
  PATH: (n) => n > 1,
  TREE: (n) => n % 2 === 0,
  SPHERE: (n) => n === 1,
  IMAGE: (n) => n === 0,
};

/** A stroke makes sense by itself. */
function checkStroke(stroke, kinds, what) {
  const kind = kinds.get(stroke.kind);
  assert.ok(kind, `${what}: a kind of the schema, not ${stroke.kind}`);
  assert.notEqual(stroke.meaning, "", what);
  assert.ok(pointsOfKind[kind](stroke.points.length), `${what}: ${stroke.points.length} points of a ${kind}`);
  for (const { x, y, z } of stroke.points) assert.ok([x, y, z].every(Number.isFinite), what);
  assert.equal(stroke.rgb.length, 3 * stroke.side_count ** 2, what);
}

/**
 * What was drawn against the commands: where a method drew what it chose, that was commanded, to the bit. A message
 * holds until the next. Returns how many strokes, choices and messages it has seen.
 */
export function compareSketches(messages, frames, vehicles, rows, constants) {
  const kinds = new Map([...constants].filter(([name]) => name.startsWith("KIND_")).map(([name, n]) => [n, name.slice(5)]));
  assert.deepEqual([...kinds.values()].sort(), Object.keys(pointsOfKind).sort());
  const seen = { strokes: 0, choices: 0, flights: 0 };
  const held = new HeldMessages(messages, (topic) => topic === "/fairway/flights" || topic.endsWith("/sketch"));
  for (const [time, frame] of frames) {
    held.goTo(time);
    for (const flight of held.of("/fairway/flights").flights) {
      assert.ok(flight.from_index < vehicles.length && flight.to_index < vehicles.length);
      assert.ok(flight.sent_s <= flight.begins_s && flight.begins_s <= flight.arrives_s);
      ++seen.flights;
    }
    for (const { name, topic } of vehicles) {
      const what = `sketch of ${name} at tick ${frame.tick}`;
      const row = rows.get(`${frame.tick} ${name}`);
      for (const stroke of held.of(`${topic}/sketch`).strokes) {
        checkStroke(stroke, kinds, what);
        ++seen.strokes;
        if (stroke.meaning !== "chosen") continue;
        const [{ x, y, z }] = stroke.points;
        const command = [row.command_n_mps, row.command_e_mps, row.command_d_mps].map(number);
        // what is chosen at the limit of speed may be beyond it by its last place, and is then scaled
        const error = Math.hypot(x - command[0], y - command[1], z - command[2]);
        assert.ok(error <= 1e-15, `${what}: chosen and commanded are ${error} m/s apart`);
        ++seen.choices;
      }
    }
  }
  held.end();
  return { ...seen, messages: held.count };
}
