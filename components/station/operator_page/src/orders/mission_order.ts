// SPDX-License-Identifier: Apache-2.0
import type { MissionStatus } from "../model/messages.ts";

const repeatMs = 500;
/** Who has not done it by then is not there, or does not know the order. */
const limitMs = 5000;

type Wish = { readonly kind: "pause" | "resume" } | { readonly kind: "skip"; readonly waypoint: number };

/**
 * What the operator wants of mission_control, in its words on mission/command: said again until
 * its status shows that it is done, for 5 s at most. Pure.
 */
export class MissionOrder {
  #wish: Wish | undefined;
  #since = 0;
  #next = 0;
  /** It was said for 5 s, and nothing came of it. */
  unheeded = false;

  pause(now: number): void {
    this.#begin({ kind: "pause" }, now);
  }

  resume(now: number): void {
    this.#begin({ kind: "resume" }, now);
  }

  /** Leave out that waypoint, an index from 0, if it is the present one. */
  skip(waypoint: number, now: number): void {
    this.#begin({ kind: "skip", waypoint }, now);
  }

  get pending(): boolean {
    return this.#wish !== undefined;
  }

  /** The words to say now, if any. */
  due(status: MissionStatus | undefined, now: number): string | undefined {
    const wish = this.#wish;
    if (wish === undefined) return undefined;
    this.unheeded = now - this.#since > limitMs;
    if (this.unheeded || isDone(wish, status)) {
      this.#wish = undefined;
      return undefined;
    }
    if (now < this.#next) return undefined;
    this.#next = now + repeatMs;
    return wish.kind === "skip" ? `skip ${wish.waypoint + 1}` : wish.kind;
  }

  #begin(wish: Wish, now: number): void {
    this.#wish = wish;
    this.#since = now;
    this.#next = now;
    this.unheeded = false;
  }
}

/** Whether mission_control sends goals. */
export const leads = (status: MissionStatus | undefined): boolean =>
  status !== undefined && (status.state === "running" || status.state === "waiting");

function isDone(wish: Wish, status: MissionStatus | undefined): boolean {
  if (wish.kind === "skip") return status === undefined || status.waypoint !== wish.waypoint || !leads(status);
  if (wish.kind === "pause") return !leads(status);
  return status === undefined || status.state !== "paused";
}
