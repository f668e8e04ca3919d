// SPDX-License-Identifier: Apache-2.0
import type { Goal, NavigationStatus, Waypoint } from "./messages.ts";

export type WaypointState = "passed" | "present" | "ahead";

export interface RoutePoint extends Waypoint {
  /** From 1, as people count. */
  readonly number: number;
  readonly state: WaypointState;
}

/** The waypoints of the mission that is driven, as its goals tell them one after the other. */
export class Route {
  #mission: bigint | undefined;
  #waypoints = new Map<number, Waypoint>();
  #present = 0;
  #firstId = 0n;

  onGoal(goal: Goal): void {
    // The lower half of a mission's identity is a checksum of its waypoints: the same way.
    if (this.#mission === undefined || low(this.#mission) !== low(goal.mission)) this.#waypoints.clear();
    this.#mission = goal.mission;
    this.#firstId = goal.id - BigInt(goal.waypoint);
    this.#present = goal.waypoint;
    this.#waypoints.set(goal.waypoint, goal);
    goal.ahead.forEach((one, index) => this.#waypoints.set(goal.waypoint + 1 + index, one));
  }

  /** What was known of the same mission before; of none yet, all of it. */
  adopt(earlier: Route): void {
    if (earlier.#mission === undefined) return;
    if (this.#mission === undefined) {
      [this.#mission, this.#firstId, this.#present] = [earlier.#mission, earlier.#firstId, earlier.#present];
    } else if (low(this.#mission) !== low(earlier.#mission)) return;
    for (const [index, place] of earlier.#waypoints) if (!this.#waypoints.has(index)) this.#waypoints.set(index, place);
  }

  /** The vehicle may have gone on by itself. */
  onStatus(status: NavigationStatus): void {
    if (status.mission !== this.#mission || status.goal_id < this.#firstId) return;
    const told = Number(status.goal_id - this.#firstId);
    if (!this.#waypoints.has(told)) return;
    this.#present = status.state === "reached" && !this.#waypoints.has(told + 1) ? told + 1 : told;
  }

  points(): RoutePoint[] {
    return [...this.#waypoints]
      .sort(([a], [b]) => a - b)
      .map(([index, { x, y, yaw }]) => ({
        x,
        y,
        yaw,
        number: index + 1,
        state: index < this.#present ? "passed" : index === this.#present ? "present" : "ahead",
      }));
  }
}

const low = (mission: bigint): bigint => mission & 0xffffffffn;
