// SPDX-License-Identifier: Apache-2.0
// What stands beside the emergency stop, whatever part of the page is seen. Pure.
import { resumesInS } from "./alerts.ts";
import { vehicleLostAfterMs } from "./freshness.ts";
import { type LinkWord, figuresOf, gradeLink, gradeWords } from "./link_grade.ts";
import type { Station } from "./station.ts";

export interface Strip {
  readonly link: LinkWord | "lost";
  /** Step of quality, for the colour; undefined: it has none. */
  readonly step: number | undefined;
  readonly per: string;
  /** Whether the vehicle sends all, or for how long it pauses at most. */
  readonly gate: string;
  readonly paused: boolean;
}

export function stripOf(station: Station, now: number): Strip {
  const { vehicleHeard, uxv } = station;
  const figures = figuresOf(station, now);
  const isLost = vehicleHeard === undefined || now - vehicleHeard > vehicleLostAfterMs;
  const link = isLost ? "lost" : gradeLink(figures).word;
  const step = gradeWords.findIndex((word) => word === link);
  const told = uxv.transmission;
  const paused = told?.value.active === false;
  return {
    link,
    step: step < 0 ? undefined : step,
    per: figures.perPercent === undefined ? "PER –" : `PER ${figures.perPercent.toFixed(0)}\u202f%`,
    gate: told === undefined ? "gate not known" : paused ? pausedText(told.value.deadline_s, now - told.at) : "sends all",
    paused,
  };
}

function pausedText(deadlineS: number, ageMs: number): string {
  const left = resumesInS(deadlineS, ageMs);
  return left === undefined ? "paused" : `paused, ${left.toFixed(0)}\u202fs at most`;
}
