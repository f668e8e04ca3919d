// SPDX-License-Identifier: Apache-2.0
// A bag (MCAP) in the browser: its messages of any time, decoded, without reading the whole file.
import { type IReadable, McapIndexedReader } from "@mcap/core";
import { decompress as decompressZstd } from "fzstd";

import { camera, topicsRead } from "../model/messages.ts";
import { type Decode, decoderOf } from "../protocol/codec.ts";
import { plainTopic } from "../protocol/topic_name.ts";
import type { BagSource } from "./bag_source.ts";

/** A message as it was recorded; `at`: when [ms since the Unix epoch]. */
export interface BagMessage {
  readonly topic: string;
  readonly at: number;
  readonly message: unknown;
}

const toMs = (ns: bigint): number => Number(ns / 1000n) / 1000;
const toNs = (ms: number): bigint => BigInt(Math.round(ms * 1000)) * 1000n;

export class BagFile {
  readonly begin: number;
  readonly end: number;
  #decoders = new Map<number, { topic: string; decode: Decode }>();
  /** As they stand in the file, without the pictures, and the pictures. */
  readonly #states: string[] = [];
  readonly #pictures: string[] = [];

  private constructor(private readonly reader: McapIndexedReader) {
    this.begin = toMs(reader.statistics?.messageStartTime ?? 0n);
    this.end = toMs(reader.statistics?.messageEndTime ?? 0n);
    for (const [id, { topic, schemaId, messageEncoding }] of reader.channelsById) {
      const schema = reader.schemasById.get(schemaId);
      const name = plainTopic(topic);
      if (schema === undefined || messageEncoding !== "cdr" || !topicsRead.has(name)) continue;
      const text = new TextDecoder().decode(schema.data);
      const decode = decoderOf({ name: schema.name, encoding: schema.encoding, text });
      if (decode === undefined) continue;
      this.#decoders.set(id, { topic: name, decode });
      (name === camera ? this.#pictures : this.#states).push(topic);
    }
  }

  /** Throws with a text for people when it is no bag, or holds nothing that the page shows. */
  static async open(source: BagSource): Promise<BagFile> {
    const readable: IReadable = {
      size: async () => BigInt(source.size),
      read: (offset, length) => source.read(Number(offset), Number(offset + length)),
    };
    const decompressHandlers = { zstd: (bytes: Uint8Array, size: bigint) => inflated(bytes, size) };
    const bag = new BagFile(await McapIndexedReader.Initialize({ readable, decompressHandlers }));
    if (bag.#decoders.size === 0) throw new Error("it holds no topic that the page shows");
    return bag;
  }

  /** All from `from` on, in order of time. */
  messages(from: number): AsyncGenerator<BagMessage> {
    return this.#read([...this.#states, ...this.#pictures], { startTime: toNs(from) });
  }

  /** All but pictures up to `to`, in order of time. */
  statesUntil(to: number): AsyncGenerator<BagMessage> {
    return this.#read(this.#states, { endTime: toNs(to) });
  }

  /** The last picture that was there at `at`. */
  async pictureAt(at: number): Promise<BagMessage | undefined> {
    if (this.#pictures.length === 0) return undefined;
    for await (const one of this.#read(this.#pictures, { endTime: toNs(at), reverse: true })) return one;
    return undefined;
  }

  async *#read(
    topics: string[],
    range: { startTime?: bigint; endTime?: bigint; reverse?: boolean },
  ): AsyncGenerator<BagMessage> {
    if (topics.length === 0) return;
    for await (const { channelId, logTime, data } of this.reader.readMessages({ topics, ...range })) {
      const known = this.#decoders.get(channelId);
      if (known) yield { topic: known.topic, at: toMs(logTime), message: known.decode(data) };
    }
  }
}

function inflated(bytes: Uint8Array, size: bigint): Uint8Array {
  return decompressZstd(bytes, new Uint8Array(Number(size)));
}
