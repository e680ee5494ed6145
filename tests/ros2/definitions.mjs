// SPDX-License-Identifier: Apache-2.0
// The official definitions of ROS 2's messages (Humble), and our IDL, both as lists of members.
import { readFileSync, readdirSync } from "node:fs";
import { ros2humble } from "@foxglove/rosmsg-msgs-common";

// rmw_dds_common is not among the common definitions: its members as the design document of ROS 2's nodes and
// participants has them.
const more = {
  "rmw_dds_common/Gid": [{ name: "data", type: "uint8", isArray: true, arrayLength: 24 }],
  "rmw_dds_common/NodeEntitiesInfo": [
    { name: "node_namespace", type: "string", upperBound: 256 },
    { name: "node_name", type: "string", upperBound: 256 },
    { name: "reader_gid_seq", type: "rmw_dds_common/Gid", isArray: true, isComplex: true },
    { name: "writer_gid_seq", type: "rmw_dds_common/Gid", isArray: true, isComplex: true },
  ],
  "rmw_dds_common/ParticipantEntitiesInfo": [
    { name: "gid", type: "rmw_dds_common/Gid", isComplex: true },
    { name: "node_entities_info_seq", type: "rmw_dds_common/NodeEntitiesInfo", isArray: true, isComplex: true },
  ],
};

/// What has an independent definition.
export const isOfficial = (name) => ros2humble[name] !== undefined;

/// The members of "package/Name", without constants.
export function official(name) {
  const members = ros2humble[name]?.definitions ?? more[name];
  if (members === undefined) throw new Error(`no definition of ${name}`);
  return members.filter((member) => !member.isConstant);
}

/// The definition with all that it is made of, as the readers and writers of @foxglove want it.
export function complete(name) {
  const found = new Map();
  const visit = (one) => {
    if (found.has(one)) return;
    found.set(one, { name: one, definitions: official(one) });
    for (const member of official(one)) if (member.isComplex) visit(member.type);
  };
  visit(name);
  return [{ definitions: official(name) }, ...[...found.values()].filter((one) => one.name !== name)];
}

/// nav_msgs::msg::dds_::Odometry_ -> nav_msgs/Odometry
export const rosName = (ddsName) => ddsName.replace(/^(\w+)::msg::dds_::(\w+)_$/, "$1/$2");

const plain = {
  long: "int32", "unsigned long": "uint32", octet: "uint8", boolean: "bool", float: "float32", double: "float64",
  string: "string", "string<256>": "string",
};
// what the definitions have as a type of its own
const builtin = { "builtin_interfaces/Time": "time", "builtin_interfaces/Duration": "duration" };

/// Our IDL: { "package/Name": [{ type, name, isArray, arrayLength }] }.
export function ours(folder) {
  const messages = {};
  for (const file of readdirSync(folder).filter((one) => one.endsWith(".idl"))) {
    const text = readFileSync(`${folder}/${file}`, "utf8");
    const [, part] = text.match(/module (\w+) \{\s*module msg \{\s*module dds_ \{/);
    for (const [, name, body] of text.matchAll(/struct (\w+)_ \{([^}]*)\}/g))
      messages[`${part}/${name}`] = body.split(";").map((line) => line.trim()).filter((line) => line !== "").map(memberOf);
  }
  return messages;
}

function memberOf(line) {
  const [, full, name, length] = line.match(/^(.*\S)\s+(\w+)(?:\[(\d+)\])?$/);
  const element = full.match(/^sequence<(.*)>$/)?.[1];
  const type = element ?? full;
  const ros = plain[type] ?? rosName(type);
  return {
    type: builtin[ros] ?? ros, name, isArray: element !== undefined || length !== undefined,
    arrayLength: length === undefined ? undefined : Number(length),
  };
}
