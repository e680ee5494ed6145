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

const standardTypes = new Set(["nav_msgs/msg/Odometry", "sensor_msgs/msg/PointCloud2", "tf2_msgs/msg/TFMessage"]);

/** Rows of a CSV file (RFC 4180) as objects by column name. */
function parseCsv(text) {
  const rows = [];
  let row = [];
  let field = "";
  let quoted = false;
  for (let i = 0; i < text.length; ++i) {
    const c = text[i];
    if (quoted) {
      if (c !== '"') field += c;
      else if (text[i + 1] === '"') field += text[++i];
      else quoted = false;
    } else if (c === '"') {
      quoted = true;
    } else if (c === "," || c === "\n") {
      row.push(field);
      field = "";
      if (c === "\n") {
        rows.push(row);
        row = [];
      }
    } else {
      field += c;
    }
  }
  const [columns, ...values] = rows;
  return values.map((fields) => Object.fromEntries(columns.map((name, i) => [name, fields[i]])));
}

/** A double as the CSV spells it. */
function number(text) {
  if (text === "inf") return Infinity;
  if (text === "-inf") return -Infinity;
  if (text === "nan") return NaN;
  assert.notEqual(text, "", "a number is missing");
  return Number(text);
}

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
function byPerceiver(csv) {
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
function comparePerception(messages, frames, vehicles, trackRows, echoRows) {
  const seen = { tracks: 0, echoes: 0, messages: 0 };
  const last = new Map(); // topic to message
  const next = messages.filter(({ topic }) => /\/(tracks|echoes)$/.test(topic));
  const marks = new Map(
    messages.filter(({ topic }) => topic === "/fairway/perception").map(({ time, value }) => [time, value]),
  );
  for (const [time, frame] of frames) {
    assert.equal(marks.get(time).tick, frame.tick);
    while (next.length > 0 && next[0].time === time) {
      const { topic, value } = next.shift();
      assert.equal(BigInt(value.header.stamp.sec) * 1000000000n + BigInt(value.header.stamp.nanosec), time);
      last.set(topic, value);
      ++seen.messages;
    }
    for (const { name, topic } of vehicles) {
      const key = `${frame.tick} ${name}`;
      const tracks = last.get(`${topic}/tracks`).tracks;
      const expected = (trackRows.get(key) ?? []).map(expectedTrack);
      assert.equal(tracks.length, expected.length, `tracks of ${key}`);
      expected.forEach((track, i) => {
        for (const [field, value] of Object.entries(track)) {
          const actual = Array.isArray(value) ? Array.from(tracks[i][field]) : tracks[i][field];
          assert.deepStrictEqual(actual, value, `${key} tracks[${i}].${field}`);
        }
      });
      const cloud = last.get(`${topic}/echoes`);
      assert.equal(cloud.header.frame_id, `${topic.slice(1)}/base_link_fsd`);
      assert.deepStrictEqual(pointsOf(cloud), (echoRows.get(key) ?? []).map(expectedPoint), `echoes of ${key}`);
      seen.tracks += tracks.length;
      seen.echoes += cloud.width;
    }
  }
  assert.equal(next.length, 0, "every message belongs to a frame");
  return seen;
}

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
function compareSketches(messages, frames, vehicles, rows, constants) {
  const kinds = new Map([...constants].filter(([name]) => name.startsWith("KIND_")).map(([name, n]) => [n, name.slice(5)]));
  assert.deepEqual([...kinds.values()].sort(), Object.keys(pointsOfKind).sort());
  const seen = { strokes: 0, choices: 0, flights: 0, messages: 0 };
  const last = new Map(); // topic to message
  const next = messages.filter(({ topic }) => topic === "/fairway/flights" || topic.endsWith("/sketch"));
  for (const [time, frame] of frames) {
    while (next.length > 0 && next[0].time === time) {
      const { topic, value } = next.shift();
      assert.equal(BigInt(value.header.stamp.sec) * 1000000000n + BigInt(value.header.stamp.nanosec), time);
      last.set(topic, value);
      ++seen.messages;
    }
    for (const flight of last.get("/fairway/flights").flights) {
      assert.ok(flight.from_index < vehicles.length && flight.to_index < vehicles.length);
      assert.ok(flight.sent_s <= flight.begins_s && flight.begins_s <= flight.arrives_s);
      ++seen.flights;
    }
    for (const { name, topic } of vehicles) {
      const what = `sketch of ${name} at tick ${frame.tick}`;
      const row = rows.get(`${frame.tick} ${name}`);
      for (const stroke of last.get(`${topic}/sketch`).strokes) {
        checkStroke(stroke, kinds, what);
        ++seen.strokes;
        if (stroke.meaning !== "chosen") continue;
        const [{ x, y, z }] = stroke.points;
        const command = [row.command_n_mps, row.command_e_mps, row.command_d_mps].map(number);
        assert.deepStrictEqual([x, y, z], command, `${what}: chosen and commanded`);
        ++seen.choices;
      }
    }
  }
  assert.equal(next.length, 0, "every message belongs to a frame");
  return seen;
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
  return { frames: frames.size, vehicles: vehicles.length, rows: csv.length, perceived, drawn };
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
