// SPDX-License-Identifier: Apache-2.0
// Our messages against ROS 2's official definitions, member by member and byte by byte, both ways.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import test from "node:test";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";
import { complete, isOfficial, official, ours, rosName } from "./definitions.mjs";

const samples = process.env.ROS2_SAMPLES;
const idl = ours(new URL("../../ros/ros2/idl", import.meta.url).pathname);
const lines = (text) => text.trim().split("\n").map((line) => JSON.parse(line));

/// The bytes without the padding at the end, whose length the second option byte of the header holds: a
/// matter of the protocol that carries them, not of the message.
function unpadded(hex) {
  const bytes = Buffer.from(hex, "hex");
  const padding = bytes[3] & 3;
  assert.deepEqual([...bytes.subarray(bytes.length - padding)], new Array(padding).fill(0));
  bytes[3] = 0;
  return bytes.subarray(0, bytes.length - padding);
}

/// A value as our program tells it: plain lists, numbers that JSON lacks as texts, `nanosec`.
function plain(value) {
  if (typeof value === "number") return Number.isFinite(value) ? value : String(value);
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return Array.from(value, plain);
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key === "nsec" ? "nanosec" : key, plain(one)]));
}

/// The other way, for the writer of another.
function rich(value, key) {
  if (value === "NaN" || value === "Infinity" || value === "-Infinity") return Number(value);
  if (Array.isArray(value)) return value.map((one) => rich(one));
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).flatMap(([name, one]) =>
    name === "nanosec" ? [["nanosec", one], ["nsec", one]] : [[name, rich(one, name)]]));
}

/// The writer of another counts the letters of a text where CDR counts its bytes (@foxglove/cdr 3.5), so it can
/// only be asked for texts where these are the same; its reader has no such limit.
const canBeWritten = (value) => /^[\x00-\x7f]*$/.test(JSON.stringify(value));

test("every message has the members of its official definition, in order", () => {
  let compared = 0;
  for (const [name, members] of Object.entries(idl)) {
    const expected = official(name).map(({ type, name: member, isArray, arrayLength }) => ({
      type, name: member, isArray: isArray ?? false, arrayLength: arrayLength ?? undefined }));
    assert.deepEqual(members, expected, name);
    compared += isOfficial(name) ? 1 : 0;
  }
  assert.equal(compared, 32);
  assert.deepEqual(Object.keys(idl).filter((name) => !isOfficial(name)).map((name) => name.split("/")[0]),
    new Array(3).fill("rmw_dds_common"));
});

const seeds = [1, 20260, 4294967291];
for (const seed of seeds) {
  test(`what Cyclone writes is read with the official definitions, and written again the same, seed ${seed}`, () => {
    const written = lines(execFileSync(samples, ["write", String(seed), "20"], { encoding: "utf8", maxBuffer: 1 << 28 }));
    assert.equal(written.length, 20 * Object.keys(idl).length);
    for (const { type, bytes, value } of written) {
      const name = rosName(type);
      const ours = unpadded(bytes);
      const read = new MessageReader(complete(name)).readMessage(ours);
      assert.deepEqual(plain(read), value, name);
      if (!canBeWritten(value)) continue;
      assert.equal(Buffer.from(new MessageWriter(complete(name)).writeMessage(rich(value))).toString("hex"), ours.toString("hex"), name);
    }
  });

  test(`what another writes is read by Cyclone, and written again the same, seed ${seed}`, () => {
    const values = lines(execFileSync(samples, ["write", String(seed + 1), "20"], { encoding: "utf8", maxBuffer: 1 << 28 }));
    const sent = values.filter(({ value }) => canBeWritten(value)).map(({ type, value }) =>
      ({ type, value, bytes: Buffer.from(new MessageWriter(complete(rosName(type))).writeMessage(rich(value))).toString("hex") }));
    const input = sent.map(({ type, bytes }) => `${type} ${bytes}\n`).join("");
    const back = lines(execFileSync(samples, ["read"], { input, encoding: "utf8", maxBuffer: 1 << 28 }));
    assert.equal(back.length, sent.length);
    assert.equal(new Set(sent.map(({ type }) => type)).size, Object.keys(idl).length);
    back.forEach((one, i) => {
      assert.equal(one.type, sent[i].type);
      assert.deepEqual(one.value, sent[i].value, one.type);
      assert.equal(unpadded(one.bytes).toString("hex"), sent[i].bytes, one.type);
    });
  });
}

test("a swapped member is noticed", () => {
  const { value, bytes } = lines(execFileSync(samples, ["write", "5", "1"], { encoding: "utf8" }))
    .find((one) => one.type === "geometry_msgs::msg::dds_::Quaternion_");
  const read = plain(new MessageReader(complete("geometry_msgs/Quaternion")).readMessage(unpadded(bytes)));
  assert.notDeepEqual({ ...read, x: read.w, w: read.x }, value);
});
