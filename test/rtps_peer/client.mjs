// SPDX-License-Identifier: Apache-2.0
// A ROS 2 subscriber on an RTPS implementation of its own, in TypeScript: `node client.mjs DOMAIN SECONDS WANTED`.
// WANTED is JSON, by topic: {"type": "nav_msgs/Odometry", "reliable": true, "state": false, "count": 3}; `state`: transient
// local. It ends when it has decoded so many of each, and prints what it saw as JSON.
import { writeSync } from "node:fs";
import ros2 from "@foxglove/ros2";
import { parse } from "@foxglove/rosmsg";
import common from "@foxglove/rosmsg-msgs-common";
import serialization from "@foxglove/rosmsg2-serialization";
import rtps from "@foxglove/rtps";
import nodejs from "@foxglove/rtps/nodejs";

const [domain, seconds] = process.argv.slice(2, 4).map(Number);
const wanted = JSON.parse(process.argv[4]);
const said = { participants: [], topics: {}, nodes: [], messages: {}, undecoded: [] };
const forever = { sec: 0x7fffffff, nsec: 0xffffffff };

// rmw_dds_common is in no package of messages. Gids as in Humble: a reader without a type hash is taken for one of it.
const discoveryDefinition = `Gid gid
NodeEntitiesInfo[] node_entities_info_seq
===
MSG: rmw_dds_common/Gid
uint8[24] data
===
MSG: rmw_dds_common/NodeEntitiesInfo
string node_namespace
string node_name
Gid[] reader_gid_seq
Gid[] writer_gid_seq`;

/** The definition of a type with all that it is made of, its own first. */
function definitionsOf(type, known = new Map()) {
  const definition = common.ros2jazzy[type];
  if (definition === undefined) throw new Error(`${type} is no type of ROS 2's common interfaces`);
  known.set(type, definition);
  for (const field of definition.definitions) {
    if (field.isComplex && !known.has(field.type)) definitionsOf(field.type, known);
  }
  return [...known.values()];
}

const participant = new rtps.Participant({
  name: "typescript_peer",
  addresses: ["127.0.0.1"],
  domainId: domain,
  udpSocketCreate: nodejs.UdpSocketNode.Create,
});
const decoders = new Map(); // by the id of our reader

function subscribe(topicName, typeName, { reliable, state, depth }, onMessage, definitions) {
  const kind = reliable ? rtps.Reliability.Reliable : rtps.Reliability.BestEffort;
  const reader = participant.subscribe({
    topicName,
    typeName,
    durability: state ? rtps.Durability.TransientLocal : rtps.Durability.Volatile,
    reliability: { kind, maxBlockingTime: forever },
    history: { kind: rtps.HistoryKind.KeepLast, depth },
  });
  decoders.set(reader, { decoder: new serialization.MessageReader(definitions), topicName, onMessage });
}

participant.on("discoveredParticipant", ({ userData }) => said.participants.push(userData ?? ""));
participant.on("error", (error) => said.undecoded.push(String(error)));
participant.on("userData", ({ subscription, serializedData }) => {
  const { decoder, topicName, onMessage } = decoders.get(subscription.entityId);
  try {
    onMessage(decoder.readMessage(serializedData));
  } catch (error) {
    said.undecoded.push(`${topicName}: ${error}`);
  }
});

await participant.start();
subscribe("ros_discovery_info", "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_",
  { reliable: true, state: true, depth: 100 },
  (info) => {
    for (const { node_namespace, node_name } of info.node_entities_info_seq) {
      const name = `${node_namespace === "/" ? "" : node_namespace}/${node_name}`;
      if (!said.nodes.includes(name)) said.nodes.push(name);
    }
  },
  parse(discoveryDefinition, { ros2: true }));
for (const [topic, want] of Object.entries(wanted)) {
  said.messages[topic] = [];
  subscribe(ros2.rosTopicToDds(topic), ros2.rosTypeToDds(want.type.replace("/", "/msg/")), { ...want, depth: 10 },
    (message) => said.messages[topic].length < want.count && said.messages[topic].push(message),
    definitionsOf(want.type));
}

const hasAll = () =>
  said.nodes.length > 0 &&
  Object.entries(wanted).every(([topic, { count }]) => said.messages[topic].length >= count);
const plain = (_, value) =>
  typeof value === "bigint" ? Number(value)
    : ArrayBuffer.isView(value) && value.byteLength > 1000
      ? { bytes: value.byteLength, sum: value.reduce((sum, one) => (sum + one) % 65536, 0) }
      : ArrayBuffer.isView(value) ? Array.from(value) : value;

function finish(end) {
  for (const { topicName, typeName } of participant.topicWriters()) {
    const topic = ros2.ddsToRosTopic(topicName);
    if (topic?.kind === ros2.DdsTopicType.Topic) said.topics[topic.topic] = ros2.ddsToRosType(typeName);
  }
  writeSync(1, JSON.stringify({ ...said, end }, plain) + "\n"); // whole, though the process ends
  process.exit(0);
}
setInterval(() => hasAll() && finish("done"), 50);
setTimeout(() => finish("time"), seconds * 1000);
