// SPDX-License-Identifier: Apache-2.0
// In place of operator_server, for tests and for work on the page: serves the page's files and plays
// a bag as if it happened now. Obeys the emergency stop and mission/command, and takes missions as mission_control does.
// usage: node stand_in_server.mjs --page FOLDER --bag FILE.mcap [--port 8765] [--from SECONDS] [--map FILE.yaml FILE.pgm]
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import { fileURLToPath } from "node:url";

import { parse } from "@foxglove/rosmsg";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";
import protocol from "@foxglove/ws-protocol";
import { McapIndexedReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";
import { WebSocketServer } from "ws";

const { FoxgloveServer, ServerCapability } = protocol;
const separator = `\n${"=".repeat(80)}\n`;
const gridText = [
  "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data",
  "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id",
  "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec",
  "MSG: nav_msgs/MapMetaData\nbuiltin_interfaces/Time map_load_time\nfloat32 resolution\nuint32 width\n" +
    "uint32 height\ngeometry_msgs/Pose origin",
  "MSG: geometry_msgs/Pose\ngeometry_msgs/Point position\ngeometry_msgs/Quaternion orientation",
  "MSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z",
  "MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w",
].join(separator);
const stampText = `${separator}MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec`;
const driverStateText = `builtin_interfaces/Time stamp\nstring driver\nstring asked_by\nuint32 refused${stampText}`;
const stopStateText = `builtin_interfaces/Time stamp\nstring asked\nstring vehicle\nstring[] stopped_by${stampText}`;
const publishedText = {
  "std_msgs/msg/Bool": "bool data",
  "std_msgs/msg/String": "string data",
  "geometry_msgs/msg/TwistStamped": [
    "std_msgs/Header header\ngeometry_msgs/Twist twist",
    "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id",
    "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec",
    "MSG: geometry_msgs/Twist\ngeometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular",
    "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z",
  ].join(separator),
  "tocsin_msgs/msg/DriverRequest": `builtin_interfaces/Time stamp\nstring name\nstring verb${stampText}`,
};
const uuidText = `MSG: unique_identifier_msgs/UUID\nuint8[16] uuid`;
const timeText = "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec";
const poseTexts = [
  "MSG: geometry_msgs/PoseStamped\nstd_msgs/Header header\ngeometry_msgs/Pose pose",
  "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id",
  timeText,
  "MSG: geometry_msgs/Pose\ngeometry_msgs/Point position\ngeometry_msgs/Quaternion orientation",
  "MSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z",
  "MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w",
];
const pathText = ["std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses", ...poseTexts].join(separator);
const goalText = "MSG: nav2_msgs/FollowWaypoints_Goal\nuint32 number_of_loops\nuint32 goal_index\ngeometry_msgs/PoseStamped[] poses";
const goalInfoText = "MSG: action_msgs/GoalInfo\nunique_identifier_msgs/UUID goal_id\nbuiltin_interfaces/Time stamp";
const goalId = "unique_identifier_msgs/UUID goal_id";
/** Of follow_waypoints, by the end of their names: request and response. */
const serviceTexts = {
  send_goal: [[`${goalId}\nnav2_msgs/FollowWaypoints_Goal goal`, uuidText, goalText, ...poseTexts], ["bool accepted\nbuiltin_interfaces/Time stamp", timeText]],
  get_result: [[goalId, uuidText], ["int8 status\nnav2_msgs/FollowWaypoints_Result result", "MSG: nav2_msgs/FollowWaypoints_Result\nstring error_msg"]],
  cancel_goal: [["action_msgs/GoalInfo goal_info", goalInfoText, uuidText, timeText],
    ["int8 return_code\naction_msgs/GoalInfo[] goals_canceling", goalInfoText, uuidText, timeText]],
};
/** Which it says itself, whatever the bag has. */
const ownTopics = ["/map", "/mission/path", "/teleop/driver", "/emergency_stop/state"];
const types = { ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".css": "text/css" };

/** All messages of a bag in order, and its channels by topic. */
async function readBag(file) {
  const bytes = fs.readFileSync(file);
  const reader = await McapIndexedReader.Initialize({
    readable: {
      size: async () => BigInt(bytes.length),
      read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
    },
    decompressHandlers: await loadDecompressHandlers(),
  });
  const channels = new Map();
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId);
    channels.set(channel.topic, {
      topic: channel.topic,
      encoding: "cdr",
      schemaName: schema.name,
      schemaEncoding: schema.encoding,
      schema: new TextDecoder().decode(schema.data),
    });
  }
  const messages = [];
  for await (const message of reader.readMessages()) {
    const { topic } = reader.channelsById.get(message.channelId);
    messages.push({ topic, at: Number(message.logTime / 1000n) / 1000, data: message.data });
  }
  return { channels, messages };
}

/** A map of map_server: the image's rows from above are the grid's from below. */
function readMap(image) {
  const bytes = fs.readFileSync(image);
  const head = /^P5\s+(?:#.*\n)*(\d+)\s+(\d+)\s+(\d+)\s/.exec(bytes.subarray(0, 200).toString("latin1"));
  const [width, height] = [Number(head[1]), Number(head[2])];
  const pixels = bytes.subarray(head[0].length);
  const data = new Int8Array(width * height);
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      const grey = pixels[(height - 1 - row) * width + column];
      data[row * width + column] = grey > 250 ? 0 : grey < 50 ? 100 : -1;
    }
  }
  return { width, height, data };
}

/** The message some seconds later: those that begin with a time have it moved. */
function moved(data, seconds, bagEnd) {
  if (seconds === 0 || data.length < 12) return data;
  const copy = Uint8Array.from(data);
  const view = new DataView(copy.buffer);
  const second = view.getInt32(4, true);
  if (Math.abs(second - bagEnd) < 3600) view.setInt32(4, second + seconds, true);
  return copy;
}

const stamp = () => ({ sec: Math.floor(Date.now() / 1000), nanosec: 0 });
const nowNs = () => BigInt(Date.now()) * 1_000_000n;

/** Starts it. `commands`: what clients have published, as { topic, at, message }. */
export async function startStandIn({ page, bag, port = 0, from = 0, map, trailS = 0, about = {} }) {
  const { channels, messages } = await readBag(bag);
  const [first, last] = [messages[0].at / 1000, messages.at(-1).at / 1000];
  const bags = [{ path: "gcs/bag/bag_0.mcap", bytes: fs.statSync(bag).size, begin_s: first, end_s: last },
    { path: "gcs/operator/bag/bag_0.mcap", bytes: 4096 }];
  const files = http.createServer((request, response) => {
    const name = new URL(request.url, "http://x").pathname.replace(/^\/$/, "/index.html");
    if (name.startsWith("/tables/")) return response.end("");
    if (name === "/bags") return response.end(JSON.stringify({ bags }));
    if (name === `/bags/${bags[0].path}`) return sendPart(bag, request, response);
    const file = path.join(page, path.normalize(name));
    if (!fs.existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, {
      "content-type": types[path.extname(file)] ?? "application/octet-stream",
      "content-security-policy":
        "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; connect-src 'self' ws: wss:; frame-ancestors 'none'",
    });
    fs.createReadStream(file).pipe(response);
    return undefined;
  });
  const server = new FoxgloveServer({
    name: "stand-in",
    capabilities: [ServerCapability.clientPublish, ServerCapability.services, ServerCapability.time],
    supportedEncodings: ["cdr"],
    metadata: { tocsin: "0.1.0", host: "gcs", ...about },
  });
  const ids = new Map();
  for (const channel of channels.values()) {
    if (!ownTopics.includes(channel.topic)) ids.set(channel.topic, server.addChannel(channel));
  }
  const writers = new Map();
  const addOwn = (topic, schemaName, schema) => {
    ids.set(topic, server.addChannel({ topic, encoding: "cdr", schemaName, schemaEncoding: "ros2msg", schema }));
    writers.set(topic, new MessageWriter(parse(schema, { ros2: true })));
  };
  addOwn("/map", "nav_msgs/msg/OccupancyGrid", gridText);
  addOwn("/teleop/driver", "tocsin_msgs/msg/DriverState", driverStateText);
  addOwn("/emergency_stop/state", "tocsin_msgs/msg/EmergencyStopState", stopStateText);
  addOwn("/mission/path", "nav_msgs/msg/Path", pathText);
  const ownLast = new Map();
  const sendOwn = (topic, message) => {
    const data = writers.get(topic).writeMessage(message);
    ownLast.set(topic, data);
    server.sendMessage(ids.get(topic), nowNs(), data);
  };
  const state = {
    ...{ stopped: false, paused: false, commands: [], position: 0 },
    /** The mission that was taken, its end, and why the next one is refused. */
    ...{ mission: undefined, missionState: "running", refusal: "" },
    ...{ silent: false, withoutImages: false, withoutVehicle: false },
  };
  const rewritten = (topic, data) => rewrite(topic, data, channels.get(topic), state);

  if (map) {
    const { width, height, data } = readMap(map.image);
    const origin = { position: { x: map.x, y: map.y, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } };
    const info = { map_load_time: stamp(), resolution: map.resolution, width, height, origin };
    sendOwn("/map", { header: { stamp: stamp(), frame_id: "map" }, info, data });
  }
  sendOwn("/emergency_stop/state", { stamp: stamp(), asked: "never", vehicle: "may_drive", stopped_by: [] });

  const missionAnswers = {
    send_goal: ({ goal }) => {
      if (state.refusal) return { accepted: false, stamp: stamp() };
      [state.mission, state.missionState, state.paused] = [goal.poses, "running", false];
      sendOwn("/mission/path", { header: { stamp: stamp(), frame_id: "map" }, poses: goal.poses });
      return { accepted: true, stamp: stamp() };
    },
    get_result: () => ({ status: 6, result: { error_msg: state.refusal } }),
    cancel_goal: ({ goal_info }) => {
      if (state.mission) state.missionState = "aborted";
      return { return_code: 0, goals_canceling: state.mission ? [goal_info] : [] };
    },
  };
  const services = new Map();
  for (const [name, texts] of Object.entries(serviceTexts)) {
    const [request, response] = texts.map((parts) => ({ encoding: "cdr", schemaName: name, schemaEncoding: "ros2msg", schema: parts.join(separator) }));
    services.set(server.addService({ name: `/follow_waypoints/_action/${name}`, type: name, request, response }), { name, request, response });
  }
  server.on("serviceCallRequest", ({ serviceId, callId, data }, client) => {
    const { name, request, response } = services.get(serviceId);
    const message = new MessageReader(parse(request.schema, { ros2: true })).readMessage(data);
    state.commands.push({ topic: name, at: Date.now(), message });
    const answer = new MessageWriter(parse(response.schema, { ros2: true })).writeMessage(missionAnswers[name](message));
    server.sendServiceCallResponse({ serviceId, callId, encoding: "cdr", data: answer }, client);
  });

  const longTrail = trailOf(trailS, channels.get("/location"));
  const begin = messages[0].at + from * 1000;
  const started = Date.now();
  const bagNow = () => begin + Date.now() - started;
  // After its end the bag's last seconds come again and again: a slow computer's tests take longer.
  const lapS = 10;
  const lapBegin = messages.findIndex(({ at }) => at > (last - lapS) * 1000);
  let laps = Math.max(0, Math.ceil((begin / 1000 - last) / lapS));
  state.position = laps > 0 ? lapBegin : messages.findIndex(({ at }) => at >= begin);

  server.on("subscribe", (id) => {
    const topic = [...ids].find(([, one]) => one === id)[0];
    const own = ownLast.get(topic);
    if (own) server.sendMessage(id, nowNs(), own);
    asked.add(topic);
    clearTimeout(history);
    history = setTimeout(tellHistory, 200);
  });
  // What happened before is told at once and in order, so that pictures of a later time can be made.
  const asked = new Set();
  let history;
  const tellHistory = () => {
    if (asked.has("/location")) for (const data of longTrail) server.sendMessage(ids.get("/location"), nowNs(), data);
    for (const { topic, data } of messages.slice(0, state.position)) {
      if (!asked.has(topic) || topic.includes("image")) continue;
      server.sendMessage(ids.get(topic), nowNs(), rewritten(topic, data));
    }
    asked.clear();
  };
  server.on("message", ({ channel, data }) => {
    const schema = publishedText[channel.schemaName];
    const message = schema ? new MessageReader(parse(schema, { ros2: true })).readMessage(data) : undefined;
    state.commands.push({ topic: channel.topic, at: Date.now(), message });
    if (channel.topic === "/emergency_stop/request" && !state.silent) {
      state.stopped = message.data;
      setTimeout(() => {
        const vehicle = state.stopped ? "stands" : "may_drive";
        sendOwn("/emergency_stop/state", {
          ...{ stamp: stamp(), asked: state.stopped ? "on" : "off", vehicle },
          stopped_by: state.stopped ? ["station"] : [],
        });
        for (const one of messages.filter(({ topic }) => topic === "/safety_status").slice(0, 1)) {
          server.sendMessage(ids.get(one.topic), nowNs(), rewritten(one.topic, one.data));
        }
      }, 120);
    }
    if (channel.topic === "/mission/command") state.paused = message.data === "pause";
  });

  const sockets = new WebSocketServer({ server: files, handleProtocols: (names) => server.handleProtocols(names) });
  sockets.on("connection", (socket, request) => server.handleConnection(socket, request.socket.remoteAddress));
  await new Promise((resolve) => files.listen(port, "127.0.0.1", resolve));

  const timer = setInterval(() => {
    if (state.silent) return;
    server.broadcastTime(nowNs());
    while (messages[state.position].at + laps * lapS * 1000 <= bagNow()) {
      const { topic, data } = messages[state.position++];
      const later = moved(rewritten(topic, data), laps * lapS, last);
      if (state.position === messages.length) {
        state.position = lapBegin;
        ++laps;
      }
      if (state.withoutImages && topic.includes("image")) continue;
      if (state.withoutVehicle && topic !== "/mission_status") continue;
      server.sendMessage(ids.get(topic), nowNs(), later);
    }
  }, 20);
  const close = () => {
    clearInterval(timer);
    for (const socket of sockets.clients) socket.terminate();
    files.close();
  };
  const sayDriver = (driver, askedBy = "") =>
    sendOwn("/teleop/driver", { stamp: stamp(), driver, asked_by: askedBy, refused: 0 });
  const playedS = () => (bagNow() - messages[0].at) / 1000;
  return { port: files.address().port, state, close, sayDriver, playedS };
}

/** The part of a file that a request names. */
function sendPart(file, request, response) {
  const [, start, end] = /bytes=(\d+)-(\d+)/.exec(request.headers.range).map(Number);
  response.writeHead(206, { "content-range": `bytes ${start}-${end}/${fs.statSync(file).size}` });
  return fs.createReadStream(file, { start, end }).pipe(response);
}

/** So many seconds of a vehicle that drives round and round, ten places a second. */
function trailOf(seconds, channel) {
  const writer = new MessageWriter(parse(channel.schema, { ros2: true }));
  return Array.from({ length: seconds * 10 }, (_, index) => {
    const angle = index * 0.02;
    const position = { x: 3 + 2.5 * Math.cos(angle) + 0.5 * Math.cos(angle * 0.13), y: -1 + 1.5 * Math.sin(angle * 1.01), z: 0 };
    const pose = { position, orientation: { x: 0, y: 0, z: 0, w: 1 } };
    return writer.writeMessage({ header: { stamp: { sec: 0, nanosec: 0 }, frame_id: "map" }, pose: { pose, covariance: new Float64Array(36) } });
  });
}

/** A topic of which nothing is to be lost, though the mission has none. */
const storedTopic = { topic: "battery_state", stored: 120n, backfilled: 30n, expired: 0n, refused: 2n, waiting: 4 };

/** What the vehicle and mission_control would say differently of what was ordered here. */
function rewrite(topic, data, channel, state) {
  const changes = {
    "/safety_status": (message) => ({
      ...message,
      emergency_stop: state.stopped,
      stopped_by: state.stopped ? ["station"] : [],
    }),
    "/link_state": (message) => ({ ...message, stored: message.role === "uxv" ? [storedTopic] : [] }),
    "/mission_status": (message) => ({
      ...message,
      ...(state.mission && { mission: "follow_waypoints", waypoint: 0, waypoints: state.mission.length, state: state.missionState }),
      ...(state.paused && { state: "paused" }),
    }),
  };
  const change = changes[topic];
  if (!change) return data;
  const definition = parse(channel.schema, { ros2: true });
  return new MessageWriter(definition).writeMessage(change(new MessageReader(definition).readMessage(data)));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const value = (name, otherwise) => {
    const at = process.argv.indexOf(`--${name}`);
    return at < 0 ? otherwise : process.argv[at + 1];
  };
  const image = value("map");
  const { port } = await startStandIn({
    page: value("page"),
    bag: value("bag"),
    port: Number(value("port", "8765")),
    from: Number(value("from", "0")),
    map: image && { image, resolution: 0.05, x: -19, y: -8 },
  });
  console.log(`http://127.0.0.1:${port}/`);
}
