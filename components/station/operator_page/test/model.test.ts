// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { ageText, freshness } from "../src/model/freshness.ts";
import { type Point, distance, ellipse95, yawOf } from "../src/model/geometry.ts";
import { Journal } from "../src/model/journal.ts";
import { LinkClasses } from "../src/model/link_classes.ts";
import { qualityStep } from "../src/model/quality.ts";
import { Route } from "../src/model/route.ts";
import { DecisionSeries, pauses } from "../src/model/series.ts";
import { SourceClock, stampMs } from "../src/model/source_clock.ts";
import { Station, hindrances } from "../src/model/station.ts";
import { TrafficTable } from "../src/model/traffic.ts";
import { Trail, longestTrail } from "../src/model/trail.ts";
import type * as m from "../src/model/messages.ts";
import * as make from "./messages.ts";

describe("Freshness", () => {
  it("is stale after 3 s and unknown after 30 s, and what was never heard is unknown", () => {
    assert.equal(freshness(1000, 4000), "fresh");
    assert.equal(freshness(1000, 4001), "stale");
    assert.equal(freshness(1000, 31_000), "stale");
    assert.equal(freshness(1000, 31_001), "unknown");
    assert.equal(freshness(undefined, 0), "unknown");
  });
  it("tells an age in the unit that fits", () => {
    assert.deepEqual([0, 400, 9949, 12_000, 99_400, 180_000, 7_200_000].map(ageText),
      ["0.0 s", "0.4 s", "9.9 s", "12 s", "99 s", "3 min", "2 h"]);
  });
});

describe("SourceClock", () => {
  it("counts what took longer than the quickest as older, whatever the clocks say", () => {
    const sut = new SourceClock();
    const offset = 3_600_000;
    assert.equal(sut.heardAt(1000, 1000 + offset), 1000 + offset);
    assert.equal(sut.heardAt(2000, 2400 + offset), 2000 + offset);
  });
  it("never tells the future", () => {
    const sut = new SourceClock();
    sut.heardAt(1000, 5000);
    assert.equal(sut.heardAt(9000, 6000), 6000);
  });
  it("forgets a clock that was set, after a minute", () => {
    const sut = new SourceClock();
    sut.heardAt(100_000, 0);
    assert.equal(sut.heardAt(0, 1000), -100_000);
    sut.heardAt(31_000, 32_000);
    assert.equal(sut.heardAt(61_500, 63_000), 62_500);
  });
  it("takes a stamp of zero for none", () => {
    assert.equal(stampMs({ sec: 0, nanosec: 0 }), undefined);
    assert.equal(stampMs({ sec: 2, nanosec: 500_000_000 }), 2500);
  });
});

describe("Geometry", () => {
  it("takes the heading from a quaternion", () => {
    assert.ok(Math.abs(yawOf({ x: 0, y: 0, z: Math.SQRT1_2, w: Math.SQRT1_2 }) - Math.PI / 2) < 1e-12);
  });
  it("draws the ellipse of 95 % along its longer axis", () => {
    const covariance = new Float64Array(36);
    covariance[0] = 0.01;
    covariance[7] = 0.04;
    const found = ellipse95(covariance);
    assert.ok(Math.abs((found?.major ?? 0) - 2.4477 * 0.2) < 1e-4);
    assert.ok(Math.abs((found?.minor ?? 0) - 2.4477 * 0.1) < 1e-4);
    assert.ok(Math.abs((found?.angle ?? 0) - Math.PI / 2) < 1e-12);
  });
  it("knows no ellipse of a covariance that says nothing or is none", () => {
    const of = (xx: number, xy: number, yy: number) => ellipse95([xx, xy, 0, 0, 0, 0, xy, yy]);
    assert.equal(of(0, 0, 0), undefined);
    assert.equal(of(NaN, 0, 1), undefined);
    assert.equal(of(1, 2, 1), undefined);
  });
});

describe("Quality", () => {
  it("has five steps, and none for what was not measured", () => {
    assert.deepEqual([0, 29.9, 30, 45, 60, 75, 100].map(qualityStep), [0, 0, 1, 2, 3, 4, 4]);
    assert.equal(qualityStep(NaN), undefined);
    assert.equal(qualityStep(undefined), undefined);
  });
});

describe("Trail", () => {
  const drive = (sut: Trail, way: (s: number) => { x: number; y: number }, steps: number) => {
    for (let i = 0; i <= steps; ++i) sut.add(way(i / steps), 80, false);
  };
  it("needs two places for a straight line, however long", () => {
    const sut = new Trail();
    drive(sut, (s) => ({ x: 30 * s, y: 10 * s }), 1000);
    assert.equal(sut.points.length, 1);
    assert.deepEqual([sut.tail?.x, sut.tail?.y], [30, 10]);
  });
  it("is nowhere farther than 2 cm from the way, in curves either", () => {
    const sut = new Trail();
    const way = (s: number) => ({ x: 3 * Math.cos(6 * s), y: 3 * Math.sin(6 * s) });
    drive(sut, way, 300);
    const line = [...sut.points, sut.tail].filter((one) => one !== undefined && one !== "gap");
    assert.ok(line.length < 60, `${line.length} points`);
    for (let i = 0; i <= 300; ++i) {
      const place = way(i / 300);
      const off = line.slice(1).map((to, index) => distanceToStretch(place, line[index] ?? to, to));
      assert.ok(Math.min(...off) < 0.021, `${Math.min(...off)} m at ${i}`);
    }
  });
  it("has a corner where the vehicle turns back", () => {
    const sut = new Trail();
    drive(sut, (s) => ({ x: s < 0.5 ? 4 * s : 4 - 4 * s, y: 0 }), 40);
    assert.deepEqual(sut.points.map((one) => one !== "gap" && one.x), [0, 2]);
    assert.equal(sut.tail?.x, 0);
  });
  it("has a point where the quality changes", () => {
    const sut = new Trail();
    drive(sut, (s) => ({ x: s, y: 0 }), 10);
    sut.add({ x: 1.1, y: 0 }, 20, true);
    assert.equal(sut.points.length, 2);
    assert.deepEqual(sut.tail, { x: 1.1, y: 0, step: 0, paused: true });
  });
  it("draws no line over a stretch that was not heard", () => {
    const sut = new Trail();
    sut.add({ x: 0, y: 0 }, 80, false);
    sut.add({ x: 2.5, y: 0 }, 80, false);
    assert.equal(sut.points[1], "gap");
  });
  it("does not grow while the vehicle stands", () => {
    const sut = new Trail();
    for (let i = 0; i < 1000; ++i) sut.add({ x: 0.01 * Math.sin(i), y: 0 }, 80, false);
    assert.deepEqual([sut.points.length, sut.tail], [1, undefined]);
  });
  it("knows its bounds until it is cleared", () => {
    const sut = new Trail();
    drive(sut, (s) => ({ x: 4 - 8 * s, y: 3 * s }), 50);
    assert.deepEqual(sut.bounds, { min: { x: -4, y: 0 }, max: { x: 4, y: 3 } });
    sut.clear();
    assert.deepEqual([sut.bounds, sut.points.length, sut.cuts], [undefined, 0, 1]);
  });
  it("forgets its beginning when it is long", () => {
    const sut = new Trail();
    for (let i = 0; i < longestTrail + 10; ++i) sut.add({ x: 0.1 * i, y: i % 2 }, 80, false);
    assert.ok(sut.points.length <= longestTrail);
    assert.equal(sut.cuts, 1);
    assert.notDeepEqual(sut.points[0], { x: 0, y: 0, step: 4, paused: false });
  });
});

function distanceToStretch(p: Point, a: Point, b: Point): number {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const share = Math.max(0, Math.min(1, ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy || 1)));
  return distance(p, { x: a.x + share * dx, y: a.y + share * dy });
}

describe("TrafficTable", () => {
  it("counts what came against what was sent in the same time", () => {
    const sut = new TrafficTable();
    sut.onReport(make.trafficReport([make.topicTraffic("location", 100)]), 0);
    for (let i = 1; i <= 8; ++i) sut.onSample("location", i * 200);
    sut.onReport(make.trafficReport([make.topicTraffic("location", 110)]), 2000);
    const [row] = sut.rows(2000);
    assert.deepEqual([row?.received, row?.sent], [8, 10]);
    assert.equal(row?.ageMs, 400);
    assert.equal(row?.rateHz, 8 / 5);
  });
  it("costs each sample of a burst the same, and counts the last 5 s of it", () => {
    const sut = new TrafficTable();
    sut.onReport(make.trafficReport([make.topicTraffic("location", 0)]), 0);
    let visited = 0;
    const filter = Array.prototype.filter;
    Array.prototype.filter = function (this: unknown[], keep: (one: unknown) => boolean) {
      visited += this.length;
      return filter.call(this, keep);
    } as typeof filter;
    try {
      for (let i = 0; i < 100_000; ++i) sut.onSample("location", 10_000 + i / 100);
    } finally {
      Array.prototype.filter = filter;
    }
    assert.ok(visited < 400_000, `${visited} looked at`);
    assert.equal(sut.rows(11_000)[0]?.rateHz, 20_000);
    for (let i = 1; i <= 200_000; ++i) sut.onSample("location", 20_000 + i / 20);
    assert.equal(sut.rows(30_000)[0]?.rateHz, 20_000.2);
  });
  it("begins anew when the writer was restarted", () => {
    const sut = new TrafficTable();
    sut.onReport(make.trafficReport([make.topicTraffic("location", 100)]), 0);
    sut.onSample("location", 1);
    sut.onReport(make.trafficReport([make.topicTraffic("location", 3)]), 1000);
    const [row] = sut.rows(1000);
    assert.deepEqual([row?.received, row?.sent], [0, 0]);
  });
  it("orders by class, then by name, unknown classes last", () => {
    const sut = new TrafficTable();
    const of = (topic: string, traffic_class: string) => make.topicTraffic(topic, 0, { traffic_class });
    sut.onReport(make.trafficReport([of("d", "odd"), of("b", "low"), of("c", "critical"), of("a", "low")]), 0);
    assert.deepEqual(sut.rows(0).map(({ topic }) => topic), ["c", "a", "b", "d"]);
  });
  it("does not show a topic that nobody reported", () => {
    const sut = new TrafficTable();
    sut.onSample("goal", 0);
    assert.equal(sut.rows(0).length, 0);
  });
});

describe("LinkClasses", () => {
  it("makes rates of counts over the last 5 s", () => {
    const sut = new LinkClasses();
    for (let s = 0; s <= 8; ++s) {
      const counts = { delivered: BigInt(10 * s), bytes: BigInt(1000 * s) };
      sut.onState(make.linkState([make.linkClass(counts)]), s * 1000);
    }
    assert.equal(sut.rows()[0]?.deliveredHz, 10);
    assert.equal(sut.rows()[0]?.bytesPerS, 1000);
  });
  it("knows no rate at first, nor after the router was restarted", () => {
    const sut = new LinkClasses();
    sut.onState(make.linkState([make.linkClass({ bytes: 5000n })]), 0);
    assert.equal(sut.rows()[0]?.bytesPerS, undefined);
    sut.onState(make.linkState([make.linkClass({ bytes: 10n })]), 1000);
    assert.equal(sut.rows()[0]?.bytesPerS, undefined);
  });
  it("adds up what was not sent for other reasons than the gate", () => {
    const sut = new LinkClasses();
    const counts = { dropped_paused: 9n, dropped_superseded: 3n, dropped_expired: 3n, dropped_overflow: 4n };
    sut.onState(make.linkState([make.linkClass(counts)]), 0);
    assert.equal(sut.rows()[0]?.paused, 9);
    assert.equal(sut.rows()[0]?.otherDropped, 10);
  });
});

describe("DecisionSeries", () => {
  it("keeps ten minutes, and no number that is none", () => {
    const sut = new DecisionSeries();
    for (let s = 0; s < 3600; ++s) sut.onState(make.transmission({ statistic: NaN }), s * 1000);
    assert.ok(sut.decisions.length >= 600 && sut.decisions.length <= 661, String(sut.decisions.length));
    assert.equal(sut.decisions[0]?.statistic, null);
  });
  it("tells when the gate was closed, and that it still is", () => {
    const sut = new DecisionSeries();
    [true, false, false, true, false].forEach((active, s) => sut.onState(make.transmission({ active }), s * 1000));
    assert.deepEqual(pauses(sut.decisions), [[1000, 3000], [4000, Infinity]]);
  });
});

describe("Route", () => {
  type Place = { x: number; y: number; yaw: number; send_s: number };
  const [a, b, c] = [1, 2, 3].map((x) => ({ x, y: 0, yaw: 0, send_s: 0 })) as [Place, Place, Place];
  it("keeps mission_control's path while goals of others and that of a pause are heard", () => {
    const sut = new Route();
    const mission = { waypoints: 3, waypoint: 1 };
    sut.onPath([a, b, c]);
    sut.onMission(make.mission(mission));
    sut.onGoal(make.goal({ ...b, waypoint: 1 }));
    for (const other of [{ mission: 99n }, { waypoint: 1 }]) sut.onGoal(make.goal({ x: 9, y: 9, ...other }));
    assert.deepEqual(sut.points().map(({ x, state }) => [x, state]), [[1, "passed"], [2, "present"], [3, "ahead"]]);
    sut.onMission(make.mission({ ...mission, state: "aborted" }));
    sut.onGoal(make.goal({ x: 9, y: 9, mission: 99n }));
    assert.deepEqual(sut.points().map(({ x }) => x), [9]);
  });
  it("learns the waypoints from goals and keeps those that were passed", () => {
    const sut = new Route();
    sut.onGoal(make.goal({ ...a, ahead: [b] }));
    sut.onGoal(make.goal({ ...b, id: 2n, waypoint: 1, ahead: [c] }));
    assert.deepEqual(sut.points().map(({ number, state }) => [number, state]),
      [[1, "passed"], [2, "present"], [3, "ahead"]]);
  });
  it("follows a vehicle that has gone on by itself", () => {
    const sut = new Route();
    sut.onGoal(make.goal({ ...a, ahead: [b, c] }));
    sut.onStatus(make.navigation({ mission: 7n, goal_id: 3n, state: "driving" }));
    assert.deepEqual(sut.points().map(({ state }) => state), ["passed", "passed", "present"]);
    sut.onStatus(make.navigation({ mission: 7n, goal_id: 3n, state: "reached" }));
    assert.deepEqual(sut.points().map(({ state }) => state), ["passed", "passed", "passed"]);
  });
  it("begins anew with another mission, and goes on with the same one under a new identity", () => {
    const sut = new Route();
    sut.onGoal(make.goal({ ...a, mission: (1n << 32n) + 7n }));
    sut.onGoal(make.goal({ ...b, waypoint: 1, id: 2n, mission: (2n << 32n) + 7n }));
    assert.equal(sut.points().length, 2);
    sut.onGoal(make.goal({ ...c, mission: 8n }));
    assert.equal(sut.points().length, 1);
  });
  it("is all of mission_control's mission for a page that opens in the middle", () => {
    const sut = new Route();
    sut.onPath([a, b, c]);
    sut.onMission(make.mission({ waypoint: 1, waypoints: 3 }));
    assert.deepEqual(sut.points().map(({ number, x, state }) => [number, x, state]),
      [[1, 1, "passed"], [2, 2, "present"], [3, 3, "ahead"]]);
    sut.onMission(make.mission({ waypoint: 0, waypoints: 9 })); // of a mission whose path is still to come
    assert.equal(sut.points()[1]?.state, "present");
    sut.onMission(make.mission({ waypoint: 2, waypoints: 3, state: "done" }));
    assert.ok(sut.points().every(({ state }) => state === "passed"));
  });
  it("keeps the whole mission when its goals come, and gives it up for the goal of another", () => {
    const sut = new Route();
    sut.onPath([a, b, c]);
    sut.onGoal(make.goal({ ...b, id: 2n, waypoint: 1 }));
    assert.deepEqual(sut.points().map(({ state }) => state), ["passed", "present", "ahead"]);
    sut.onPath([c, b]);
    assert.deepEqual(sut.points().map(({ x, state }) => [x, state]), [[3, "present"], [2, "ahead"]]);
    sut.onGoal(make.goal({ ...a, mission: 8n }));
    assert.deepEqual(sut.points().map(({ x }) => x), [1]);
  });
  it("does not take the status of another mission for its own", () => {
    const sut = new Route();
    sut.onGoal(make.goal({ ...a, ahead: [b] }));
    sut.onStatus(make.navigation({ mission: 9n, goal_id: 2n, state: "driving" }));
    assert.equal(sut.points()[0]?.state, "present");
  });
});

describe("Journal", () => {
  const entry = (text: string) => ({ at: 0, severity: "info", source: "x", text }) as const;
  it("counts what repeats itself", () => {
    const sut = new Journal();
    sut.add(entry("a"));
    sut.add(entry("a"));
    sut.add(entry("b"));
    assert.deepEqual(sut.entries.map(({ text, times }) => [text, times]), [["b", 1], ["a", 2]]);
  });
  it("keeps the order of time, whenever messages come", () => {
    const sut = new Journal();
    for (const [text, at] of [["a", 1000], ["c", 3000], ["b", 2000], ["b", 2500], ["0", 500]] as const) sut.add({ ...entry(text), at });
    assert.deepEqual(sut.entries.map(({ text, at, times }) => [text, at, times]), [["c", 3000, 1], ["b", 2500, 2], ["a", 1000, 1], ["0", 500, 1]]);
  });
  it("says a change once", () => {
    const sut = new Journal();
    for (const text of ["a", "a", "", "a"]) sut.onChange("subject", entry(text));
    assert.equal(sut.entries.length, 1);
    assert.equal(sut.entries[0]?.times, 2);
  });
});

describe("Station", () => {
  it("puts tiles that changed into its map, and none that is of another one", () => {
    const sut = new Station();
    const tile = (changes: Partial<m.OccupancyGridUpdate>) =>
      ({ header: { stamp: make.stampOf(0), frame_id: "map" }, x: 1, y: 1, width: 2, height: 1, data: Int8Array.of(100, 0), ...changes });
    sut.onMessage("map_updates", tile({}), 1);
    assert.equal(sut.map, undefined, "there is no map yet");
    sut.onMessage("map", make.grid(0.05, 3, Int8Array.of(-1, -1, -1, -1, -1, -1)), 2);
    const before = sut.map;
    for (const bad of [{ x: 2 }, { y: 2 }, { x: -1 }, { height: 2 }, { data: Int8Array.of(1) }]) sut.onMessage("map_updates", tile(bad), 3);
    assert.equal(sut.map, before);
    sut.onMessage("map_updates", tile({}), 4);
    const cells = (map: unknown): number[] => Array.from((map as m.OccupancyGrid).data);
    assert.deepEqual(cells(sut.map), [-1, -1, -1, -1, 100, 0]);
    assert.deepEqual(cells(before), [-1, -1, -1, -1, -1, -1], "who has drawn it has its own");
  });
  it("keeps where the vehicle is, and its trail coloured by the link", () => {
    const sut = new Station();
    sut.onMessage("transmission_state", make.transmission({ qni: 20, active: false }), 900);
    sut.onMessage("location", make.location(1, 2), 1000);
    assert.deepEqual([sut.location?.value.x, sut.location?.value.y, sut.location?.at], [1, 2, 1000]);
    assert.deepEqual(sut.trail.points, [{ x: 1, y: 2, step: 0, paused: true }]);
  });
  it("ignores a location that is not finite", () => {
    const sut = new Station();
    sut.onMessage("location", make.location(NaN, 2), 1000);
    assert.equal(sut.location, undefined);
  });
  it("makes what was long on its way as old as it is", () => {
    const sut = new Station();
    sut.onMessage("location", make.location(0, 0, 10_000), 50_000);
    sut.onMessage("location", make.location(0, 0, 11_000), 53_000);
    assert.equal(sut.location?.at, 51_000);
    assert.equal(sut.vehicleHeard, 51_000);
  });
  it("does not take the station's own words for the vehicle's", () => {
    const sut = new Station();
    sut.onMessage("transmission_state", make.transmission({ role: "gcs" }), 1000);
    sut.onMessage("mission_status", make.mission({}), 1000);
    assert.equal(sut.vehicleHeard, undefined);
  });
  it("holds what is told on changes only, as long as its writer is heard", () => {
    const sut = new Station();
    sut.onMessage("safety_status", make.safety({ bumper: 1 }), 1000);
    sut.onMessage("traffic_report", make.trafficReport([make.topicTraffic("safety_status", 1)]), 60_000);
    assert.equal(sut.safety?.at, 60_000);
    sut.onMessage("traffic_report", make.trafficReport([make.topicTraffic("location", 1)]), 70_000);
    assert.equal(sut.safety?.at, 60_000);
  });
  it("remembers why the gate was closed while later samples are steady", () => {
    const sut = new Station();
    sut.onMessage("transmission_state", make.transmission({}), 1000);
    sut.onMessage("transmission_state", make.transmission({ active: false, reason: "cusum_alarm" }), 2000);
    sut.onMessage("transmission_state", make.transmission({ active: false, reason: "steady" }), 3000);
    assert.equal(sut.uxv.pausedBecause, "cusum_alarm");
    assert.deepEqual(sut.journal.entries.map(({ text }) => text), ["vehicle pauses: quality has fallen"]);
    sut.onMessage("transmission_state", make.transmission({ reason: "best_so_far" }), 4000);
    assert.equal(sut.journal.entries[0]?.text, "vehicle sends all again: quality is the best of the pause");
  });
  it("tells by their bits what hinders the vehicle", () => {
    assert.deepEqual(hindrances(make.safety()), []);
    const status = make.safety({ emergency_stop: true, stopped_by: ["station", "app"], bumper: 5, enabled: false });
    assert.deepEqual(hindrances(status), [
      "emergency stop of station and app",
      "bumper right and left",
      "bumper, cliff and wheel drop are not looked at",
    ]);
  });
  it("writes a finding of diagnostics down once, not with each report", () => {
    const sut = new Station();
    const report = make.diagnostics("drive", 2, "no frames");
    for (const at of [1000, 2000]) sut.onMessage("diagnostics", report, at);
    assert.equal(sut.journal.entries.length, 1);
    assert.equal(sut.journal.entries[0]?.severity, "error");
  });
});
