// SPDX-License-Identifier: Apache-2.0
// Writes the files that foreign_file_test reads: `node write_files.mjs FOLDER`. Needs the program lz4.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import zstd from "@foxglove/wasm-zstd";
import { McapWriter } from "@mcap/core";

const folder = process.argv[2];
await zstd.isLoaded;

/** A file in memory as McapWriter wants it. */
class Memory {
  bytes = Buffer.alloc(0);
  async write(part) {
    this.bytes = Buffer.concat([this.bytes, Buffer.from(part)]);
  }
  position() {
    return BigInt(this.bytes.length);
  }
}

const packed = {
  none: undefined,
  zstd: (data) => ({ compression: "zstd", compressedData: zstd.compress(data) }),
  lz4: (data) => ({
    compression: "lz4",
    compressedData: execFileSync("lz4", ["-c", "-1"], { input: data }),
  }),
};

/** A std_msgs/msg/String in CDR. */
function cdr(text) {
  const head = Buffer.from([0, 1, 0, 0, text.length + 1, 0, 0, 0]);
  return Buffer.concat([head, Buffer.from(text), Buffer.from([0])]);
}

/** 20 messages of two topics with times 1000, 1010, ...; an attachment and metadata. */
async function written(options) {
  const file = new Memory();
  const writer = new McapWriter({ writable: file, chunkSize: 400, ...options });
  await writer.start({ profile: "ros2", library: "@mcap/core" });
  const schemaId = await writer.registerSchema({
    name: "std_msgs/msg/String",
    encoding: "ros2msg",
    data: Buffer.from("string data\n"),
  });
  const channels = [];
  for (const topic of ["/left", "/right"]) {
    channels.push(
      await writer.registerChannel({
        topic,
        schemaId,
        messageEncoding: "cdr",
        metadata: new Map([["offered_qos_profiles", topic]]),
      }),
    );
  }
  await writer.addAttachment({
    name: "map.pgm",
    logTime: 900n,
    createTime: 800n,
    mediaType: "image/x-portable-graymap",
    data: Buffer.from("P5 1 1 255 x"),
  });
  for (let i = 0; i < 20; ++i) {
    const time = BigInt(1000 + 10 * i);
    await writer.addMessage({
      channelId: channels[i % 2],
      sequence: i,
      logTime: time,
      publishTime: time - 1n,
      data: cdr(`message ${i} `.repeat(4)),
    });
  }
  await writer.addMetadata({ name: "run", metadata: new Map([["seed", "3"]]) });
  await writer.end();
  return file.bytes;
}

/** Records of an opcode that nobody knows, in front of DataEnd's place and of everything else. */
function withUnknownRecords(bytes) {
  const unknown = Buffer.concat([Buffer.from([0x80, 5, 0, 0, 0, 0, 0, 0, 0]), Buffer.from("hello")]);
  const headerEnd = 8 + 9 + Number(bytes.readBigUInt64LE(9));
  return Buffer.concat([bytes.subarray(0, headerEnd), unknown, bytes.subarray(headerEnd)]);
}

for (const [name, compressChunk] of Object.entries(packed)) {
  fs.writeFileSync(path.join(folder, `${name}.mcap`), await written({ compressChunk }));
}
fs.writeFileSync(path.join(folder, "no_chunks.mcap"), await written({ useChunks: false }));
fs.writeFileSync(
  path.join(folder, "no_indexes.mcap"),
  await written({
    useMessageIndex: false,
    useChunkIndex: false,
    useStatistics: false,
    useSummaryOffsets: false,
    repeatSchemas: false,
    repeatChannels: false,
    useAttachmentIndex: false,
    useMetadataIndex: false,
  }),
);
fs.writeFileSync(path.join(folder, "unknown_records.mcap"), withUnknownRecords(await written({})));
