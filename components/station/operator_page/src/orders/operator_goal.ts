// SPDX-License-Identifier: Apache-2.0
import type { NavigationStatus, Waypoint } from "../model/messages.ts";

/** A goal as it is written, but for the stamp. */
export interface GoalOrder extends Waypoint {
  readonly id: bigint;
  readonly waypoint: number;
  readonly tolerance_m: number;
  readonly lifetime_s: number;
  readonly ahead: readonly Waypoint[];
  readonly mission: bigint;
}

export type GoalPhase = "none" | "asked" | "driving" | "blocked" | "held" | "reached" | "taken over";

const repeatMs = 3000;
const lifetimeS = 60;
const toleranceM = 0.15;
/** What a goal's list may hold beside the goal itself. */
export const longestRoute = 33;

/**
 * A goal of the operator, kept as mission_control keeps its own: repeated until the vehicle names
 * it, renewed when half of its lifetime is over. When the page is gone the vehicle holds, at the
 * latest, when the lifetime is over. Pure.
 */
export class OperatorGoal {
  #goal: GoalOrder | undefined;
  #sent = -Infinity;
  #named = false;
  phase: GoalPhase = "none";

  /** `drawMission`: an identity that no mission had before. */
  constructor(private readonly drawMission: () => bigint) {}

  get poses(): readonly Waypoint[] {
    return this.#goal === undefined ? [] : [this.#goal, ...this.#goal.ahead];
  }

  /** Drive to these places, one after the other. */
  set(poses: readonly Waypoint[]): void {
    const [first, ...ahead] = poses.slice(0, longestRoute);
    if (first === undefined) return this.clear();
    this.#goal = {
      ...{ x: first.x, y: first.y, yaw: first.yaw },
      ...{ id: 1n, waypoint: 0, tolerance_m: toleranceM, lifetime_s: lifetimeS },
      ahead,
      mission: this.drawMission(),
    };
    this.#sent = -Infinity;
    this.#named = false;
    this.phase = "asked";
  }

  /** Nothing is wanted any more: the vehicle is left to others, or to the end of the lifetime. */
  clear(): void {
    this.#goal = undefined;
    this.phase = "none";
  }

  onStatus(status: NavigationStatus): void {
    if (this.#goal === undefined) return;
    if (status.mission !== this.#goal.mission) {
      if (!this.#named) return; // it has not heard of this goal yet
      this.#goal = undefined;
      this.phase = "taken over";
      return;
    }
    this.#named = true;
    this.phase = this.#phaseOf(status, this.#goal);
    if (this.phase === "reached") this.#goal = undefined;
  }

  /** The goal to write now, if any. */
  due(now: number): GoalOrder | undefined {
    const isAnswered = this.#named && this.phase !== "held";
    const wait = isAnswered ? (lifetimeS / 2) * 1000 : repeatMs;
    if (this.#goal === undefined || now - this.#sent < wait) return undefined;
    this.#sent = now;
    return this.#goal;
  }

  /** It could not be written: it is due again. */
  notSent(): void {
    this.#sent = -Infinity;
  }

  #phaseOf({ state, goal_id }: NavigationStatus, goal: GoalOrder): GoalPhase {
    if (state === "blocked" || state === "held") return state;
    const isLast = goal_id >= goal.id + BigInt(goal.ahead.length);
    return state === "reached" && isLast ? "reached" : "driving";
  }
}
