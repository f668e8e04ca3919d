// SPDX-License-Identifier: Apache-2.0
import type { Stamp } from "./messages.ts";

const halfWindowMs = 30_000;

/** [ms] since the Unix epoch; undefined: the writer did not say. */
export function stampMs(stamp: Stamp | undefined): number | undefined {
  if (stamp === undefined || (stamp.sec === 0 && stamp.nanosec === 0)) return undefined;
  return stamp.sec * 1000 + stamp.nanosec / 1e6;
}

/**
 * Tells when something stamped by another clock was the case, by the page's own: clocks are never
 * compared. What took longer on its way than the quickest of the last half to one minute is that
 * much older. Ages are too small by the time that the quickest one took, and after a step of the
 * other clock backwards too large for a minute.
 */
export class SourceClock {
  #began = -Infinity;
  #least = Infinity;
  #leastBefore = Infinity;

  /** Takes a message stamped `stamp` that came at `arrival`; when it was the case, at most `arrival`. */
  heardAt(stamp: number, arrival: number): number {
    if (arrival - this.#began > halfWindowMs) {
      const isNext = arrival - this.#began <= 2 * halfWindowMs;
      this.#leastBefore = isNext ? this.#least : Infinity;
      this.#least = Infinity;
      this.#began = arrival;
    }
    this.#least = Math.min(this.#least, arrival - stamp);
    return Math.min(arrival, stamp + Math.min(this.#least, this.#leastBefore));
  }
}
