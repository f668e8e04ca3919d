// SPDX-License-Identifier: Apache-2.0
import { distance } from "./geometry.ts";
import type { Goal, MissionStatus, NavigationStatus, Waypoint } from "./messages.ts";

/** Places that are nearer to each other [m] are the same. */
const sameM = 0.001;

export type WaypointState = "passed" | "present" | "ahead";

export interface RoutePoint extends Waypoint {
  /** From 1, as people count. */
  readonly number: number;
  readonly state: WaypointState;
}

/** The waypoints of the mission that is driven: mission_control publishes all of them, goals of others name theirs. */
export class Route {
  #mission: bigint | undefined;
  #waypoints = new Map<number, Waypoint>();
  #present = 0;
  #firstId = 0n;
  #hasPath = false;
  /** mission_control leads through its path: other goals, as that of a pause, do not change it. */
  #isLed = false;

  /** All waypoints of mission_control's mission. */
  onPath(waypoints: readonly Waypoint[]): void {
    this.#waypoints = new Map(waypoints.entries());
    this.#present = 0;
    this.#hasPath = waypoints.length > 0;
  }

  /** Where mission_control is in it. */
  onMission({ state, waypoint, waypoints }: MissionStatus): void {
    if (waypoints !== this.#waypoints.size) return; // of a path that is still to come
    this.#isLed = this.#hasPath && state !== "done" && state !== "aborted";
    this.#present = state === "done" ? waypoints : waypoint;
  }

  onGoal(goal: Goal): void {
    if (this.#isLed && !this.#holds(goal)) return;
    // The lower half of a mission's identity is a checksum of its waypoints: the same way.
    const isSame = this.#mission !== undefined && low(this.#mission) === low(goal.mission);
    if (!isSame && !this.#holds(goal)) this.#waypoints.clear();
    this.#mission = goal.mission;
    this.#firstId = goal.id - BigInt(goal.waypoint);
    this.#present = goal.waypoint;
    this.#waypoints.set(goal.waypoint, goal);
    goal.ahead.forEach((one, index) => this.#waypoints.set(goal.waypoint + 1 + index, one));
  }

  /** The vehicle may have gone on by itself. */
  onStatus(status: NavigationStatus): void {
    if (status.mission !== this.#mission || status.goal_id < this.#firstId) return;
    const told = Number(status.goal_id - this.#firstId);
    if (!this.#waypoints.has(told)) return;
    this.#present = status.state === "reached" && !this.#waypoints.has(told + 1) ? told + 1 : told;
  }

  #holds({ waypoint, x, y }: Goal): boolean {
    const known = this.#waypoints.get(waypoint);
    return known !== undefined && distance(known, { x, y }) < sameM;
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
