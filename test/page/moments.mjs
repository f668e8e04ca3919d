// SPDX-License-Identifier: Apache-2.0
// What the page's alert line says at moments of a recorded mission, beside what the vehicle itself recorded of the link
// and of its safety then.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const source = path.join(here, "../../components/station/operator_page");

/** The page's own code, without its views. Throws where its npm packages are missing. */
export async function pageModel(folder) {
  const { build } = await import(path.join(source, "node_modules/esbuild/lib/main.js"));
  const outfile = path.join(folder, "model.mjs");
  const parts = ["model/alerts", "model/link_grade", "model/station", "model/messages", "replay/bag_file"];
  const contents = parts.map((part) => `export * from "./src/${part}.ts";`).join("\n");
  await build({
    ...{ stdin: { contents, resolveDir: source, loader: "ts" }, outfile, bundle: true, platform: "node", format: "esm" },
    banner: { js: "import { createRequire } from 'node:module'; const require = createRequire(import.meta.url);" },
  });
  return import(outfile);
}

/** All messages of a bag that the page reads. */
export async function readBag({ BagFile }, file) {
  const bytes = fs.readFileSync(file);
  const bag = await BagFile.open({
    ...{ name: file, size: bytes.length },
    read: async (begin, end) => new Uint8Array(bytes.subarray(begin, end)),
  });
  const messages = [];
  for await (const one of bag.messages(bag.begin)) messages.push(one);
  return messages;
}

const latched = ["navigation_status", "safety_status", "docking/status", "teleop/driver", "transmission_state", "mission_status"];
const open = { phase: "open", since: 0, tries: 0, reason: "" };
const stampMs = ({ sec, nanosec }) => sec * 1000 + nanosec / 1e6;

/** What a page says at `now` that was opened at `opened`: the server gives it the last state of each writer at once. */
export function alertAt({ Station, alertOf }, messages, opened, now) {
  const station = new Station();
  const states = new Map();
  for (const { topic, at, message } of messages) {
    if (at < opened && latched.includes(topic)) states.set(`${topic} ${message.role ?? ""}`, { topic, message });
  }
  for (const { topic, message } of states.values()) station.onMessage(topic, message, opened);
  for (const { topic, at, message } of messages) {
    if (at >= opened && at <= now) station.onMessage(topic, message, at);
  }
  return alertOf(open, station, now);
}

/**
 * How the link was by the vehicle's own recording: its last measurement up to `now`, or (`next`) the first after it, which tells
 * of `now` itself; with how old the newest position at the station was, and what hindered the vehicle.
 */
export function truthAt({ gradeLink, hindrances }, { vehicle, station }, now, next = false) {
  const last = (messages, topic) => messages.filter(({ topic: name, at }) => name === topic && at <= now).at(-1)?.message;
  const ofVehicle = vehicle.filter(({ message }) => message.role !== "gcs");
  const first = (topic) => ofVehicle.find(({ topic: name, at }) => name === topic && at >= now)?.message;
  const measured = (topic) => (next ? first(topic) : undefined) ?? last(ofVehicle, topic);
  const position = last(station, "location");
  const safety = last(vehicle, "safety_status");
  const { isGood, word, figures } = gradeLink({
    perPercent: measured("network_quality")?.per_percent,
    qni: measured("transmission_state")?.qni,
    lossPercent: 100 * (measured("link_state")?.loss ?? 0),
    ageMs: position && now - stampMs(position.header.stamp),
  });
  const hindered = safety ? hindrances(safety) : [];
  return { isWell: isGood && hindered.length === 0, isGood, word, figures, hindered };
}
