// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { type IWritable, McapWriter } from "@mcap/core";

import { encoderOf } from "../src/protocol/codec.ts";
import { BagFile } from "../src/replay/bag_file.ts";
import { BagPlayer } from "../src/replay/bag_player.ts";
import { type BagSource, sourceOfFile, sourceOfUrl } from "../src/replay/bag_source.ts";

const separator = `\n${"=".repeat(80)}\n`;
const time = "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec";
const texts: Record<string, string> = {
  "/cpu_load": "builtin_interfaces/Time stamp\nfloat32 load_percent\nfloat32[] core_percent" + separator + time,
  "/camera/image_raw/compressed":
    ["std_msgs/Header header\nstring format\nuint8[] data", "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id", time].join(separator),
  "/other": "bool data",
};

/** A bag with a message of each topic each second from 100 s to 119 s. */
async function makeBag(topics = Object.keys(texts)): Promise<BagSource> {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  const writable: IWritable = {
    write: async (bytes) => {
      parts.push(new Uint8Array(bytes));
      size += bytes.length;
    },
    position: () => BigInt(size),
  };
  const writer = new McapWriter({ writable, chunkSize: 500 });
  await writer.start({ profile: "ros2", library: "test" });
  const channels = new Map<string, number>();
  for (const topic of topics) {
    const schemaId = await writer.registerSchema({ name: `x/msg/${topic.length}`, encoding: "ros2msg", data: new TextEncoder().encode(texts[topic]) });
    channels.set(topic, await writer.registerChannel({ topic, schemaId, messageEncoding: "cdr", metadata: new Map() }));
  }
  for (let second = 0; second < 20; ++second) {
    for (const [topic, channelId] of channels) {
      const logTime = BigInt(100 + second) * 1_000_000_000n;
      const data = encoderOf(texts[topic] ?? "")({ load_percent: second, data: topic === "/other" ? true : [second] });
      await writer.addMessage({ channelId, sequence: second, logTime, publishTime: logTime, data });
    }
  }
  await writer.end();
  return sourceOfFile(new Blob(parts), "bag");
}

/** Lets promises run until `look` is true. */
async function until(look: () => boolean): Promise<void> {
  for (let tries = 0; tries < 1000 && !look(); ++tries) await new Promise((resolve) => setImmediate(resolve));
  assert.ok(look());
}

describe("BagFile", () => {
  it("knows its time and reads what the page shows from there on", async () => {
    const bag = await BagFile.open(await makeBag());
    assert.deepEqual([bag.begin, bag.end], [100_000, 119_000]);
    const found: string[] = [];
    for await (const { topic, at } of bag.messages(118_500)) found.push(`${topic} ${at}`);
    assert.deepEqual(found, ["cpu_load 119000", "camera/image_raw/compressed 119000"]);
  });
  it("finds the picture that was there", async () => {
    const bag = await BagFile.open(await makeBag());
    assert.equal((await bag.pictureAt(104_900))?.at, 104_000);
    assert.equal(await bag.pictureAt(99_000), undefined);
  });
  it("says that a file is no bag, or shows nothing here", async () => {
    await assert.rejects(BagFile.open(sourceOfFile(new Blob(["no bag at all"]), "none")));
    await assert.rejects(BagFile.open(await makeBag(["/other"])), /no topic that the page shows/);
  });
});

describe("BagPlayer", () => {
  const load = (player: BagPlayer): number | undefined => player.station.cpuPercent?.value;
  it("plays as time goes by, at its speed", async () => {
    const sut = new BagPlayer(await BagFile.open(await makeBag()), "bag");
    await until(() => load(sut) === 0);
    sut.tick(0);
    sut.tick(2100);
    await until(() => load(sut) === 2);
    sut.speed = 5;
    sut.tick(3100);
    assert.equal(sut.position, 107_100);
    await until(() => load(sut) === 7);
    sut.playing = false;
    sut.tick(9000);
    assert.equal(sut.position, 107_100);
  });
  it("stops at the end", async () => {
    const sut = new BagPlayer(await BagFile.open(await makeBag()), "bag");
    await until(() => load(sut) === 0);
    sut.tick(0);
    sut.tick(1e6);
    assert.equal(sut.position, 119_000);
    await until(() => load(sut) === 19);
  });
  it("shows after a seek what was known there, forwards and backwards, with the picture", async () => {
    const sut = new BagPlayer(await BagFile.open(await makeBag()), "bag");
    for (const second of [12, 3, 19, 0]) {
      await sut.seek(100_500 + 1000 * second);
      assert.equal(load(sut), second);
      assert.equal(sut.station.image?.value.data[0], second);
      assert.equal(sut.station.image?.at, 100_000 + 1000 * second);
    }
  });
  it("obeys the last of several seeks", async () => {
    const sut = new BagPlayer(await BagFile.open(await makeBag()), "bag");
    await Promise.all([sut.seek(115_000), sut.seek(105_000)]);
    assert.equal(load(sut), 5);
    sut.tick(0);
    sut.tick(1100);
    await until(() => load(sut) === 6);
  });
});

describe("BagSource", () => {
  /** A server that gives parts of ten bytes, or says why not. */
  function server(refusal?: string) {
    const asked: { url: string; range: string; word: string }[] = [];
    const get = async (url: string, { headers }: { headers: Record<string, string> }) => {
      asked.push({ url, range: headers.Range ?? "", word: headers.Authorization ?? "" });
      if (refusal !== undefined) return new Response(refusal, { status: 404 });
      const [first, last] = /bytes=(\d+)-(\d+)/.exec(headers.Range ?? "")?.slice(1).map(Number) ?? [];
      return new Response(new TextEncoder().encode("0123456789").slice(first, (last ?? 0) + 1), { status: 206 });
    };
    return { asked, get: get as unknown as typeof fetch };
  }
  const text = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

  it("gets a small recording of the station once", async () => {
    const { asked, get } = server();
    const sut = sourceOfUrl("bag", "http://x/bags/b.mcap", 10, get, "secret");
    assert.equal(text(await sut.read(2, 5)), "234");
    assert.equal(text(await sut.read(0, 10)), "0123456789");
    assert.deepEqual(asked, [{ url: "http://x/bags/b.mcap", range: "bytes=0-9", word: "Bearer secret" }]);
  });
  it("gets only the wanted parts of a large one", async () => {
    const { asked, get } = server();
    const sut = sourceOfUrl("bag", "http://x/b", 1e9, get, "");
    assert.equal(text(await sut.read(2, 5)), "234");
    assert.equal((await sut.read(5, 5)).length, 0);
    assert.deepEqual(asked, [{ url: "http://x/b", range: "bytes=2-4", word: "" }]);
  });
  it("says why it cannot be read", async () => {
    const gone = sourceOfUrl("bag", "http://x/b", 1e9, server("there is no such recording\n").get, "");
    await assert.rejects(gone.read(0, 5), /^Error: there is no such recording$/);
    const shorter = sourceOfUrl("bag", "http://x/b", 1e9, server().get, "");
    await assert.rejects(shorter.read(8, 20), /it gave 2 of 12 bytes/);
  });
  it("plays a bag that comes in parts", async () => {
    const whole = await makeBag();
    const bag = await BagFile.open({ ...whole, name: "parts" });
    assert.deepEqual([bag.begin, bag.end], [100_000, 119_000]);
  });
});
