// SPDX-License-Identifier: Apache-2.0
// How old a value may be, and how its age is told.

/** A value, and when it was last known to be the case [ms, time of the page]. */
export interface Heard<Value> {
  readonly value: Value;
  readonly at: number;
}

export type Freshness = "fresh" | "stale" | "unknown";

/** As the terminal view: older is shown grey with its age. */
export const staleAfterMs = 3000;
/** Older is not shown but for its age; a position stays, as the last one. */
export const unknownAfterMs = 30_000;

/** As QGroundControl: a vehicle is lost 3.5 s after its last word. */
export const vehicleLostAfterMs = 3500;

/** Of something that was heard at `at`; undefined: never. */
export function freshness(at: number | undefined, now: number): Freshness {
  if (at === undefined || now - at > unknownAfterMs) return "unknown";
  return now - at > staleAfterMs ? "stale" : "fresh";
}

/** "0.4 s", "12 s", "3 min", "2 h". */
export function ageText(ageMs: number): string {
  const seconds = Math.max(0, ageMs) / 1000;
  if (seconds < 9.95) return `${seconds.toFixed(1)} s`;
  if (seconds < 99.5) return `${seconds.toFixed(0)} s`;
  if (seconds < 99.5 * 60) return `${(seconds / 60).toFixed(0)} min`;
  return `${(seconds / 3600).toFixed(0)} h`;
}
