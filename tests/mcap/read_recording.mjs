// SPDX-License-Identifier: Apache-2.0
//
// node read_recording.mjs RUN.mcap RUN.csv [TRACKS.csv ECHOES.csv]
//
// Reads a recording with the official MCAP reader and ROS 2 deserialisers, which share no code with
// fairway, and compares every value with the CSV exports: to the bit. Exits with 1 at the first that differs.

import assert from "node:assert/strict";
import { open, readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";

import { parse } from "@foxglove/rosmsg";
import { ros2jazzy } from "@foxglove/rosmsg-msgs-common";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import { McapIndexedReader } from "@mcap/core";
import { decompress } from "fzstd";

import { number, parseCsv } from "./csv.mjs";
import { byPerceiver, comparePerception } from "./perception.mjs";
import { compareSketches } from "./sketches.mjs";

const standardTypes = new Set(["nav_msgs/msg/Odometry", "sensor_msgs/msg/PointCloud2", "tf2_msgs/msg/TFMessage"]);

/** The definition embedded in the file and all it uses are the published ones, field by field. */
function checkDefinition(schema) {
  const official = (name) => {
    const found = ros2jazzy[name.replace("/msg/", "/")];
    assert.ok(found, `${name} is a published type`);
    return found.definitions;
  };
  const withoutUndefined = (value) => JSON.parse(JSON.stringify(value));
  const text = new TextDecoder().decode(schema.data);
  for (const { name, definitions } of parse(text, { ros2: true })) {
    const expected = withoutUndefined(official(name ?? schema.name));
    assert.deepEqual(withoutUndefined(definitions), expected, `fields of ${name ?? schema.name}`);
  }
}

/** Expected fields of an odometry message and a transform, from a row. */
const position = (row) => ({ x: number(row.x_m), y: number(row.y_m), z: number(row.z_m) });
const orientation = (row) => ({
  x: number(row.qx_ratio),
  y: number(row.qy_ratio),
  z: number(row.qz_ratio),
  w: number(row.qw_ratio),
});
const linear = (row) => ({ x: number(row.u_mps), y: number(row.v_mps), z: number(row.w_mps) });
const angular = (row) => ({ x: number(row.p_radps), y: number(row.q_radps), z: number(row.r_radps) });

function actuators(row) {
  const values = [];
  for (let i = 0; row[`actuator_${i}`]; ++i) values.push(number(row[`actuator_${i}`]));
  return values;
}

/** X, Y, Z, K, M, N; zeros where there is none. */
function wrench(row, prefix) {
  const names = ["force_x_n", "force_y_n", "force_z_n", "moment_k_nm", "moment_m_nm", "moment_n_nm"];
  return names.map((name) => number(row[prefix + name] || "0"));
}

/** A status message, from a row and the constants of its schema. */
function expectedStatus(row, constants) {
  return {
    tick: BigInt(row.tick),
    id: Number(row.id),
    phase: constants.get(`PHASE_${row.phase.toUpperCase()}`),
    mode: constants.get(`MODE_${row.mode.toUpperCase()}`),
    astern: row.astern === "true",
    has_heading: row.command_heading_rad !== "",
    has_wrench: row.command_force_x_n !== "",
    command_velocity_mps: [row.command_n_mps, row.command_e_mps, row.command_d_mps].map(number),
    command_heading_rad: row.command_heading_rad === "" ? 0 : number(row.command_heading_rad),
    command_wrench: wrench(row, "command_"),
    goal_m: [row.goal_n_m, row.goal_e_m, row.goal_d_m].map(number),
    goal_speed_mps: number(row.goal_speed_mps),
    power_w: number(row.power_w),
    wrench: wrench(row, ""),
    actuators: actuators(row),
  };
}

/**
 * Compares a recording with its CSV export, and with those of tracks and echoes where perception is in it;
 * returns what it has seen. Throws an AssertionError.
 */
export async function compare(recordingPath, csvPath, tracksPath, echoesPath) {
  const rowsOf = async (path) => (path ? parseCsv(await readFile(path, "utf8")) : undefined);
  const handle = await open(recordingPath);
  try {
    const reader = await McapIndexedReader.Initialize({
      readable: {
        size: async () => BigInt((await handle.stat()).size),
        read: async (offset, size) => {
          const bytes = new Uint8Array(Number(size));
          await handle.read(bytes, 0, bytes.length, Number(offset));
          return bytes;
        },
      },
      decompressHandlers: { zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))) },
    });
    return await compareWith(reader, await rowsOf(csvPath), await rowsOf(tracksPath), await rowsOf(echoesPath));
  } finally {
    await handle.close();
  }
}

async function compareWith(reader, csv, tracksCsv, echoesCsv) {
  assert.equal(reader.header.profile, "ros2");
  assert.match(reader.header.library, /^fairway /);

  // schemas, and a deserialiser for each channel from the text in the file
  const deserialisers = new Map();
  const constants = new Map();
  const keepConstants = ({ definitions }) => {
    for (const field of definitions) if (field.isConstant) constants.set(field.name, field.value);
  };
  for (const [id, channel] of reader.channelsById) {
    const schema = reader.schemasById.get(channel.schemaId);
    assert.equal(schema.encoding, "ros2msg");
    assert.equal(channel.messageEncoding, "cdr");
    assert.ok(channel.metadata.has("offered_qos_profiles"), "a key that the profile ros2 requires");
    if (standardTypes.has(schema.name)) checkDefinition(schema);
    else assert.match(schema.name, /^fairway_msgs\/msg\//);
    const definitions = parse(new TextDecoder().decode(schema.data), { ros2: true });
    definitions.filter(({ name }) => !name?.startsWith("sensor_msgs")).forEach(keepConstants);
    deserialisers.set(id, new MessageReader(definitions));
  }

  // what is said once
  const metadata = new Map();
  for await (const record of reader.readMetadata()) metadata.set(record.name, record.metadata);
  const run = metadata.get("fairway");
  const vehicles = JSON.parse(run.get("vehicles"));
  assert.equal(vehicles.length, Number(run.get("vehicle_count")));
  const attachments = [];
  for await (const attachment of reader.readAttachments()) attachments.push(attachment.name);
  assert.deepEqual(attachments, ["scenario.yaml"]);

  // rows by tick and vehicle
  const rows = new Map(csv.map((row) => [`${row.tick} ${row.vehicle}`, row]));
  assert.equal(rows.size, csv.length, "a row for each vehicle and tick");

  // all messages, decoded
  const frames = new Map(); // by log time
  const messages = [];
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const { topic } = reader.channelsById.get(message.channelId);
    const deserialiser = deserialisers.get(message.channelId);
    const value = deserialiser.readMessage(message.data);
    assert.ok(!deserialiser.lastReadHadTrailingBytes(), `${topic} is as long as its schema says`);
    assert.equal(message.publishTime, message.logTime);
    if (topic === "/fairway/frame") frames.set(message.logTime, value);
    messages.push({ topic, time: message.logTime, value });
  }
  const statistics = reader.statistics;
  assert.equal(Number(statistics.messageCount), messages.length);
  assert.equal(statistics.chunkCount, reader.chunkIndexes.length);
  assert.equal(frames.size, Number(metadata.get("fairway.end").get("frame_count")));

  // and compared
  const checkHeader = (header, time) => {
    assert.equal(BigInt(header.stamp.sec) * 1000000000n + BigInt(header.stamp.nanosec), time);
    assert.equal(header.frame_id, "world_ned");
  };
  const same = (actual, expected, what) => {
    // Object.is on every number, so that -0 and 0 differ
    assert.deepStrictEqual(Array.isArray(expected) ? Array.from(actual) : { ...actual }, expected, what);
  };
  const zeros = new Array(36).fill(0);
  const seen = { odometry: 0, status: 0, transforms: 0 };
  const words = new Set(); // by whom and when
  const byTopic = new Map(vehicles.map((v) => [v.topic, v]));
  for (const { topic, time, value } of messages) {
    const frame = frames.get(time);
    assert.ok(frame, `a frame at ${time} ns`);
    const what = `${topic} at tick ${frame.tick}`;
    const rowOf = (vehicle) => {
      const row = rows.get(`${frame.tick} ${vehicle.name}`);
      assert.ok(row, `a row for ${what}`);
      return row;
    };
    if (topic === "/fairway/frame") {
      checkHeader(value.header, time);
      assert.equal(BigInt(Math.round(value.time_s * 1e9)), time);
      assert.equal(typeof value.hash, "bigint");
      for (const vehicle of vehicles) assert.equal(number(rowOf(vehicle).time_s), value.time_s);
    } else if (topic === "/tf") {
      assert.equal(value.transforms.length, vehicles.length);
      value.transforms.forEach((t, i) => {
        const row = rowOf(vehicles[i]);
        checkHeader(t.header, time);
        assert.equal(t.child_frame_id, `${vehicles[i].topic.slice(1)}/base_link_fsd`);
        same(t.transform.translation, position(row), what);
        same(t.transform.rotation, orientation(row), what);
        ++seen.transforms;
      });
    } else if (topic === "/fairway/perception") {
      checkHeader(value.header, time);
      assert.equal(typeof value.hash, "bigint");
    } else if (topic === "/fairway/flights" || topic.endsWith("/sketch")) {
      checkHeader(value.header, time);
    } else if (topic === "/fairway/words") {
      checkHeader(value.header, time);
      assert.ok(value.from_index < vehicles.length && Object.is(value.sent_s, frame.time_s), what);
      assert.ok(value.bytes.length >= 1 && value.bytes.length <= 25, `${what}: ${value.bytes.length} bytes`);
      words.add(`${value.from_index} ${value.sent_s}`);
    } else if (!/\/(tracks|echoes)$/.test(topic)) {
      const [, vehicleTopic, kind] = topic.match(/^(.*)\/(odometry|status)$/);
      const row = rowOf(byTopic.get(vehicleTopic));
      checkHeader(value.header, time);
      if (kind === "odometry") {
        assert.equal(value.child_frame_id, `${vehicleTopic.slice(1)}/base_link_fsd`);
        same(value.pose.pose.position, position(row), what);
        same(value.pose.pose.orientation, orientation(row), what);
        same(value.twist.twist.linear, linear(row), what);
        same(value.twist.twist.angular, angular(row), what);
        same(value.pose.covariance, zeros, what);
        same(value.twist.covariance, zeros, what);
      } else {
        for (const [name, expected] of Object.entries(expectedStatus(row, constants))) {
          if (Array.isArray(expected)) same(value[name], expected, `${what}: ${name}`);
          else assert.ok(Object.is(value[name], expected), `${what}: ${name} is ${value[name]}, not ${expected}`);
        }
      }
      ++seen[kind];
    }
  }
  assert.deepEqual(seen, { odometry: csv.length, status: csv.length, transforms: csv.length });

  const perceives = run.get("perception") === "true";
  assert.equal(perceives, tracksCsv !== undefined, "the exports of tracks and echoes belong to perception");
  const perceived = perceives
    ? comparePerception(messages, frames, vehicles, byPerceiver(tracksCsv), byPerceiver(echoesCsv))
    : undefined;
  const drawn = run.get("sketches") === "true" ? compareSketches(messages, frames, vehicles, rows, constants) : undefined;
  return { frames: frames.size, vehicles: vehicles.length, rows: csv.length, words, perceived, drawn };
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [recording, csv, tracks, echoes] = process.argv.slice(2);
  if (!recording || !csv) {
    console.error("usage: node read_recording.mjs RUN.mcap RUN.csv [TRACKS.csv ECHOES.csv]");
    process.exit(2);
  }
  try {
    const { frames, vehicles, rows } = await compare(recording, csv, tracks, echoes);
    console.log(`${recording}: ${frames} frames of ${vehicles} vehicles, ${rows} rows, the same to the bit`);
  } catch (error) {
    console.error(`${recording}: ${error.message}`);
    process.exit(1);
  }
}
