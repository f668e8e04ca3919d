// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { decoderOf, encoderOf } from "../src/protocol/codec.ts";
import { Connection, silenceLimitMs } from "../src/protocol/connection.ts";
import { emergencyStopRequest, teleopVelocity } from "../src/protocol/published.ts";

describe("Codec", () => {
  it("writes CDR as it stands on the wire", () => {
    assert.deepEqual([...encoderOf(emergencyStopRequest.text)({ data: true })], [0, 1, 0, 0, 1]);
  });
  it("reads what it has written, with lists and 64-bit numbers", () => {
    const message = { id: 2n ** 63n + 1n, x: 1.5, ahead: [{ x: 1, y: 2 }], mission: 2n ** 64n - 1n };
    const text = `uint64 id\nfloat64 x\na/Place[] ahead\nuint64 mission\n${"=".repeat(80)}\nMSG: a/Place\nfloat64 x\nfloat64 y`;
    const decode = decoderOf({ name: "a/Goal", encoding: "ros2msg", text });
    assert.deepEqual(decode?.(encoderOf(text)(message)), message);
  });
  it("throws at a message that ends too early", () => {
    const bytes = encoderOf(teleopVelocity.text)({});
    const decode = decoderOf({ name: "", encoding: "ros2msg", text: teleopVelocity.text });
    assert.throws(() => decode?.(bytes.subarray(0, 20)));
  });
  it("knows no other schema than ros2msg", () => {
    assert.equal(decoderOf({ name: "x", encoding: "protobuf", text: "" }), undefined);
  });
});

/** The browser's end of a WebSocket whose other end is the test. */
class FakeSocket {
  binaryType = "";
  protocol = "foxglove.sdk.v1";
  onerror: ((event: unknown) => void) | null = null;
  onopen: ((event: unknown) => void) | null = null;
  onclose: ((event: unknown) => void) | null = null;
  onmessage: ((event: unknown) => void) | null = null;
  sent: (string | Uint8Array)[] = [];
  closed = false;
  send(data: string | Uint8Array): void {
    this.sent.push(data);
  }
  close(): void {
    this.closed = true;
  }
  says(message: object): void {
    this.onmessage?.({ data: JSON.stringify(message) });
  }
  ops(): string[] {
    return this.sent.filter((one) => typeof one === "string").map((text) => JSON.parse(text).op as string);
  }
  subscriptions(): { id: number; channelId: number }[] {
    return this.sent.flatMap((one) => {
      const message = typeof one === "string" ? JSON.parse(one) : {};
      return message.op === "subscribe" ? message.subscriptions : [];
    });
  }
  /** The answer to a call, as it stands on the wire. */
  answers(service: number, call: number, payload: Uint8Array): void {
    const bytes = new Uint8Array(16 + payload.length);
    const view = new DataView(bytes.buffer);
    view.setUint8(0, 3);
    view.setUint32(1, service, true);
    view.setUint32(5, call, true);
    view.setUint32(9, 3, true);
    bytes.set(new TextEncoder().encode("cdr"), 13);
    bytes.set(payload, 16);
    this.onmessage?.({ data: bytes.buffer });
  }
  data(subscription: number, payload: Uint8Array): void {
    const bytes = new Uint8Array(13 + payload.length);
    const view = new DataView(bytes.buffer);
    view.setUint8(0, 1);
    view.setUint32(1, subscription, true);
    view.setBigUint64(5, 1_500_000_000n, true);
    bytes.set(payload, 13);
    this.onmessage?.({ data: bytes.buffer });
  }
}

const advertised = (topic: string, id: number) => ({
  op: "advertise",
  channels: [{ id, topic, encoding: "cdr", schemaName: "std_msgs/msg/Bool", schemaEncoding: "ros2msg", schema: "bool data" }],
});

function setUp() {
  const sockets: FakeSocket[] = [];
  const heard: { topic: string; message: unknown; logTimeMs: number }[] = [];
  const troubles: string[] = [];
  const parameters: [string, unknown][] = [];
  const time = { now: 1000 };
  const sut = new Connection({
    url: "ws://test",
    topics: new Set(["lamp", "bell"]),
    onMessage: (topic, message, logTimeMs) => heard.push({ topic, message, logTimeMs }),
    onServer: () => undefined,
    onParameter: (name, value) => parameters.push([name, value]),
    onTrouble: (text) => troubles.push(text),
    now: () => time.now,
    openSocket: () => {
      sockets.push(new FakeSocket());
      return sockets.at(-1) as never;
    },
  });
  const last = (): FakeSocket => sockets.at(-1) as FakeSocket;
  return { sut, sockets, heard, troubles, parameters, time, last };
}

describe("Connection", () => {
  it("watches a parameter and sets it", () => {
    const { sut, last, parameters } = setUp();
    assert.equal(sut.setParameter("/lamp.on", true), false, "nobody is there yet");
    last().onopen?.({});
    sut.watchParameters(["/lamp.on"]);
    assert.deepEqual(last().ops().slice(-2), ["subscribeParameterUpdates", "getParameters"]);
    assert.ok(sut.setParameter("/lamp.on", true));
    const said = JSON.parse(String(last().sent.at(-1)));
    assert.deepEqual([said.op, said.parameters], ["setParameters", [{ name: "/lamp.on", value: true }]]);
    last().says({ op: "parameterValues", parameters: [{ name: "/lamp.on", value: true }] });
    assert.deepEqual(parameters, [["/lamp.on", true]]);
  });
  const lampService = {
    op: "advertiseServices",
    services: [{
      id: 4, name: "/lamp/set", type: "std_srvs/srv/SetBool",
      request: { encoding: "cdr", schemaName: "R", schemaEncoding: "ros2msg", schema: "bool data" },
      response: { encoding: "cdr", schemaName: "A", schemaEncoding: "ros2msg", schema: "bool success" },
    }],
  };
  it("calls a service and hands on its answer", async () => {
    const { sut, last } = setUp();
    last().onopen?.({});
    last().says(lampService);
    const answer = sut.call("lamp/set", { data: true });
    const sent = last().sent.at(-1) as Uint8Array;
    assert.deepEqual([sent[0], sent[1], sent[5]], [2, 4, 1]);
    last().answers(4, 1, new Uint8Array([0, 1, 0, 0, 1]));
    assert.deepEqual(await answer, { success: true });
  });
  it("says why a call has no answer: nobody serves it, the server's reason, a loss, an answer that cannot be read", async () => {
    const { sut, last } = setUp();
    await assert.rejects(sut.call("lamp/set", {}), /no connection to the station/);
    last().onopen?.({});
    await assert.rejects(sut.call("lamp/set", {}), /nobody serves lamp\/set/);
    last().says(lampService);
    const refused = sut.call("lamp/set", {});
    last().says({ op: "serviceCallFailure", serviceId: 4, callId: 1, message: "nobody answered in time" });
    await assert.rejects(refused, /nobody answered in time/);
    const unreadable = sut.call("lamp/set", {});
    last().answers(4, 2, new Uint8Array(2));
    await assert.rejects(unreadable, /the answer cannot be read/);
    const lost = sut.call("lamp/set", {});
    last().onclose?.({ code: 1006 });
    await assert.rejects(lost, /the connection was lost before an answer/);
  });
  it("subscribes to what it reads, by the name without the slash, and to nothing else", () => {
    const { last, heard } = setUp();
    last().onopen?.({});
    last().says(advertised("/other", 8));
    last().says(advertised("/lamp", 9));
    const [one, ...more] = last().subscriptions();
    assert.equal(one?.channelId, 9);
    assert.equal(more.length, 0);
    last().data(one?.id ?? -1, new Uint8Array([0, 1, 0, 0, 1]));
    assert.deepEqual(heard, [{ topic: "lamp", message: { data: true }, logTimeMs: 1500 }]);
  });
  it("takes a silent server for gone, and comes back with its subscriptions", () => {
    const { sut, sockets, time, last } = setUp();
    last().onopen?.({});
    time.now += silenceLimitMs;
    sut.tick();
    assert.equal(sut.state.phase, "open");
    time.now += 1;
    sut.tick();
    assert.equal(sut.state.phase, "lost");
    assert.ok(last().closed);
    time.now += 300;
    sut.tick();
    assert.equal(sockets.length, 2);
    last().onopen?.({});
    last().says(advertised("/lamp", 3));
    assert.equal(sut.state.phase, "open");
    assert.equal(last().subscriptions()[0]?.channelId, 3);
  });
  it("tries again at growing intervals, and tells since when it is lost", () => {
    const { sut, sockets, time, last } = setUp();
    for (const wait of [300, 600, 1200, 2500, 2500]) {
      last().onclose?.({ code: 1006 });
      const tries = sockets.length;
      time.now += wait - 1;
      sut.tick();
      assert.equal(sockets.length, tries, `after ${wait - 1} ms`);
      time.now += 1;
      sut.tick();
      assert.equal(sockets.length, tries + 1, `after ${wait} ms`);
    }
    assert.equal(sut.state.since, 1000);
    assert.equal(sut.state.reason, "no server answers");
  });
  it("hears nothing more of a connection that it gave up", () => {
    const { sut, sockets, time, heard } = setUp();
    sockets[0]?.onopen?.({});
    sockets[0]?.says(advertised("/lamp", 9));
    time.now += silenceLimitMs + 1;
    sut.tick();
    sockets[0]?.data(0, new Uint8Array([0, 1, 0, 0, 1]));
    sockets[0]?.onopen?.({});
    assert.equal(heard.length, 0);
    assert.equal(sut.state.phase, "lost");
  });
  it("says what it cannot read, and goes on", () => {
    const { last, heard, troubles } = setUp();
    last().onopen?.({});
    last().says(advertised("/lamp", 9));
    const id = last().subscriptions()[0]?.id ?? -1;
    last().data(id, new Uint8Array([0, 1, 0, 0]));
    assert.match(troubles[0] ?? "", /^lamp: a message cannot be read/);
    last().data(id, new Uint8Array([0, 1, 0, 0, 0]));
    assert.equal(heard.length, 1);
  });
  it("publishes on channels that it has advertised, and only while it is open", () => {
    const { sut, last } = setUp();
    assert.equal(sut.publish(emergencyStopRequest, { data: true }), false);
    last().onopen?.({});
    last().says({ op: "serverInfo", name: "test", capabilities: [] });
    assert.ok(last().ops().includes("advertise"));
    assert.equal(sut.publish(emergencyStopRequest, { data: true }), true);
    const frame = last().sent.at(-1) as Uint8Array;
    assert.deepEqual([...frame.subarray(5)], [0, 1, 0, 0, 1]);
    last().onclose?.({ code: 1001 });
    assert.equal(sut.publish(emergencyStopRequest, { data: true }), false);
  });
  it("is in the namespace of its vehicle, and hears and writes no other's", () => {
    const { last } = setUp();
    last().onopen?.({});
    last().says({ op: "serverInfo", name: "test", capabilities: [], metadata: { namespace: "uxv1" } });
    const topics = last().sent.flatMap((one) => (typeof one === "string" ? (JSON.parse(one).channels ?? []) : []) as { topic: string }[]);
    assert.ok(topics.some(({ topic }) => topic === "/uxv1/emergency_stop/request"));
    assert.ok(topics.every(({ topic }) => topic.startsWith("/uxv1/")));
    for (const [index, topic] of ["/lamp", "/uxv10/lamp", "/uxv2/lamp", "/uxv1/lamp"].entries()) last().says(advertised(topic, index));
    assert.deepEqual(last().subscriptions().map(({ channelId }) => channelId), [3]);
  });
  it("lets a topic rest that nobody looks at, and takes it up again", () => {
    const { sut, last } = setUp();
    last().onopen?.({});
    last().says(advertised("/lamp", 9));
    sut.want("lamp", false);
    assert.equal(last().ops().at(-1), "unsubscribe");
    sut.want("lamp", true);
    assert.equal(last().subscriptions().length, 2);
  });
});
