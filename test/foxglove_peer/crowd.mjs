// SPDX-License-Identifier: Apache-2.0
// Many clients of a server: `node crowd.mjs PORT SECONDS [--clients 20] [--silent 1] [--pid PID]`.
// All subscribe to all topics. The silent ones stop to read what they are sent, as a laptop that was closed. The others
// count, and measure how long each location took from the station's copy (the server's stamp) to here. With the
// server's process id its memory is read each second, and its share of a core. Prints what came of it as JSON.
import fs from "node:fs";

import protocol from "@foxglove/ws-protocol";
import WebSocket from "ws";

const { FoxgloveClient } = protocol;
const [port, seconds] = process.argv.slice(2, 4).map(Number);
const option = (name, otherwise) => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? otherwise : Number(process.argv[at + 1]);
};
const [clients, silent, pid] = [option("clients", 20), option("silent", 1), option("pid", 0)];
/** [ms] of each location at each reading client. */
const delays = [];
const memory = [];

/** A client that reads nothing after it has subscribed, or everything. */
class Client {
  messages = 0;
  pictures = 0;
  drops = 0;
  ended = "";
  #topics = new Map();

  constructor(reads) {
    this.reads = reads;
    const socket = new WebSocket(`ws://127.0.0.1:${port}/`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]);
    this.client = new FoxgloveClient({ ws: socket });
    this.client.on("error", (error) => (this.ended ||= String(error)));
    this.client.on("close", ({ reason }) => (this.ended ||= `closed: ${reason}`));
    this.client.on("status", ({ message }) => (this.drops += /missed|dropped/i.test(message) ? 1 : 0));
    this.client.on("advertise", (channels) => {
      for (const { id, topic } of channels) this.#topics.set(this.client.subscribe(id), topic);
      if (!reads) socket._socket.pause();
    });
    this.client.on("message", ({ subscriptionId, timestamp }) => {
      const topic = this.#topics.get(subscriptionId);
      ++this.messages;
      if (topic.includes("image")) ++this.pictures;
      if (topic === "/location") delays.push(Date.now() - Number(timestamp / 1000n) / 1000);
    });
  }
}

/** [s] of CPU that the server has used. */
const used = () => {
  if (pid === 0) return 0;
  const words = fs.readFileSync(`/proc/${pid}/stat`, "utf8").replace(/.*\) /, "").split(" ");
  return (Number(words[11]) + Number(words[12])) / 100;
};
const usedBefore = used();

const all = Array.from({ length: clients }, (_, index) => new Client(index >= silent));
const timer = setInterval(() => {
  if (pid === 0) return;
  const status = fs.readFileSync(`/proc/${pid}/status`, "utf8");
  memory.push(Number(/VmRSS:\s+(\d+)/.exec(status)[1]) / 1024);
}, 1000);
const share = (sorted, part) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];

setTimeout(() => {
  clearInterval(timer);
  delays.sort((a, b) => a - b);
  const reading = all.filter(({ reads }) => reads);
  const counts = reading.map(({ messages }) => messages).sort((a, b) => a - b);
  const said = {
    clients, silent, seconds,
    messages: { least: counts[0], most: counts.at(-1) },
    pictures: Math.min(...reading.map(({ pictures }) => pictures)),
    ended: reading.filter(({ ended }) => ended !== "").length,
    silent_ended: all.filter(({ reads, ended }) => !reads && ended !== "").length,
    location_ms: { count: delays.length, median: share(delays, 0.5), p99: share(delays, 0.99), most: delays.at(-1) },
    cpu_percent: (100 * (used() - usedBefore)) / seconds,
    memory_mib: { first: memory[0], most: Math.max(...memory), last: memory.at(-1) },
  };
  console.log(JSON.stringify(said));
  process.exit(0);
}, seconds * 1000);
