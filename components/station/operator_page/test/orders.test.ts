// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import type * as m from "../src/model/messages.ts";
import { Station } from "../src/model/station.ts";
import { OperatorPlace } from "../src/operator/place.ts";
import { ControlAuthority, type DriveConditions, cameraLimitMs, vehicleLimitMs, whyNotDrive } from "../src/orders/control_authority.ts";
import { EmergencyStopOrder, type StopHeard } from "../src/orders/emergency_stop.ts";
import { MissionOrder, leads } from "../src/orders/mission_order.ts";
import { isDrivingKey, keysVelocity, padVelocity, stickVelocity } from "../src/orders/stick.ts";
import { TeleopSender, standing } from "../src/orders/teleop_sender.ts";
import * as make from "./messages.ts";

const station = (asked: string, vehicle: string) => make.stopState({ asked, vehicle });

describe("OperatorPlace", () => {
  const rig = (connected = true) => {
    const live = new Station();
    const sent: { pose: m.PoseWithCovarianceStamped["pose"] }[] = [];
    const faults: string[] = [];
    const publish = (_: unknown, message: unknown): boolean => connected && sent.push(message as (typeof sent)[0]) > 0;
    return { live, sent, faults, sut: new OperatorPlace(live, { publish }, (text) => faults.push(text)) };
  };
  const drag = (sut: OperatorPlace) => {
    sut.toggle();
    sut.press({ x: 1, y: 2 });
    sut.turn(Math.PI / 2);
    sut.release(1000);
  };

  it("sends where the vehicle is once, and puts the tool back", () => {
    const { sut, sent, faults, live } = rig();
    drag(sut);
    assert.deepEqual([sut.isArmed, sut.place, sent.length], [false, undefined, 1]);
    assert.deepEqual(sent[0]?.pose.pose.position, { x: 1, y: 2, z: 0 });
    assert.ok(Math.abs((sent[0]?.pose.pose.orientation.z ?? 0) - Math.SQRT1_2) < 1e-12);
    live.onMessage("location", make.location(1.5, 2), 2000);
    sut.tick(2000);
    sut.tick(9000);
    assert.deepEqual(faults, []);
  });
  it("tells that the vehicle does not follow", () => {
    const { sut, faults, live } = rig();
    drag(sut);
    live.onMessage("location", make.location(4, 2), 2000);
    sut.tick(6000);
    assert.deepEqual(faults, []);
    sut.tick(6001);
    assert.match(faults[0] ?? "", /has not taken the place/);
  });
  it("tells at once that it could not be sent, and sends nothing that was not pressed or was taken back", () => {
    const { sut, faults } = rig(false);
    drag(sut);
    assert.match(faults[0] ?? "", /no connection/);
    const other = rig();
    other.sut.toggle();
    other.sut.release(1);
    other.sut.press({ x: 1, y: 2 });
    other.sut.takeBack();
    other.sut.release(2);
    assert.equal(other.sent.length, 0);
  });
});

describe("EmergencyStopOrder", () => {
  const heard = (changes: Partial<StopHeard>): StopHeard => ({
    station: undefined, safety: undefined, vehicleHeard: 1000, connected: true, ...changes,
  });
  const stands = { value: make.safety({ emergency_stop: true }), at: 0 };
  const free = { value: make.safety(), at: 0 };

  it("says a stop at once and again until the vehicle confirms, however long that takes", () => {
    const sut = new EmergencyStopOrder();
    assert.equal(sut.due(heard({}), 1000), undefined, "not pressed");
    sut.press(1000);
    assert.equal(sut.due(heard({ safety: free }), 1000), true);
    assert.equal(sut.due(heard({ safety: free }), 1299), undefined);
    assert.equal(sut.due(heard({ safety: free }), 1300), true);
    assert.equal(sut.due(heard({ safety: free }), 600_000), true);
    assert.equal(sut.due(heard({ safety: stands, station: station("on", "stands") }), 600_300), undefined);
    assert.equal(sut.due(heard({ safety: free, station: station("off", "may_drive") }), 700_000), undefined);
  });
  it("is not content with the stop of somebody else before the station has its own", () => {
    const sut = new EmergencyStopOrder();
    sut.press(1000);
    sut.due(heard({}), 1000);
    assert.equal(sut.due(heard({ safety: stands, station: station("off", "stands") }), 1300), true);
  });
  it("lets a release lapse after 5 s", () => {
    const sut = new EmergencyStopOrder();
    sut.release(1000);
    assert.equal(sut.due(heard({ safety: stands }), 1000), false);
    assert.equal(sut.due(heard({ safety: stands }), 6000), false);
    assert.equal(sut.due(heard({ safety: stands }), 6001), undefined);
    assert.equal(sut.due(heard({ safety: stands }), 7000), undefined);
  });
  it("a stop takes the place of a release", () => {
    const sut = new EmergencyStopOrder();
    sut.release(1000);
    sut.press(1001);
    assert.equal(sut.due(heard({ safety: free }), 1001), true);
  });
  it("says again at once what could not be sent", () => {
    const sut = new EmergencyStopOrder();
    sut.press(1000);
    sut.due(heard({ safety: free }), 1000);
    sut.notSent();
    assert.equal(sut.due(heard({ safety: free }), 1001), true);
  });
  it("tells which of the three has not answered", () => {
    const sut = new EmergencyStopOrder();
    sut.press(1000);
    const shown = (changes: Partial<StopHeard>) => sut.shown(heard({ safety: free, ...changes }), 3000);
    assert.match(shown({ connected: false }).text, /^NOT SENT for 2.0 s/);
    assert.match(shown({ station: station("never", "may_drive") }).text, /the station has not answered/);
    assert.match(shown({ station: station("on", "may_drive") }).text, /the vehicle has not confirmed/);
    assert.equal(shown({}).kind, "asking");
  });
  it("shows the vehicle's word, with its age when it is not heard any more", () => {
    const sut = new EmergencyStopOrder();
    const by = { value: make.safety({ emergency_stop: true, stopped_by: ["station"] }), at: 1000 };
    assert.equal(sut.shown(heard({ safety: by }), 2000).text, "Vehicle confirms: stopped by station");
    assert.match(sut.shown(heard({ safety: by }), 13_000).text, /as it said 12 s ago/);
    assert.equal(sut.shown(heard({ safety: free }), 13_000).kind, "unheard");
    assert.equal(sut.shown(heard({ safety: free }), 2000).kind, "clear");
  });
});

describe("TeleopSender", () => {
  const ahead = { linear: 0.3, angular: 0 };
  it("sends a change at once and repeats it ten times a second", () => {
    const sut = new TeleopSender();
    sut.hold(ahead);
    assert.deepEqual(sut.update(0), ahead);
    assert.equal(sut.update(99), undefined);
    assert.deepEqual(sut.update(100), ahead);
    sut.hold({ linear: 0.1, angular: 0 });
    assert.deepEqual(sut.update(101), { linear: 0.1, angular: 0 });
  });
  it("sends zero three times at release, and then nothing", () => {
    const sut = new TeleopSender();
    sut.hold(ahead);
    sut.update(0);
    sut.hold(standing);
    for (const at of [10, 110, 210]) assert.deepEqual(sut.update(at), standing);
    assert.equal(sut.update(310), undefined);
    assert.equal(sut.driving, false);
  });
});

describe("Driving by hand", () => {
  const good: DriveConditions = { connected: true, vehicleAge: 100, cameraAge: 100, bySight: false, paused: false, stopped: false, replaying: false, role: "operator" };
  it("is allowed by a fresh picture of a vehicle that is heard", () => {
    assert.equal(whyNotDrive(good), undefined);
    assert.equal(whyNotDrive({ ...good, vehicleAge: vehicleLimitMs, cameraAge: cameraLimitMs }), undefined);
  });
  it("is refused with the reason", () => {
    const reasons = [
      [{ connected: false }, /connection/],
      [{ replaying: true }, /recording/],
      [{ vehicleAge: undefined }, /never heard/],
      [{ vehicleAge: vehicleLimitMs + 1 }, /last heard 1.5 s ago/],
      [{ stopped: true }, /emergency stop/],
      [{ role: "observer" }, /an observer/],
      [{ cameraAge: undefined }, /no picture/],
      [{ cameraAge: undefined, paused: true }, /camera is paused by the gate/],
      [{ cameraAge: cameraLimitMs + 1, paused: true }, /camera is paused by the gate/],
      [{ cameraAge: cameraLimitMs + 1 }, /picture is 1.0 s old/],
    ] as const;
    for (const [change, reason] of reasons) assert.match(whyNotDrive({ ...good, ...change }) ?? "", reason);
  });
  it("needs no picture when the operator sees the vehicle", () => {
    assert.equal(whyNotDrive({ ...good, cameraAge: undefined, bySight: true }), undefined);
    assert.notEqual(whyNotDrive({ ...good, vehicleAge: 9999, bySight: true }), undefined);
  });
});

describe("ControlAuthority", () => {
  const ahead = { linear: 0.3, angular: 0 };
  const drives = (driver: string, askedBy = "") => ({ driver, askedBy });
  it("wants the hands to rest first, after control was taken and after a refusal", () => {
    const sut = new ControlAuthority("me");
    assert.deepEqual(sut.command(ahead, false), standing, "nobody has taken it");
    sut.take();
    assert.deepEqual([sut.taken, sut.takeRequest()], [true, undefined]);
    assert.deepEqual(sut.command(ahead, false), standing);
    sut.command(standing, false);
    assert.deepEqual(sut.command(ahead, false), ahead);
    assert.deepEqual(sut.command(ahead, true), standing);
    assert.deepEqual(sut.command(ahead, false), standing);
    sut.command(standing, false);
    assert.deepEqual(sut.command(ahead, false), ahead);
  });
  it("is asked for while another drives, and taken when the vehicle follows us or nobody", () => {
    for (const then of ["me", ""]) {
      const sut = new ControlAuthority("me");
      sut.onReport(drives("other"));
      sut.take();
      assert.deepEqual([sut.taken, sut.asks, sut.takeRequest(), sut.takeRequest()], [false, true, "ask", undefined]);
      sut.onReport(drives("other", "me"));
      assert.equal(sut.taken, false);
      sut.onReport(drives(then));
      assert.deepEqual([sut.taken, sut.asks, sut.waitsForRest], [true, false, true]);
    }
  });
  it("is taken over at once by a supervisor, when the vehicle says so", () => {
    const sut = new ControlAuthority("me");
    sut.onReport(drives("other"));
    sut.takeOver();
    assert.deepEqual([sut.taken, sut.takeRequest()], [false, "take"]);
    sut.onReport(drives("me"));
    assert.deepEqual([sut.taken, sut.asks, sut.waitsForRest], [true, false, true]);
  });
  it("is lost when the vehicle follows another", () => {
    const sut = new ControlAuthority("me");
    sut.take();
    for (const [driver, ...state] of [["me", true, ""], ["other", false, "other"], ["", false, ""]] as const) {
      sut.onReport(drives(driver));
      assert.deepEqual([sut.taken, sut.lostTo], state);
    }
  });
  it("tells who asks for it, and gives or keeps it", () => {
    const sut = new ControlAuthority("me");
    sut.take();
    sut.onReport(drives("me", "other"));
    assert.equal(sut.askedBy, "other");
    sut.keep();
    assert.equal(sut.takeRequest(), "keep");
    sut.toggle();
    assert.deepEqual([sut.takeRequest(), sut.taken], ["give", false]);
  });
});

describe("Stick", () => {
  const speeds = { linear: 0.4, angular: 1 };
  it("adds up the keys that are held", () => {
    assert.deepEqual(keysVelocity(new Set(["KeyW", "ArrowLeft"]), speeds), { linear: 0.4, angular: 1 });
    assert.deepEqual(keysVelocity(new Set(["KeyW", "ArrowUp"]), speeds), { linear: 0.4, angular: 0 });
    assert.deepEqual(keysVelocity(new Set(["KeyW", "KeyS"]), speeds), standing);
    assert.deepEqual(keysVelocity(new Set(["KeyX"]), speeds), standing);
    assert.ok(isDrivingKey("KeyD") && !isDrivingKey("Space"));
  });
  it("has a dead zone, and reaches the top speed at its end", () => {
    assert.deepEqual(stickVelocity(0.05, 0.1, speeds), standing);
    assert.deepEqual(stickVelocity(0, 1, speeds), { linear: 0.4, angular: 0 });
    assert.deepEqual(stickVelocity(1, 0, speeds), { linear: 0, angular: -1 });
    assert.deepEqual(stickVelocity(NaN, NaN, speeds), standing);
  });
  it("reads a pad only while a shoulder button is held", () => {
    const pad = (held: number | undefined) => ({
      connected: true,
      axes: [0, -1],
      buttons: Array.from({ length: 8 }, (_, index) => ({ pressed: index === held })),
    });
    assert.equal(padVelocity(pad(undefined), speeds), undefined);
    assert.equal(padVelocity(pad(0), speeds), undefined);
    assert.deepEqual(padVelocity(pad(5), speeds), { linear: 0.4, angular: 0 });
    assert.equal(padVelocity({ ...pad(5), connected: false }, speeds), undefined);
  });
});

describe("MissionOrder", () => {
  it("asks for a pause, and for its end, until the status shows it", () => {
    const sut = new MissionOrder();
    sut.pause(0);
    const running = make.mission({ state: "running" });
    assert.equal(sut.due(running, 0), "pause");
    assert.equal(sut.due(running, 499), undefined);
    assert.equal(sut.due(running, 500), "pause");
    assert.equal(sut.due(make.mission({ state: "paused" }), 1000), undefined);
    assert.deepEqual([sut.pending, sut.unheeded], [false, false]);
    sut.resume(2000);
    assert.equal(sut.due(make.mission({ state: "paused" }), 2000), "resume");
    assert.equal(sut.due(running, 2500), undefined);
  });
  it("gives up after 5 s and says so", () => {
    const sut = new MissionOrder();
    sut.pause(0);
    sut.due(make.mission({}), 5001);
    assert.equal(sut.unheeded, true);
    assert.equal(sut.pending, false);
  });
  it("skips the waypoint that was seen, and no other", () => {
    const sut = new MissionOrder();
    sut.skip(3, 0);
    assert.equal(sut.due(make.mission({ waypoint: 3 }), 0), "skip 4");
    assert.equal(sut.due(make.mission({ waypoint: 4 }), 500), undefined);
    assert.equal(sut.unheeded, false);
  });
  it("has nobody to ask where no mission is led", () => {
    assert.equal(leads(undefined), false);
    assert.equal(leads(make.mission({ state: "done" })), false);
    assert.equal(leads(make.mission({ state: "waiting" })), true);
  });
});
