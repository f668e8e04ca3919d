// SPDX-License-Identifier: Apache-2.0
// What the authors' reader says of a file, as JSON: `node read_file.mjs FILE`. It reads by the index, with @mcap/nodejs,
// and, apart from that, from the beginning to the end, checks all checksums, and decodes each message of
// encoding cdr by its ros2msg schema.
import fs from "node:fs";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { FileHandleReadable } from "@mcap/nodejs";
import { loadDecompressHandlers } from "@mcap/support";

const decompressHandlers = await loadDecompressHandlers();
const file = await fs.promises.open(process.argv[2]);
const readable = new FileHandleReadable(file);

const indexed = await McapIndexedReader.Initialize({ readable, decompressHandlers });
const readers = new Map();
for (const channel of indexed.channelsById.values()) {
  const schema = indexed.schemasById.get(channel.schemaId);
  if (channel.messageEncoding !== "cdr" || schema?.encoding !== "ros2msg") continue;
  const text = Buffer.from(schema.data).toString();
  readers.set(channel.id, new MessageReader(parse(text, { ros2: true })));
}

const topics = {};
let last = -1n;
let decoded = 0;
for await (const message of indexed.readMessages()) {
  const { topic } = indexed.channelsById.get(message.channelId);
  topics[topic] = (topics[topic] ?? 0) + 1;
  if (message.logTime < last) throw new Error(`not in order: ${message.logTime} after ${last}`);
  last = message.logTime;
  const reader = readers.get(message.channelId);
  if (reader) {
    reader.readMessage(message.data);
    ++decoded;
  }
}

const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
stream.append(await fs.promises.readFile(process.argv[2]));
let streamed = 0;
for (let record; (record = stream.nextRecord()); ) {
  if (record.type === "Message") ++streamed;
}
if (!stream.done()) throw new Error("the file has no end");

const attachments = {};
for await (const one of indexed.readAttachments()) {
  attachments[one.name] = Buffer.from(one.data).toString();
}
const metadata = {};
for await (const one of indexed.readMetadata()) {
  metadata[one.name] = Object.fromEntries(one.metadata);
}
await file.close();
console.log(
  JSON.stringify({
    profile: indexed.header.profile,
    topics,
    streamed,
    decoded,
    counted: Number(indexed.statistics.messageCount),
    schemas: [...indexed.schemasById.values()].map(({ name, encoding }) => `${name} ${encoding}`),
    metadataOfChannels: [...indexed.channelsById.values()].map((one) =>
      Object.fromEntries(one.metadata),
    ),
    attachments,
    metadata,
  }),
);
