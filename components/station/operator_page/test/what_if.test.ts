// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { compare, queryOf, silence, whatIfOf } from "../src/model/what_if.ts";
import type { Decision } from "../src/model/series.ts";
import { RecordOrder } from "../src/orders/record_order.ts";
import { WhatIfQuery } from "../src/orders/what_if_query.ts";
import { aligned } from "../src/view/decision_chart.tsx";

const question = { host: "uxv", policy: "tocp", changes: "" } as const;
const decision = (at: number, active: boolean): Decision => ({
  at, made: at, qni: 80, statistic: 1, threshold: 5, active,
});
const row = (time_s: number, state: string) => ({ time_s, qni: 80, state, statistic: 1.5, threshold: 5.5, age: 0, reason: "steady" });
const settle = () => new Promise((resolve) => setImmediate(resolve));

describe("What if", () => {
  it("asks with the parameters that were typed", () => {
    assert.deepEqual(queryOf({ ...question, changes: " alpha=3, th_max_s=20," }), {
      host: "uxv", policy: "tocp", alpha: "3", th_max_s: "20",
    });
    assert.throws(() => queryOf({ ...question, changes: "alpha" }), /"alpha" is no parameter=value/);
    assert.throws(() => queryOf({ ...question, changes: "a=b=c" }), /is no parameter=value/);
  });
  it("lies on the page's time, whatever the vehicle's clock says", () => {
    const { decisions } = whatIfOf({ recorded: { began_s: 7 }, rows: [row(3, "active"), row(4.5, "passive")] }, question, 500_000);
    assert.deepEqual(decisions.map(({ at, active }) => [at, active]), [[510_000, true], [511_500, false]]);
  });
  it("throws at an answer that has no decisions", () => {
    assert.throws(() => whatIfOf({ reason: "x" }, question, 0), /has no recorded decisions/);
    assert.throws(() => whatIfOf({ rows: [] }, question, 0), /has no recorded decisions/);
  });
  it("sums up pauses between two times, cut at both", () => {
    const all = [decision(0, false), decision(2000, true), decision(5000, false), decision(6000, true), decision(9000, false)];
    assert.deepEqual(silence(all, 1000, 10_000), { pauses: 3, seconds: 3 });
    assert.deepEqual(silence(all, 2000, 5000), { pauses: 0, seconds: 0 });
    assert.deepEqual(silence([], 0, 10), { pauses: 0, seconds: 0 });
  });
  it("compares only the time that both know", () => {
    const happened = [decision(4000, true), decision(6000, false), decision(10_000, false)];
    const other = { question, decisions: [decision(0, false), decision(5000, true), decision(9000, true)] };
    assert.deepEqual(compare(other, happened), {
      seconds: 5, other: { pauses: 1, seconds: 1 }, happened: { pauses: 1, seconds: 3 },
    });
    assert.equal(compare(other, []), undefined);
    assert.equal(compare({ question, decisions: [] }, happened), undefined);
    assert.equal(compare(other, [decision(90_000, true), decision(91_000, true)]), undefined);
  });
  it("is a column of its own in the plot, over one axis of time", () => {
    const data = aligned([decision(1000, true)], [], [{ ...decision(2000, true), statistic: 7 }]);
    assert.deepEqual([...data[0]], [1, 2]);
    assert.deepEqual([...(data[5] ?? [])].map((value) => value ?? null), [null, 7]);
  });
});

describe("WhatIfQuery", () => {
  function setUp(answer: () => Promise<unknown> = async () => ({ recorded: { began_s: 0 }, rows: [row(1, "passive")] })) {
    const asked: Readonly<Record<string, string>>[] = [];
    const offsets = { uxv: 1000 as number | undefined };
    const sut = new WhatIfQuery((query) => {
      asked.push(query);
      return answer();
    }, () => offsets.uxv);
    return { sut, asked, offsets };
  }
  it("asks at once and again each 10 s, until it is cleared", async () => {
    const { sut, asked } = setUp();
    sut.tick(0);
    assert.equal(asked.length, 0);
    sut.ask(question);
    sut.tick(50);
    await settle();
    assert.equal(sut.result?.decisions[0]?.at, 2000);
    sut.tick(10_049);
    assert.equal(asked.length, 1);
    sut.tick(10_050);
    assert.equal(asked.length, 2);
    await settle();
    sut.clear();
    sut.tick(90_000);
    assert.equal(asked.length, 2);
    assert.equal(sut.result, undefined);
  });
  it("has one request on its way, and drops the answer to a question that was replaced", async () => {
    const waiting: ((answer: unknown) => void)[] = [];
    const { sut, asked } = setUp(() => new Promise((resolve) => waiting.push(resolve)));
    sut.ask(question);
    sut.tick(0);
    sut.ask({ ...question, policy: "none" });
    sut.tick(20_000);
    assert.equal(asked.length, 1);
    waiting[0]?.({ rows: [] });
    await settle();
    assert.equal(sut.result, undefined);
    sut.tick(20_050);
    assert.equal(asked[1]?.policy, "none");
  });
  it("says why there is no answer", async () => {
    const { sut, offsets } = setUp();
    sut.ask({ ...question, changes: "alpha" });
    sut.tick(0);
    await settle();
    assert.match(sut.trouble, /is no parameter=value/);
    offsets.uxv = undefined;
    sut.ask(question);
    sut.tick(0);
    await settle();
    assert.match(sut.trouble, /no decision of this side was heard/);
  });
});

describe("RecordOrder", () => {
  it("asks once, and is done when the recorder says so", () => {
    const sut = new RecordOrder();
    sut.onValue(false);
    sut.ask(true, 0);
    assert.equal(sut.due(0), true);
    assert.equal(sut.due(50), undefined);
    assert.ok(sut.pending);
    sut.onValue(true);
    assert.deepEqual([sut.recording, sut.pending, sut.unheeded], [true, false, false]);
    assert.equal(sut.due(9000), undefined);
    assert.equal(sut.unheeded, false);
  });
  it("asks again what could not be sent", () => {
    const sut = new RecordOrder();
    sut.ask(true, 0);
    assert.equal(sut.due(0), true);
    sut.notSent();
    assert.equal(sut.due(50), true);
  });
  it("gives up after 5 s", () => {
    const sut = new RecordOrder();
    sut.onValue(false);
    sut.ask(true, 0);
    sut.due(0);
    sut.onValue(false); // of before
    assert.equal(sut.due(5000), undefined);
    assert.ok(sut.pending);
    sut.due(5001);
    assert.deepEqual([sut.pending, sut.unheeded, sut.recording], [false, true, false]);
  });
  it("does not know what a recorder does that is not heard", () => {
    const sut = new RecordOrder();
    sut.onValue(true);
    sut.forget();
    assert.equal(sut.recording, undefined);
    sut.onValue(null);
    assert.equal(sut.recording, undefined);
  });
});
