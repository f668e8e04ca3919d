// SPDX-License-Identifier: Apache-2.0
import type { ConnectionState } from "../protocol/connection.ts";
import { ageText } from "./freshness.ts";
import type { Severity } from "./journal.ts";
import { reasonText } from "./reasons.ts";
import { type Station, hindrances } from "./station.ts";

/** What the operator must know before all else: one line, not a stack of them. */
export interface Alert {
  readonly severity: Severity;
  readonly text: string;
}

/** As QGroundControl: said 3.5 s after the last word. */
export const vehicleLostAfterMs = 3500;

/** The worst that is the case at `now`; undefined: all is well. */
export function alertOf(connection: ConnectionState, station: Station, now: number): Alert | undefined {
  if (connection.phase !== "open" && (connection.tries > 1 || now - connection.since > 1000)) {
    const since = ageText(now - connection.since);
    const reason = connection.reason ? `: ${connection.reason}` : "";
    return { severity: "error", text: `No connection to the station for ${since}${reason}. Trying again.` };
  }
  const silent = station.vehicleHeard === undefined ? undefined : now - station.vehicleHeard;
  if (silent === undefined) return { severity: "warning", text: "The vehicle has not been heard yet." };
  if (silent > vehicleLostAfterMs) {
    return { severity: "error", text: `The vehicle was last heard ${ageText(silent)} ago.` };
  }
  const hindered = station.safety === undefined ? [] : hindrances(station.safety.value);
  if (hindered.length > 0) return { severity: "error", text: `The vehicle stands: ${hindered.join(", ")}.` };
  return pausedAlert(station, now);
}

function pausedAlert(station: Station, now: number): Alert | undefined {
  const told = station.uxv.transmission;
  if (told === undefined || told.value.active) return undefined;
  const left = resumesInS(told.value.deadline_s, now - told.at);
  const until = left === undefined ? "" : `, at most ${left.toFixed(0)} s more`;
  const because = reasonText(station.uxv.pausedBecause ?? told.value.reason);
  return {
    severity: "warning",
    text: `The link is poor: camera and other topics of class low wait (${because}${until}).`,
  };
}

/** Time to the forced resume [s]; undefined when there is none. */
export function resumesInS(deadlineS: number, ageMs: number): number | undefined {
  return Number.isFinite(deadlineS) ? Math.max(0, deadlineS - ageMs / 1000) : undefined;
}
