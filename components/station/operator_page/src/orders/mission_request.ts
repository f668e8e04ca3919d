// SPDX-License-Identifier: Apache-2.0
// Missions handed to mission_control, as goals of its action follow_waypoints.
import { quaternionOf } from "../model/geometry.ts";
import type { Waypoint } from "../model/messages.ts";

/** What mission_control accepts at most. */
export const mostWaypoints = 4095;

/** Calls a service of the station; rejects with an Error whose message is the reason. */
export type Call = (service: string, request: object) => Promise<unknown>;

export type Phase =
  | { readonly kind: "none" }
  | { readonly kind: "sending" }
  | { readonly kind: "accepted" }
  | { readonly kind: "canceled" }
  | { readonly kind: "failed"; readonly reason: string };

const action = "follow_waypoints/_action";
const noTime = { sec: 0, nanosec: 0 };

interface Sent {
  readonly accepted: boolean;
}
interface Ended {
  readonly result: { readonly error_msg: string };
}
interface Canceled {
  readonly goals_canceling: readonly unknown[];
}

/** One request at a time; what becomes of the mission afterwards is said by mission_control's topics, to all pages alike. */
export class MissionRequest {
  phase: Phase = { kind: "none" };

  /** `drawId`: 16 bytes that no goal had before. */
  constructor(
    private readonly call: Call,
    private readonly drawId: () => Uint8Array,
  ) {}

  get isPending(): boolean {
    return this.phase.kind === "sending";
  }

  /** In place of the present mission. True: accepted. */
  async send(places: readonly Waypoint[]): Promise<boolean> {
    return this.#ask(async () => {
      if (places.length > mostWaypoints) throw new Error(`${places.length} waypoints, at most ${mostWaypoints}`);
      const goal_id = { uuid: this.drawId() };
      const { accepted } = (await this.call(`${action}/send_goal`, { goal_id, goal: goalOf(places) })) as Sent;
      if (!accepted) throw new Error(await this.#reasonOf(goal_id));
      return "accepted";
    });
  }

  /** Ends the mission of whoever has sent it; the vehicle halts. True: mission_control does so. */
  async cancel(): Promise<boolean> {
    return this.#ask(async () => {
      const everyGoal = { goal_info: { goal_id: { uuid: new Uint8Array(16) }, stamp: noTime } };
      const { goals_canceling } = (await this.call(`${action}/cancel_goal`, everyGoal)) as Canceled;
      if (goals_canceling.length === 0) throw new Error("no mission of an operator is driven");
      return "canceled";
    });
  }

  async #ask(work: () => Promise<"accepted" | "canceled">): Promise<boolean> {
    if (this.isPending) return false;
    this.phase = { kind: "sending" };
    try {
      this.phase = { kind: await work() };
    } catch (error) {
      this.phase = { kind: "failed", reason: error instanceof Error ? error.message : String(error) };
    }
    return this.phase.kind !== "failed";
  }

  /** mission_control answers at once for a goal that it has rejected. */
  async #reasonOf(goal_id: { uuid: Uint8Array }): Promise<string> {
    const ended = (await this.call(`${action}/get_result`, { goal_id }).catch(() => undefined)) as Ended | undefined;
    return ended?.result.error_msg || "rejected without a reason";
  }
}

const goalOf = (places: readonly Waypoint[]): object => ({
  number_of_loops: 0,
  goal_index: 0,
  poses: places.map(({ x, y, yaw }) => ({
    header: { stamp: noTime, frame_id: "map" },
    pose: { position: { x, y, z: 0 }, orientation: quaternionOf(yaw) },
  })),
});
