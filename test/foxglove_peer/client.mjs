// SPDX-License-Identifier: Apache-2.0
// What the authors' client of the Foxglove WebSocket protocol sees of a server: `node client.mjs PORT SECONDS`.
// It subscribes to all topics and decodes each message by its schema, publishes a goal, sets a parameter, calls a
// service, and prints what came of it as JSON.
import { parse } from "@foxglove/rosmsg";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";
import protocol from "@foxglove/ws-protocol";
import WebSocket from "ws";

const { FoxgloveClient } = protocol;
const [port, seconds] = process.argv.slice(2).map(Number);
const socket = new WebSocket(`ws://127.0.0.1:${port}/`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]);
const client = new FoxgloveClient({ ws: socket });
const said = { topics: {}, undecoded: [], statuses: [], parameters: {}, times: 0, protocol: "", graph: 0 };
const channels = new Map(); // by subscription
const waiting = new Map(); // parameterValues, by id

client.on("error", (error) => finish(String(error)));
client.on("close", () => finish("closed"));
client.on("serverInfo", (info) => {
  said.server = info;
  said.protocol = socket.protocol;
});
client.on("status", (status) => said.statuses.push(status.message));
client.on("time", () => ++said.times);
client.on("connectionGraphUpdate", (update) => (said.graph += update.publishedTopics.length));
client.on("advertise", (added) => {
  for (const channel of added) {
    const reader = new MessageReader(parse(channel.schema, { ros2: true }));
    channels.set(client.subscribe(channel.id), { channel, reader });
    said.topics[channel.topic] ??= 0;
  }
});
client.on("message", ({ subscriptionId, data }) => {
  const { channel, reader } = channels.get(subscriptionId);
  try {
    const message = reader.readMessage(data);
    if (channel.topic === "/location") said.location = message.pose.pose.position;
    ++said.topics[channel.topic];
  } catch (error) {
    said.undecoded.push(`${channel.topic}: ${error}`);
  }
});
client.on("parameterValues", ({ parameters, id }) => {
  for (const { name, value } of parameters) said.parameters[name] = value;
  waiting.get(id)?.(parameters);
});
client.on("serviceCallResponse", ({ encoding, data }) => {
  said.service = encoding === "json" ? JSON.parse(new TextDecoder().decode(data)) : encoding;
});
client.on("serviceCallFailure", ({ message }) => (said.service = message));

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const answered = (id) => new Promise((resolve) => waiting.set(id, resolve));

function finish(why) {
  said.end = why;
  console.log(JSON.stringify(said, (_, value) => (typeof value === "bigint" ? Number(value) : value)));
  process.exit(0);
}

/**
 * A goal in CDR, by the schema that the server has told for the topic, and one in JSON; more than once, since readers
 * need a moment to find the server's new writer.
 */
async function publishGoals() {
  const schema = await schemaOf("/goal");
  const writer = new MessageWriter(parse(schema, { ros2: true }));
  const cdr = client.advertise({ topic: "/goal", encoding: "cdr", schemaName: "tocsin_msgs/msg/Goal" });
  const json = client.advertise({ topic: "/goal", encoding: "json", schemaName: "tocsin_msgs/msg/Goal" });
  for (let i = 0; i < 5; ++i) {
    client.sendMessage(cdr, writer.writeMessage({ id: 900001 }));
    client.sendMessage(json, new TextEncoder().encode(JSON.stringify({ id: 900002 })));
    await pause(400);
  }
}

async function schemaOf(topic) {
  for (;;) {
    for (const { channel } of channels.values()) if (channel.topic === topic) return channel.schema;
    await pause(50);
  }
}

async function useParameters() {
  const all = answered("all");
  client.getParameters([], "all");
  await all;
  const set = answered("set");
  client.setParameters([{ name: "/talker.text", value: "told by a page" }], "set");
  await set;
}

async function callService() {
  const services = [];
  client.on("advertiseServices", (added) => services.push(...added));
  for (let i = 0; i < 100; ++i) {
    const service = services.find(({ name }) => name === "/talker/list_parameters");
    if (service) {
      const data = new TextEncoder().encode("{}");
      return client.sendServiceCallRequest({ serviceId: service.id, callId: 7, encoding: "json", data });
    }
    await pause(100);
  }
}

client.on("open", async () => {
  said.page = await fetch(`http://127.0.0.1:${port}/`).then((answer) => answer.text());
  const service = callService();
  client.subscribeConnectionGraph();
  await publishGoals();
  await useParameters();
  await service;
  await pause(seconds * 1000);
  finish("done");
});
setTimeout(() => finish("time is over"), 60000);
