// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { addressesOf, socketOf, withToken } from "../src/fleet/addresses.ts";
import { Alarms } from "../src/fleet/alarms.ts";
import { type Finding, byUrgency } from "../src/fleet/member.ts";
import { findingOf } from "../src/model/alerts.ts";
import { Station } from "../src/model/station.ts";

const finding = (severity: Finding["severity"], kind: Finding["kind"], text = "it is so"): Finding => ({ severity, kind, text });
const shown = (alarms: Alarms): string[] =>
  alarms.list.map(({ vehicle, kind, until, acknowledged, times }) =>
    [vehicle, kind, until === undefined ? "stands" : "over", acknowledged ? "known" : "", times].join(" "));

describe("Fleet addresses", () => {
  it("are read as the server tells them", () => {
    assert.deepEqual(addressesOf("uxv1=http://a:1/ uxv2=https://b/x=1"), [
      { name: "uxv1", page: "http://a:1/" },
      { name: "uxv2", page: "https://b/x=1" },
    ]);
    assert.deepEqual(addressesOf(""), []);
  });
  it("have the page's token, and the socket beside them", () => {
    assert.equal(withToken("http://a:1/", "http://b/fleet.html?token=abc"), "http://a:1/?token=abc");
    assert.equal(withToken("http://a:1/", "http://b/fleet.html"), "http://a:1/");
    assert.equal(socketOf("https://a:1/fleet.html?token=a%20b&x=1#y"), "wss://a:1/?token=a%20b");
    assert.equal(socketOf("http://a/under/"), "ws://a/under/");
  });
});

/** Told again until it has lasted long enough. */
const lasts = (alarms: Alarms, vehicle: string, what: Finding, at: number): void => {
  for (const later of [0, 1000]) alarms.onFinding(vehicle, what, at + later);
};

describe("Alarms", () => {
  it("begin when it has been so for a second; the stop at once", () => {
    const alarms = new Alarms();
    alarms.onFinding("uxv1", finding("error", "silence"), 0);
    alarms.onFinding("uxv1", finding("error", "silence"), 999);
    alarms.onFinding("uxv2", finding("error", "safety"), 999);
    assert.deepEqual(shown(alarms), ["uxv2 safety stands  1"]);
    alarms.onFinding("uxv1", finding("error", "silence"), 1000);
    assert.equal(alarms.list[0]?.since, 0);
    assert.deepEqual(shown(alarms), ["uxv1 silence stands  1", "uxv2 safety stands  1"]);
  });
  it("stand while it is so, and stay until they are acknowledged", () => {
    const alarms = new Alarms();
    lasts(alarms, "uxv1", finding("error", "silence"), 0);
    alarms.onFinding("uxv1", finding("error", "silence", "for longer"), 1010);
    assert.deepEqual(shown(alarms), ["uxv1 silence stands  1"]);
    assert.equal(alarms.list[0]?.text, "for longer");
    alarms.onFinding("uxv1", finding("well", "well"), 1020);
    assert.deepEqual(shown(alarms), ["uxv1 silence over  1"]);
    assert.equal(alarms.list[0]?.until, 1020);
    alarms.acknowledge(alarms.list[0]!);
    assert.deepEqual(shown(alarms), []);
  });
  it("that are acknowledged stay until they are over", () => {
    const alarms = new Alarms();
    lasts(alarms, "uxv1", finding("warning", "link"), 0);
    alarms.acknowledge(alarms.list[0]!);
    assert.deepEqual(shown(alarms), ["uxv1 link stands known 1"]);
    alarms.onFinding("uxv1", finding("info", "unknown"), 1010);
    assert.deepEqual(shown(alarms), []);
  });
  it("that begin again are one that is counted", () => {
    const alarms = new Alarms();
    for (const at of [0, 2000, 4000]) {
      lasts(alarms, "uxv1", finding("warning", "link"), at);
      alarms.onFinding("uxv1", finding("well", "well"), at + 1500);
    }
    assert.deepEqual(shown(alarms), ["uxv1 link over  3"]);
  });
  it("are each vehicle's own, the newest first", () => {
    const alarms = new Alarms();
    lasts(alarms, "uxv1", finding("warning", "link"), 0);
    lasts(alarms, "uxv2", finding("error", "safety"), 2000);
    lasts(alarms, "uxv1", finding("error", "silence"), 4000);
    assert.deepEqual(shown(alarms), ["uxv1 silence stands  1", "uxv2 safety stands  1", "uxv1 link over  1"]);
  });
  it("tell nothing that nobody needs to look at", () => {
    const alarms = new Alarms();
    for (const severity of ["well", "info"] as const) lasts(alarms, "uxv1", finding(severity, "unknown"), 0);
    assert.deepEqual(shown(alarms), []);
  });
});

describe("The list", () => {
  it("has first who needs a person", () => {
    const all = [
      { name: "uxv10", finding: finding("well", "well") },
      { name: "uxv9", finding: finding("well", "well") },
      { name: "uxv3", finding: finding("warning", "link") },
      { name: "uxv4", finding: finding("warning", "motion") },
      { name: "uxv5", finding: finding("error", "safety") },
      { name: "uxv6", finding: finding("error", "silence") },
      { name: "uxv7", finding: finding("info", "unknown") },
    ];
    assert.deepEqual(all.sort(byUrgency).map(({ name }) => name), ["uxv6", "uxv5", "uxv4", "uxv3", "uxv7", "uxv9", "uxv10"]);
  });
  it("knows what a finding is about", () => {
    const lost = { phase: "lost", since: 0, tries: 3, reason: "" } as const;
    assert.equal(findingOf(lost, new Station(), 2000).kind, "connection");
    assert.equal(findingOf({ ...lost, phase: "open" }, new Station(), 2000).kind, "silence");
  });
});
