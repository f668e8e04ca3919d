// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { alertOf, resumesInS } from "../src/model/alerts.ts";
import { type LinkFigures, type LinkWord, figuresOf, gradeLink } from "../src/model/link_grade.ts";
import { Station } from "../src/model/station.ts";
import { stripOf } from "../src/model/strip.ts";
import * as make from "./messages.ts";

const open = { phase: "open", since: 0, tries: 0, reason: "" } as const;

interface Told {
  per?: number;
  qni?: number;
  loss?: number;
  backlogS?: number;
}

/** A station that has heard a vehicle since 0, each half second until `until` [ms]; positions until `positionUntil`. */
function heard(until: number, told: Told = {}, positionUntil = until): Station {
  const station = new Station();
  for (let at = 0; at <= until; at += 500) {
    const stamp = make.stampOf(1_000_000 + at);
    if (at <= positionUntil) station.onMessage("location", make.location(0, 0, 1_000_000 + at), at);
    station.onMessage("heartbeat", make.heartbeat(1_000_000 + at), at);
    station.onMessage("network_quality", make.quality({ stamp, per_percent: told.per ?? 0 }), at);
    station.onMessage("transmission_state", make.transmission({ stamp, qni: told.qni ?? 90 }), at);
    const link = { ...make.linkState([]), stamp, loss: (told.loss ?? 0) / 100, backlog_s: told.backlogS ?? 0 };
    station.onMessage("link_state", link, at);
  }
  station.onMessage("safety_status", make.safety(), until);
  return station;
}
const textAt = (station: Station, now: number): string => alertOf(open, station, now).text;

describe("LinkGrade", () => {
  const good: LinkFigures = { perPercent: 0, qni: 90, lossPercent: 0, ageMs: 100 };
  const rows: [changes: Partial<LinkFigures>, word: LinkWord, figures: string[]][] = [
    [{}, "very good", ["PER 0 %", "QNI 90", "loss 0 %", "position 0.1 s old"]],
    [{ perPercent: 40, qni: 42, lossPercent: 48 }, "very poor", ["PER 40 %", "loss 48 %", "QNI 42"]],
    [{ perPercent: 4.9 }, "very good", ["PER 5 %", "QNI 90", "loss 0 %", "position 0.1 s old"]],
    [{ perPercent: 9.9 }, "good", ["PER 10 %", "QNI 90", "loss 0 %", "position 0.1 s old"]],
    [{ perPercent: 10 }, "fair", ["PER 10 %"]],
    [{ perPercent: 20 }, "poor", ["PER 20 %"]],
    [{ perPercent: 39.9 }, "poor", ["PER 40 %"]],
    [{ qni: 60 }, "good", ["PER 0 %", "QNI 60", "loss 0 %", "position 0.1 s old"]],
    [{ qni: 59.9 }, "fair", ["QNI 60"]],
    [{ qni: 29.9 }, "very poor", ["QNI 30"]],
    [{ lossPercent: 10 }, "fair", ["loss 10 %"]],
    [{ lossPercent: 48 }, "very poor", ["loss 48 %"]],
    [{ ageMs: 999 }, "good", ["PER 0 %", "QNI 90", "loss 0 %", "position 1.0 s old"]],
    [{ ageMs: 1000 }, "fair", ["position 1.0 s old"]],
    [{ ageMs: 3000 }, "poor", ["position 3.0 s old"]],
    [{ ageMs: 6000, perPercent: 12 }, "very poor", ["position 6.0 s old", "PER 12 %"]],
    [{ perPercent: undefined, qni: undefined, lossPercent: undefined }, "unknown", []],
    [{ ageMs: undefined }, "unknown", []],
    [{ ageMs: undefined, perPercent: 40 }, "very poor", ["PER 40 %"]],
    [{ perPercent: undefined, qni: 42 }, "poor", ["QNI 42"]],
  ];
  it("is that of the worst figure, which it names, and unknown where nothing was measured", () => {
    for (const [changes, word, figures] of rows) {
      const told = gradeLink({ ...good, ...changes });
      assert.deepEqual([told.word, told.figures], [word, figures], JSON.stringify(changes));
    }
  });
  it("is good only at the words good and very good", () => {
    for (const [changes, word] of rows) {
      assert.equal(gradeLink({ ...good, ...changes }).isGood, word === "good" || word === "very good", word);
    }
  });
  it("takes the worse side, and no measurement that is older than 5 s", () => {
    const station = heard(4000, { qni: 80, loss: 3 });
    station.onMessage("transmission_state", make.transmission({ role: "gcs", qni: 42 }), 4000);
    assert.deepEqual(figuresOf(station, 4000), { perPercent: 0, qni: 42, lossPercent: 3, ageMs: 0 });
    assert.equal(figuresOf(station, 9000).qni, 42);
    assert.equal(figuresOf(station, 9001).qni, undefined);
    assert.equal(figuresOf(station, 9001).perPercent, undefined);
  });
  it("takes the lowest QNI of the last 3 s, as samples scatter", () => {
    const station = heard(4000, { qni: 59 });
    station.onMessage("transmission_state", make.transmission({ stamp: make.stampOf(1_004_500), qni: 80 }), 4500);
    assert.equal(figuresOf(station, 7000).qni, 59);
    assert.equal(figuresOf(station, 7001).qni, 80);
  });
  it("knows no quality where the hardware gives none", () => {
    const station = heard(4000, { per: NaN, qni: NaN });
    assert.deepEqual(gradeLink(figuresOf(station, 4000)), { word: "unknown", isGood: false, figures: [] });
  });
  it("counts what waits in the vehicle's radio as age of the position", () => {
    assert.equal(figuresOf(heard(4000, { backlogS: 4 }), 4000).ageMs, 4000);
  });
});

describe("Alert", () => {
  it("says that all is well when link, position and safety are known and good", () => {
    const alert = alertOf(open, heard(4000), 4000);
    assert.equal(alert.severity, "well");
    assert.equal(alert.text, "All is well. The link is very good: PER 0 %, QNI 90, loss 0 %, position 0.0 s old.");
  });
  it("says well at no figure below good, and names the figure", () => {
    const rows: [Told, "info" | "warning", string][] = [
      [{ per: 40, qni: 42, loss: 48 }, "warning", "The link is very poor: PER 40 %, loss 48 %, QNI 42."],
      [{ per: 12 }, "info", "The link is fair: PER 12 %."],
      [{ qni: 42 }, "warning", "The link is poor: QNI 42."],
      [{ loss: 25 }, "warning", "The link is poor: loss 25 %."],
      [{ backlogS: 2 }, "info", "The link is fair: position 2.0 s old."],
    ];
    for (const [told, severity, text] of rows) {
      assert.deepEqual(alertOf(open, heard(4000, told), 4000), { severity, text });
    }
  });
  it("says how old the position is while other messages come", () => {
    assert.match(textAt(heard(9000, {}, 5000), 9000), /^The link is poor: position 4.0 s old/);
  });
  it("calls nothing well in the first 2 s, as messages may come late", () => {
    assert.equal(textAt(heard(1500), 1500), "The vehicle is received; how late is not known yet.");
    assert.equal(alertOf(open, heard(2000), 2000).severity, "well");
  });
  it("tells what it does not know yet in place of well", () => {
    const station = new Station();
    for (const at of [0, 500, 2500]) station.onMessage("heartbeat", make.heartbeat(at + 1), at);
    assert.equal(textAt(station, 2500), "The vehicle is received, but not its position, not the link's quality, not its safety.");
  });
  it("takes a state that a late reader gets for no sign of life", () => {
    const station = new Station();
    station.onMessage("safety_status", make.safety({ stamp: make.stampOf(100_000) }), 1000);
    station.onMessage("transmission_state", make.transmission({ stamp: make.stampOf(104_000) }), 1000);
    assert.equal(textAt(station, 1100), "The vehicle has not been heard yet.");
  });
  it("says with which other site the vehicle speaks, as long as that is told", () => {
    const station = heard(4000);
    station.onMessage("link_site", { data: "south" }, 9000);
    const { severity, text } = alertOf(open, station, 9500);
    assert.deepEqual([severity, text], ["info", "The vehicle speaks with another site, south."]);
    assert.match(textAt(station, 12_500), /last heard 8.5 s ago/);
  });
  it("says that the vehicle is not heard after 3.5 s, with the time", () => {
    assert.equal(/last heard/.test(textAt(heard(4000), 7500)), false);
    assert.match(textAt(heard(4000), 7501), /last heard 3.5 s ago/);
    assert.match(textAt(heard(4000), 16_000), /last heard 12 s ago/);
  });
  it("tells a lost connection before all else, and gives a reload a second", () => {
    const lost = { phase: "lost", since: 4000, tries: 1, reason: "no server answers" } as const;
    assert.equal(alertOf(lost, heard(4000), 4500).severity, "info");
    assert.match(alertOf(lost, heard(4000), 64_000).text, /^No connection to the station for 60 s: no server/);
  });
  it("tells a pause with its reason, the time to the forced resume and how the link is", () => {
    const station = heard(4000, { per: 40 });
    const state = { active: false, reason: "cusum_alarm", deadline_s: 20, qni: 42, stamp: make.stampOf(1_004_000) };
    station.onMessage("transmission_state", make.transmission(state), 4000);
    const alert = alertOf(open, station, 6000);
    assert.equal(alert.severity, "warning");
    assert.match(alert.text, /\(quality has fallen, at most 18 s more\)\. The link is very poor: PER 40 %/);
  });
  it("tells safety and a blocked way before pause and link", () => {
    const station = heard(4000, { per: 40 });
    station.onMessage("transmission_state", make.transmission({ active: false }), 4000);
    station.onMessage("navigation_status", make.navigation({ state: "blocked" }), 4000);
    assert.match(textAt(station, 4000), /^The vehicle is blocked/);
    station.onMessage("safety_status", make.safety({ bumper: 4 }), 4000);
    assert.deepEqual(alertOf(open, station, 4000), { severity: "error", text: "The vehicle stands: bumper left." });
    station.onMessage("safety_status", make.safety({ emergency_stop: true }), 4000);
    assert.match(textAt(station, 4000), /emergency stop/);
  });
  it("tells why the vehicle does not drive on", () => {
    const textOf = (state: string, reason: string) => {
      const station = heard(4000);
      station.onMessage("navigation_status", make.navigation({ state, reason }), 4000);
      return textAt(station, 4000);
    };
    assert.equal(textOf("held", "goal_expired"), "The vehicle holds: its goal was not renewed in time.");
    assert.equal(textOf("held", "sending"), "The vehicle stands to send what it has stored.");
    assert.equal(textOf("held", "a_new_word"), "The vehicle holds.");
    assert.doesNotMatch(textOf("driving", "aligning"), /^The vehicle holds/);
  });
  it("says that the vehicle is not protected where sensors are not looked at", () => {
    const station = heard(4000);
    station.onMessage("safety_status", make.safety({ enabled: false }), 4000);
    assert.match(textAt(station, 4000), /^The vehicle is not protected: bumper, cliff/);
  });
  it("tells an error of diagnostics and a low battery before well", () => {
    const station = heard(4000);
    station.onMessage("battery_state", make.battery({ percentage: 0.19 }), 4000);
    assert.equal(textAt(station, 4000), "The battery is low: 19 %.");
    station.onMessage("diagnostics", make.diagnostics("drive", 2, "no frames"), 4000);
    assert.equal(textAt(station, 4000), "drive: no frames.");
  });
  it("knows no forced resume where there is none", () => {
    assert.equal(resumesInS(NaN, 0), undefined);
    assert.equal(resumesInS(3, 5000), 0);
  });
});

describe("Strip", () => {
  it("tells the link in a word, PER, and that all is sent", () => {
    const strip = stripOf(heard(4000, { per: 12 }), 4000);
    assert.deepEqual(strip, { link: "fair", step: 2, per: "PER 12\u202f%", gate: "sends all", paused: false });
  });
  it("counts down to the end of a pause, and knows pauses without one", () => {
    const station = heard(4000);
    const state = { active: false, deadline_s: 20, stamp: make.stampOf(1_004_000) };
    station.onMessage("transmission_state", make.transmission(state), 4000);
    assert.equal(stripOf(station, 6000).gate, "paused, 18\u202fs at most");
    station.onMessage("transmission_state", make.transmission({ ...state, deadline_s: NaN }), 4000);
    assert.equal(stripOf(station, 6000).gate, "paused");
  });
  it("calls a silent vehicle's link lost, and knows nothing before the first word", () => {
    assert.deepEqual(stripOf(new Station(), 0), { link: "lost", step: undefined, per: "PER –", gate: "gate not known", paused: false });
    assert.equal(stripOf(heard(4000), 7500).link, "poor");
    assert.equal(stripOf(heard(4000), 7501).link, "lost");
  });
});
