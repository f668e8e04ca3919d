// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { historyOf, rowsOf } from "../src/model/history.ts";
import { Station } from "../src/model/station.ts";
import * as make from "./messages.ts";

const locations = [
  "receive_s,pose.pose.position.x,pose.pose.position.y,pose.pose.orientation.z,pose.pose.orientation.w",
  ...[0, 1, 2, 3, 4].map((x) => `${100 + x},${x},${x % 2},0,1`),
].join("\n") + "\n";
const decisions = "receive_s,role,active,qni\n99,gcs,0,10\n99,uxv,1,80\n102,uxv,0,20\n";
const tables = { location: rowsOf(locations), transmission_state: rowsOf(decisions) };

describe("rowsOf", () => {
  it("reads quoted cells, and leaves out what is still being written", () => {
    assert.deepEqual(rowsOf('a,b\n1,"x,""y"""\n,2\n3,'), [{ a: "1", b: 'x,"y"' }, { a: "", b: "2" }]);
    assert.deepEqual(rowsOf("a,b\n1\n"), []);
    assert.deepEqual(rowsOf(""), []);
    assert.deepEqual(rowsOf("a,b"), []);
  });
});

describe("History", () => {
  it("colours the trail by the vehicle's QNI and gate of then", () => {
    const { trail } = historyOf(tables);
    const told = [...trail.points, trail.tail].map((one) => (one === "gap" || !one ? one : [one.x, one.step, one.paused]));
    assert.deepEqual(told, [[0, 4, false], [1, 4, false], [2, 0, true], [3, 0, true], [4, 0, true]]);
  });
  it("leaves out positions that are none, and knows nothing of empty tables", () => {
    const location = rowsOf("receive_s,pose.pose.position.x,pose.pose.position.y\n1,,2\n");
    const { trail } = historyOf({ location, transmission_state: [] });
    assert.deepEqual([trail.points, trail.tail], [[], undefined]);
  });
  it("gives a page that opens late the trail of before", () => {
    const sut = new Station();
    sut.onMessage("location", make.location(4.5, 0), 1000);
    sut.onMessage("location", make.location(5, 0.5), 1100);
    sut.onHistory(historyOf(tables));
    assert.deepEqual(sut.trail.points.map((one) => (one === "gap" ? one : one.x)), [0, 1, 2, 3, 4, 4.5]);
    assert.deepEqual([sut.trail.tail?.x, sut.trail.bounds?.min.x, sut.trail.bounds?.max.x], [5, 0, 5]);
  });
  it("draws no line over a stretch of which nothing is known", () => {
    const sut = new Station();
    sut.onMessage("location", make.location(9, 9), 1000);
    sut.onHistory(historyOf(tables));
    assert.equal(sut.trail.points.at(-2), "gap");
  });
});
