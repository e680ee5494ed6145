// SPDX-License-Identifier: Apache-2.0
// A peer that is not ours and not in C++: npm's @foxglove/ros2 and the RTPS of its @foxglove/rtps, on the
// loopback interface, in the domain of ROS_DOMAIN_ID.
//   foxglove_peer.mjs listen SECONDS VEHICLE...      counts the numbered odometry that comes
//   foxglove_peer.mjs talk SECONDS RATE_HZ VEHICLE...  sends numbered odometry
//   foxglove_peer.mjs words SECONDS TOPIC            the last text (std_msgs/String) of a topic
//   foxglove_peer.mjs follow SECONDS TOPIC           the same, and each text on a line of its own when it comes
//   foxglove_peer.mjs nodes SECONDS                  the nodes of the graph, with how many topics they read and write
//   foxglove_peer.mjs steer SECONDS VEHICLE          orders 0.5 m/s ahead, and says how far the vehicle moved
// Each prints a line of JSON at its end.
import ros2 from "@foxglove/ros2";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";
import rtps from "@foxglove/rtps";
import sockets from "@foxglove/rtps/nodejs";
import { complete } from "./definitions.mjs";

const { rosTopicToDds, rosTypeToDds } = ros2;
const { UdpSocketNode } = sockets;

const loopback = "127.0.0.1";
const forever = { sec: 0x7fffffff, nsec: 0xffffffff };
const reliable = { kind: rtps.Reliability.Reliable, maxBlockingTime: forever };
const last10 = { kind: rtps.HistoryKind.KeepLast, depth: 10 };
const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/// Multicast, too, stays on the loopback interface.
async function loopbackSocket(options) {
  const socket = await UdpSocketNode.Create(options);
  const bind = socket.bind.bind(socket), join = socket.addMembership.bind(socket);
  socket.bind = async (where) => {
    await bind(where);
    await socket.setMulticastInterface(loopback);
  };
  socket.addMembership = (group) => join(group, loopback);
  return socket;
}

class Peer {
  #writers = 0;
  #listeners = new Map();

  async start() {
    this.participant = new rtps.Participant({
      name: "foxglove_peer", addresses: [loopback], domainId: Number(process.env.ROS_DOMAIN_ID ?? 0),
      udpSocketCreate: loopbackSocket, tuning: { keepAliveMs: 2000 },
    });
    this.participant.on("error", (error) => console.error(String(error)));
    this.participant.on("userData", ({ subscription, serializedData }) => this.#listeners.get(subscription.topicName)?.(serializedData));
    await this.participant.start();
    // the library says once that it is there; who comes later learns of it by this
    this.timer = setInterval(() => void this.participant.broadcastParticipant(this.participant.attributes), 500);
  }

  async stop() {
    clearInterval(this.timer);
    await this.participant.shutdown();
  }

  /// RosNode.subscribe() asks for transient local publishers, which ROS 2's defaults are not: so the participant is
  /// asked itself.
  subscribe(topic, type, handle, durability = rtps.Durability.Volatile) {
    const reader = new MessageReader(complete(type));
    const topicName = topic.startsWith("/") ? rosTopicToDds(topic) : topic;
    this.#listeners.set(topicName, (bytes) => handle(reader.readMessage(bytes)));
    this.participant.subscribe({ topicName, typeName: rosTypeToDds(type.replace("/", "/msg/")),
      durability, reliability: reliable, history: last10 });
  }

  /// The library cannot publish. Its builtin topics can: this does with a topic of ours what they do.
  advertise(topic, type) {
    const { participant } = this;
    const { guidPrefix, protocolVersion, vendorId } = participant.attributes;
    const topicName = rosTopicToDds(topic), typeName = rosTypeToDds(type.replace("/", "/msg/"));
    const entityId = rtps.makeEntityId(++this.#writers + 1000, rtps.EntityKind.AppdefWriterNoKey);
    const guid = rtps.makeGuid(guidPrefix, entityId);
    const writer = new rtps.Writer({ guidPrefix, entityId, topicName, typeName, durability: rtps.Durability.Volatile,
      reliability: reliable, history: { kind: rtps.HistoryKind.KeepAll, depth: -1 }, protocolVersion, vendorId });
    participant._writers.set(entityId, writer);

    const announcer = participant._writers.get(rtps.EntityIdBuiltin.PublicationsWriter);
    const told = new rtps.Parameters();
    told.topicName(topicName), told.typeName(typeName), told.durability(rtps.Durability.Volatile), told.reliability(reliable);
    told.history(last10), told.protocolVersion(protocolVersion), told.vendorId(vendorId), told.endpointGuid(guid), told.finish();
    announcer.history.set({ timestamp: now(), kind: rtps.ChangeKind.Alive,
      writerGuid: rtps.makeGuid(guidPrefix, rtps.EntityIdBuiltin.PublicationsWriter),
      sequenceNumber: announcer.history.nextSequenceNum(), data: told.data, instanceHandle: guid });
    void participant.sendMetatrafficChanges(announcer);

    const message = new MessageWriter(complete(type));
    const isHeard = () => [...participant._participants.values()].some((other) =>
      [...other.remoteReaders.values()].some(({ attributes }) => attributes.topicName === topicName));
    const send = async (value) => {
      writer.history.set({ timestamp: now(), kind: rtps.ChangeKind.Alive, writerGuid: guid,
        sequenceNumber: writer.history.nextSequenceNum(), data: message.writeMessage(value), instanceHandle: undefined });
      for (const other of participant._participants.values())
        for (const reader of other.remoteReaders.values())
          if (reader.attributes.topicName === topicName && reader.attributes.typeName === typeName)
            await participant.sendChangesTo(reader, writer, other.attributes.defaultUnicastLocatorList);
    };
    return Object.assign(send, { isHeard });
  }
}

const now = () => ({ sec: Math.floor(Date.now() / 1000), nsec: (Date.now() % 1000) * 1e6 });

async function listen(seconds, vehicles) {
  const peer = new Peer();
  await peer.start();
  const numbers = Object.fromEntries(vehicles.map((vehicle) => [vehicle, new Set()]));
  for (const vehicle of vehicles)
    peer.subscribe(`/${vehicle}/odometry`, "nav_msgs/Odometry", (odometry) => numbers[vehicle].add(odometry.pose.covariance[0]));
  await wait(1000 * seconds);
  await peer.stop();
  return Object.fromEntries(Object.entries(numbers).map(([vehicle, seen]) => {
    const first = Math.min(...seen), last = Math.max(...seen);
    return [vehicle, { received: seen.size, lost: last - first + 1 - seen.size, last }];
  }));
}

async function talk(seconds, rate, vehicles) {
  const peer = new Peer();
  await peer.start();
  const sends = vehicles.map((vehicle) => peer.advertise(`/${vehicle}/odometry`, "nav_msgs/Odometry"));
  for (let i = 0; i < 100 && !sends.every(({ isHeard }) => isHeard()); ++i) await wait(100);
  await wait(500);  // they know of us a little later than we of them
  const start = performance.now();
  let sent = 0;
  for (; performance.now() - start < 1000 * seconds; ++sent) {
    const covariance = new Array(36).fill(0);
    covariance[0] = sent;
    await Promise.all(sends.map((send, i) => send({
      header: { stamp: { sec: sent, nanosec: 0 }, frame_id: "world" }, child_frame_id: vehicles[i], pose: { covariance } })));
    await wait(Math.max(0, start + (1000 * (sent + 1)) / rate - performance.now()));
  }
  await wait(500);
  await peer.stop();
  return { sent };
}

async function steer(seconds, vehicle) {
  const peer = new Peer();
  await peer.start();
  let heard = 0, first, last;
  peer.subscribe(`/${vehicle}/odometry`, "nav_msgs/Odometry", (odometry) => {
    if (heard++ === 0) first = odometry;
    last = odometry;
  });
  const order = peer.advertise(`/${vehicle}/velocity_command`, "geometry_msgs/TwistStamped");
  for (const start = performance.now(); performance.now() - start < 1000 * seconds; await wait(20))
    if (heard > 0) await order({ header: { stamp: last.header.stamp, frame_id: vehicle }, twist: { linear: { x: 0.5, y: 0, z: 0 } } });
  await peer.stop();
  const moved = heard === 0 ? 0 : Math.hypot(...["x", "y", "z"].map((axis) => last.pose.pose.position[axis] - first.pose.pose.position[axis]));
  return { heard, moved_m: moved };
}

async function words(seconds, topic, hear = () => {}) {
  const peer = new Peer();
  await peer.start();
  let last = null;
  peer.subscribe(topic, "std_msgs/String", ({ data }) => hear((last = data)));
  await wait(1000 * seconds);
  await peer.stop();
  return { words: last };
}

async function nodes(seconds) {
  const peer = new Peer();
  await peer.start();
  const found = {};
  peer.subscribe("ros_discovery_info", "rmw_dds_common/ParticipantEntitiesInfo", ({ node_entities_info_seq: infos }) => {
    for (const info of infos)
      found[`${info.node_namespace.replace(/\/$/, "")}/${info.node_name}`] =
        { reads: info.reader_gid_seq.length, writes: info.writer_gid_seq.length };
  }, rtps.Durability.TransientLocal);
  await wait(1000 * seconds);
  await peer.stop();
  return found;
}

const [what, seconds, ...rest] = process.argv.slice(2);
const jobs = { listen: () => listen(Number(seconds), rest), talk: () => talk(Number(seconds), Number(rest[0]), rest.slice(1)),
  steer: () => steer(Number(seconds), rest[0]), words: () => words(Number(seconds), rest[0]),
  follow: () => words(Number(seconds), rest[0], console.log), nodes: () => nodes(Number(seconds)) };
if (jobs[what] === undefined) {
  console.error("foxglove_peer: see the first lines of its source");
  process.exit(2);
}
console.log(JSON.stringify(await jobs[what]()));
process.exit(0);
