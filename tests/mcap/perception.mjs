// SPDX-License-Identifier: Apache-2.0

import assert from "node:assert/strict";

import { number } from "./csv.mjs";
import { HeldMessages } from "./held_messages.mjs";

/** The tracks of a message, from rows. */
function expectedTrack(row) {
  const vector = (prefix, unit) => ["n", "e", "d"].map((axis) => number(row[`${prefix}_${axis}_${unit}`] || "0"));
  const covariance = (prefix, unit) =>
    ["nn", "ne", "nd", "en", "ee", "ed", "dn", "de", "dd"].map((axes) => number(row[`${prefix}_${axes}_${unit}`]));
  return {
    id: Number(row.id),
    priority: Number(row.priority),
    reacts: row.reacts === "true",
    has_destination: row.destination_n_m !== "",
    position_m: [row.x_m, row.y_m, row.z_m].map(number),
    velocity_mps: vector("velocity", "mps"),
    yaw_rad: number(row.yaw_rad),
    radius_m: number(row.radius_m),
    age_s: number(row.age_s),
    destination_m: vector("destination", "m"),
    position_covariance_m2: covariance("position_covariance", "m2"),
    velocity_covariance_m2ps2: covariance("velocity_covariance", "m2ps2"),
  };
}

/** The points of a cloud, by the fields that it says it has. */
function pointsOf(cloud) {
  const view = new DataView(cloud.data.buffer, cloud.data.byteOffset, cloud.data.byteLength);
  const read = { 7: (at) => view.getFloat32(at, true), 8: (at) => view.getFloat64(at, true) };
  assert.equal(cloud.data.length, cloud.row_step * cloud.height);
  assert.equal(cloud.row_step, cloud.point_step * cloud.width);
  return Array.from({ length: cloud.width }, (_, i) =>
    Object.fromEntries(cloud.fields.map((f) => [f.name, read[f.datatype](i * cloud.point_step + f.offset)])),
  );
}

/** A point of a cloud, from a row. */
function expectedPoint(row) {
  const [range_m, bearing_rad] = [number(row.range_m), number(row.bearing_rad)];
  const [x, y] = [Math.cos, Math.sin].map((part) => Math.fround(range_m * part(bearing_rad)));
  return { x, y, z: 0, range_m, bearing_rad };
}

/** Rows of what was perceived, by tick and vehicle. */
export function byPerceiver(csv) {
  const rows = new Map();
  for (const row of csv) {
    const key = `${row.tick} ${row.vehicle}`;
    if (!rows.has(key)) rows.set(key, []);
    rows.get(key).push(row);
  }
  return rows;
}

/**
 * What was perceived against its export. A message holds until the next, so every frame is compared with
 * the last one. Returns how many tracks and echoes it has seen.
 */
export function comparePerception(messages, frames, vehicles, trackRows, echoRows) {
  const seen = { tracks: 0, echoes: 0 };
  const held = new HeldMessages(messages, (topic) => /\/(tracks|echoes)$/.test(topic));
  const marks = new Map(
    messages.filter(({ topic }) => topic === "/fairway/perception").map(({ time, value }) => [time, value]),
  );
  for (const [time, frame] of frames) {
    assert.equal(marks.get(time).tick, frame.tick);
    held.goTo(time);
    for (const { name, topic } of vehicles) {
      const key = `${frame.tick} ${name}`;
      const tracks = held.of(`${topic}/tracks`).tracks;
      const expected = (trackRows.get(key) ?? []).map(expectedTrack);
      assert.equal(tracks.length, expected.length, `tracks of ${key}`);
      expected.forEach((track, i) => {
        for (const [field, value] of Object.entries(track)) {
          const actual = Array.isArray(value) ? Array.from(tracks[i][field]) : tracks[i][field];
          assert.deepStrictEqual(actual, value, `${key} tracks[${i}].${field}`);
        }
      });
      const cloud = held.of(`${topic}/echoes`);
      assert.equal(cloud.header.frame_id, `${topic.slice(1)}/base_link_fsd`);
      assert.deepStrictEqual(pointsOf(cloud), (echoRows.get(key) ?? []).map(expectedPoint), `echoes of ${key}`);
      seen.tracks += tracks.length;
      seen.echoes += cloud.width;
    }
  }
  held.end();
  return { ...seen, messages: held.count };
}
