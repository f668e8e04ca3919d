// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { StationFiles } from "../src/protocol/station_files.ts";
import { BagList, bagText } from "../src/replay/bag_list.ts";

/** A server whose answers the test states. */
function server(answers: Record<string, [number, string]>) {
  const asked: [string, string][] = [];
  const get = async (url: string, { headers }: { headers: Record<string, string> }) => {
    asked.push([url, headers.Authorization ?? ""]);
    const [status, text] = answers[new URL(url).pathname] ?? [404, "there is no such file\n"];
    return new Response(text, { status });
  };
  return { asked, get: get as unknown as typeof fetch };
}

describe("StationFiles", () => {
  it("lists the recordings, with the token of the page's address", async () => {
    const { asked, get } = server({ "/bags": [200, '{"bags":[{"path":"gcs/bag_0.mcap","bytes":10}]}'] });
    const sut = new StationFiles("http://station:8765/index.html?token=secret&x=1#map", get);
    assert.deepEqual(await sut.bags(), [{ path: "gcs/bag_0.mcap", bytes: 10 }]);
    assert.deepEqual(asked, [["http://station:8765/bags", "Bearer secret"]]);
  });
  it("asks for a recording by its path", async () => {
    const { asked, get } = server({ "/bags/gcs/bag_0.mcap": [206, "0123456789"] });
    const source = new StationFiles("http://x/", get).source({ path: "gcs/bag_0.mcap", bytes: 10 });
    assert.equal((await source.read(0, 10)).length, 10);
    assert.deepEqual(asked, [["http://x/bags/gcs/bag_0.mcap", ""]]);
  });
  it("asks what if", async () => {
    const { asked, get } = server({ "/what_if": [200, '{"rows":[]}'] });
    assert.deepEqual(await new StationFiles("http://x/", get).whatIf({ host: "uxv", alpha: "3" }), { rows: [] });
    assert.equal(asked[0]?.[0], "http://x/what_if?host=uxv&alpha=3");
  });
  it("gives the server's reason", async () => {
    const { get } = server({ "/bags": [401, "the token is missing\n"], "/what_if": [503, ""] });
    const sut = new StationFiles("http://x/", get);
    await assert.rejects(sut.bags(), /^Error: the token is missing$/);
    await assert.rejects(sut.whatIf({}), /the server answers 503/);
  });
});

describe("BagList", () => {
  const settle = () => new Promise((resolve) => setImmediate(resolve));
  it("is asked for only while it is shown, each 3 s", async () => {
    let asked = 0;
    const sut = new BagList(async () => [{ path: `bag ${++asked}`, bytes: 1 }]);
    sut.tick(0);
    assert.equal(asked, 0);
    sut.show(true);
    for (const now of [0, 100, 2999]) sut.tick(now);
    assert.equal(asked, 1);
    sut.tick(3000);
    await settle();
    assert.equal(sut.bags?.[0]?.path, "bag 2");
    sut.show(false);
    sut.tick(9000);
    assert.equal(asked, 2);
  });
  it("says why there is none, and goes on", async () => {
    let reason = "the token is missing";
    const sut = new BagList(async () => {
      if (reason) throw new Error(reason);
      return [];
    });
    sut.show(true);
    sut.tick(0);
    await settle();
    assert.equal(sut.trouble, reason);
    reason = "";
    sut.tick(3000);
    await settle();
    assert.deepEqual([sut.trouble, sut.bags], ["", []]);
  });
  it("tells when a recording was made, how long and how large it is", () => {
    const begin_s = Date.UTC(2026, 10, 22, 14, 3, 12) / 1000;
    assert.match(bagText({ path: "", bytes: 12_340_000, begin_s, end_s: begin_s + 304.2 }), /^22 Nov, \d\d:03:12, 5:04 min, 12.3 MB$/);
    assert.equal(bagText({ path: "", bytes: 4200 }), "still being written, 4 kB");
  });
});
