// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { MissionRequest, mostWaypoints } from "../src/orders/mission_request.ts";

interface Asked {
  readonly service: string;
  readonly request: {
    readonly goal_id?: { readonly uuid: Uint8Array };
    readonly goal?: { readonly poses: { readonly header: { readonly frame_id: string }; readonly pose: { readonly orientation: { readonly z: number } } }[] };
  };
}

const place = { x: 1, y: 2, yaw: Math.PI };
const sendGoal = "follow_waypoints/_action/send_goal";

/** `answers`: of services, by the end of their name. */
function setUp(answers: Record<string, unknown>) {
  const asked: Asked[] = [];
  const call = async (service: string, request: object): Promise<unknown> => {
    asked.push({ service, request: request as Asked["request"] });
    const answer = answers[service.split("/").at(-1) ?? ""];
    if (answer instanceof Error) throw answer;
    return answer;
  };
  return { asked, sut: new MissionRequest(call, () => new Uint8Array(16).fill(7)) };
}

describe("MissionRequest", () => {
  it("hands all places to mission_control as one goal", async () => {
    const { sut, asked } = setUp({ send_goal: { accepted: true } });
    assert.ok(await sut.send([place, place]));
    assert.deepEqual(asked.map(({ service }) => service), [sendGoal]);
    const { goal, goal_id } = asked[0]?.request ?? {};
    assert.equal(goal?.poses.length, 2);
    assert.equal(goal?.poses[0]?.header.frame_id, "map");
    assert.equal(goal?.poses[0]?.pose.orientation.z, 1);
    assert.equal(goal_id?.uuid[15], 7);
    assert.equal(sut.phase.kind, "accepted");
  });
  it("tells why mission_control has rejected it", async () => {
    const { sut, asked } = setUp({ send_goal: { accepted: false }, get_result: { result: { error_msg: "poses: there is none" } } });
    assert.equal(await sut.send([]), false);
    assert.deepEqual(sut.phase, { kind: "failed", reason: "poses: there is none" });
    assert.deepEqual(asked[1]?.request, { goal_id: { uuid: new Uint8Array(16).fill(7) } });
  });
  it("says so when a rejection has no reason, or nobody answers", async () => {
    const silent = setUp({ send_goal: { accepted: false }, get_result: new Error("too late") }).sut;
    await silent.send([place]);
    assert.deepEqual(silent.phase, { kind: "failed", reason: "rejected without a reason" });
    const alone = setUp({ send_goal: new Error("nobody serves it") }).sut;
    await alone.send([place]);
    assert.deepEqual(alone.phase, { kind: "failed", reason: "nobody serves it" });
  });
  it("asks for one thing at a time", async () => {
    const { sut, asked } = setUp({ send_goal: { accepted: true } });
    const first = sut.send([place]);
    assert.ok(sut.isPending);
    assert.equal(await sut.send([place]), false);
    assert.ok(await first);
    assert.equal(asked.length, 1);
  });
  it("sends no more waypoints than a mission may have", async () => {
    const { sut, asked } = setUp({ send_goal: { accepted: true } });
    assert.ok(await sut.send(new Array(mostWaypoints).fill(place)));
    assert.equal(await sut.send(new Array(mostWaypoints + 1).fill(place)), false);
    assert.equal(asked.length, 1);
  });
  it("cancels the mission of every page, and says when there is none", async () => {
    const { sut, asked } = setUp({ cancel_goal: { goals_canceling: [{}] } });
    assert.ok(await sut.cancel());
    assert.deepEqual((asked[0]?.request as unknown as { goal_info: { goal_id: object } }).goal_info.goal_id, { uuid: new Uint8Array(16) });
    assert.equal(sut.phase.kind, "canceled");
    const none = setUp({ cancel_goal: { goals_canceling: [] } }).sut;
    assert.equal(await none.cancel(), false);
    assert.deepEqual(none.phase, { kind: "failed", reason: "no mission of an operator is driven" });
  });
});
