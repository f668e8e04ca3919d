// SPDX-License-Identifier: Apache-2.0
// What hostile clients do to a server: `node hostile.mjs PORT [--frames 100000] [--connections 1000] [--pid PID]`.
// One after the other: pages of other origins, malformed frames (text and binary in turn) on one connection, frames
// that are too long, connections at the same time. A good client hears the server's time all along, ten times a
// second, and must stay. Prints what came of each as JSON; ends with 1 when something was not refused.
import fs from "node:fs";

import WebSocket from "ws";

const port = Number(process.argv[2]);
const option = (name, otherwise) => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? otherwise : Number(process.argv[at + 1]);
};
const [frames, connections, pid] = [option("frames", 100_000), option("connections", 1000), option("pid", 0)];
const waiting = 500;
const patienceMs = 60_000;

/** What came of it: open, refused with a status of HTTP, or closed with a code. */
function connect(options = {}) {
  const socket = new WebSocket(`ws://127.0.0.1:${port}/`, ["foxglove.sdk.v1"], options);
  const outcome = new Promise((resolve) => {
    socket.on("unexpected-response", (_, { statusCode }) => resolve(`refused ${statusCode}`));
    socket.on("error", ({ code }) => resolve(`refused ${code ?? ""}`));
    socket.on("close", (code) => resolve(`closed ${code}`));
    socket.on("message", () => resolve("open")); // the server speaks first
  });
  return { socket, outcome };
}

const counted = (words) => Object.fromEntries([...new Set(words)].sort().map((word) => [word, words.filter((one) => one === word).length]));
const memoryMib = () => (pid ? Number(/VmRSS:\s+(\d+)/.exec(fs.readFileSync(`/proc/${pid}/status`, "utf8"))[1]) / 1024 : undefined);

/** A client that only listens. */
async function goodClient() {
  const { socket, outcome } = connect();
  const good = { socket, ended: false, times: 0, longestMs: 0, last: performance.now() };
  socket.on("message", (data, isBinary) => {
    if (!isBinary || data[0] !== 2) return;
    ++good.times;
    good.longestMs = Math.max(good.longestMs, performance.now() - good.last);
    good.last = performance.now();
  });
  socket.on("close", () => (good.ended = true));
  if ((await outcome) !== "open") throw new Error(`no server at port ${port}`);
  return good;
}

async function foreignOrigins() {
  const outcomes = [{ origin: "https://evil.example" }, { headers: { Host: "evil.example" } }].map((one) => connect(one).outcome);
  return counted(await Promise.all(outcomes));
}

/** Each must be answered with a status, and the connection stays. */
async function malformedFrames() {
  const { socket, outcome } = connect();
  await outcome;
  let [answered, ended] = [0, false];
  let more = () => {};
  socket.on("close", () => ((ended = true), more()));
  socket.on("message", (data, isBinary) => {
    if (!isBinary && JSON.parse(data).op === "status") ++answered;
    more();
  });
  const began = performance.now();
  const until = (done) => new Promise((resolve) => {
    const timer = setTimeout(resolve, patienceMs);
    more = () => {
      if (!done() && !ended) return;
      clearTimeout(timer);
      resolve();
    };
    more();
  });
  for (let i = 0; i < frames && !ended; ++i) {
    socket.send(i % 2 === 0 ? `{"op": ${i}` : new Uint8Array(i % 13).fill(5));
    if (i % waiting === waiting - 1) await until(() => answered > i - waiting);
  }
  await until(() => answered === frames);
  socket.terminate();
  return { sent: frames, answered, ended, seconds: (performance.now() - began) / 1000 };
}

/** Each ends its own connection, with 1009 or without a word. */
async function longFrames(count) {
  const outcomes = [];
  for (let i = 0; i < count; ++i) {
    const { socket, outcome } = connect();
    await outcome;
    outcomes.push(await new Promise((resolve) => {
      socket.on("close", (code) => resolve(`closed ${code}`));
      socket.on("error", () => {});
      socket.send(" ".repeat(2 * 1024 * 1024));
    }));
  }
  return counted(outcomes);
}

async function manyConnections() {
  const all = Array.from({ length: connections }, () => connect());
  const outcomes = counted(await Promise.all(all.map(({ outcome }) => outcome)));
  for (const { socket } of all) socket.terminate();
  return outcomes;
}

const good = await goodClient();
const memory = { before: memoryMib() };
const said = { origins: await foreignOrigins(), malformed: await malformedFrames(), long: await longFrames(50), connections: await manyConnections() };
memory.after = memoryMib();
const again = await connect().outcome;
console.log(JSON.stringify({ ...said, good: { ended: good.ended, times: good.times, longest_ms: good.longestMs }, memory_mib: memory, again }));
const refused = said.origins["refused 403"] === 2 && said.malformed.answered === frames && !said.malformed.ended && (said.connections.open ?? 0) < 64;
process.exit(refused && !good.ended && said.long.open === undefined ? 0 : 1);
