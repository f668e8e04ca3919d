// SPDX-License-Identifier: Apache-2.0
import type { ConnectionState } from "../protocol/connection.ts";
import { type Heard, ageText, staleAfterMs, vehicleLostAfterMs } from "./freshness.ts";
import type { Severity } from "./journal.ts";
import { figuresOf, gradeLink, measuredWithinMs } from "./link_grade.ts";
import { reasonText, standingText } from "./reasons.ts";
import { type Station, hindrances } from "./station.ts";

/** What the operator must know before all else: one line, not a stack of them. */
export interface Alert {
  /** `well`: nothing is wrong, and all that says so is known and fresh. */
  readonly severity: Severity | "well";
  readonly text: string;
}

/** What an alert is about; the worst first. */
export const alertKinds = ["connection", "silence", "safety", "motion", "paused", "link", "finding", "unknown", "well"] as const;
export type AlertKind = (typeof alertKinds)[number];

/** The age of what is shown is known when so much of the vehicle's stream was received. */
const settledAfterMs = 2000;
const lowBattery = 0.2;

type Look = (connection: ConnectionState, station: Station, now: number) => Alert | undefined;

const looks: { readonly [Kind in AlertKind]: Look } = {
  connection: (connection, _, now) => connectionAlert(connection, now),
  silence: (_, station, now) => silenceAlert(station, now),
  safety: (_, station) => safetyAlert(station),
  motion: (_, station) => motionAlert(station),
  paused: (_, station, now) => pausedAlert(station, now),
  link: (_, station, now) => linkAlert(station, now),
  finding: (_, station, now) => findingAlert(station, now),
  unknown: (_, station, now) => unknownAlert(station, now),
  well: (_, station, now) => wellAlert(station, now),
};

/** The worst that is the case at `now`, and what it is about. */
export function findingOf(connection: ConnectionState, station: Station, now: number): Alert & { readonly kind: AlertKind } {
  for (const kind of alertKinds) {
    const alert = looks[kind](connection, station, now);
    if (alert !== undefined) return { ...alert, kind };
  }
  return { ...wellAlert(station, now), kind: "well" };
}

/** The worst that is the case at `now`. */
export function alertOf(connection: ConnectionState, station: Station, now: number): Alert {
  const { severity, text } = findingOf(connection, station, now);
  return { severity, text };
}

function connectionAlert({ phase, tries, since, reason }: ConnectionState, now: number): Alert | undefined {
  if (phase === "open") return undefined;
  // A reload takes a moment.
  if (tries <= 1 && now - since <= 1000) return { severity: "info", text: "Connecting to the station." };
  const why = reason ? `: ${reason}` : "";
  return { severity: "error", text: `No connection to the station for ${ageText(now - since)}${why}. Trying again.` };
}

function silenceAlert({ vehicleHeard, otherSite }: Station, now: number): Alert | undefined {
  const isElsewhere = otherSite !== undefined && now - otherSite.at <= staleAfterMs;
  if (isElsewhere) return { severity: "info", text: `The vehicle speaks with another site, ${otherSite.value}.` };
  if (vehicleHeard === undefined) return { severity: "warning", text: "The vehicle has not been heard yet." };
  const silent = now - vehicleHeard;
  if (silent <= vehicleLostAfterMs) return undefined;
  return { severity: "error", text: `The vehicle was last heard ${ageText(silent)} ago.` };
}

function safetyAlert({ safety }: Station): Alert | undefined {
  const hindered = safety === undefined ? [] : hindrances(safety.value);
  if (hindered.length === 0) return undefined;
  const stands = safety?.value.enabled === true || hindered.length > 1;
  return stands
    ? { severity: "error", text: `The vehicle stands: ${hindered.join(", ")}.` }
    : { severity: "error", text: `The vehicle is not protected: ${hindered.join(", ")}.` };
}

function motionAlert({ navigation }: Station): Alert | undefined {
  if (navigation === undefined) return undefined;
  const { state, reason } = navigation.value;
  const text = standingText(state, reason);
  const severity = reason === "sending" ? "info" : "warning";
  return text === undefined ? undefined : { severity, text: `The vehicle ${text}.` };
}

function pausedAlert(station: Station, now: number): Alert | undefined {
  const told = station.uxv.transmission;
  if (told === undefined || told.value.active) return undefined;
  const left = resumesInS(told.value.deadline_s, now - told.at);
  const until = left === undefined ? "" : `, at most ${left.toFixed(0)} s more`;
  const because = reasonText(station.uxv.pausedBecause ?? told.value.reason);
  const text = `The vehicle pauses camera and other topics of class low (${because}${until}). ${linkText(station, now)}`;
  return { severity: "warning", text };
}

function linkText(station: Station, now: number): string {
  const { word, figures } = gradeLink(figuresOf(station, now));
  return `The link is ${word}${figures.length > 0 ? `: ${figures.join(", ")}` : ""}.`;
}

function linkAlert(station: Station, now: number): Alert | undefined {
  const { word, isGood } = gradeLink(figuresOf(station, now));
  if (isGood || word === "unknown") return undefined;
  return { severity: word === "fair" ? "info" : "warning", text: linkText(station, now) };
}

function findingAlert({ diagnostics, battery }: Station, now: number): Alert | undefined {
  const found = [...diagnostics.values()].find(({ value, at }) => value.level >= 2 && now - at <= measuredWithinMs);
  if (found) return { severity: "warning", text: `${found.value.name}: ${found.value.message}.` };
  const share = battery?.value.percentage;
  if (share === undefined || !(share < lowBattery)) return undefined;
  return { severity: "warning", text: `The battery is low: ${(100 * share).toFixed(0)} %.` };
}

/** What must be known before anything is called well. */
function unknownAlert(station: Station, now: number): Alert | undefined {
  const isFresh = (heard: Heard<unknown> | undefined): boolean => heard !== undefined && now - heard.at <= staleAfterMs;
  const missing = [
    ...(isFresh(station.location) ? [] : ["its position"]),
    ...(gradeLink(figuresOf(station, now)).isGood ? [] : ["the link's quality"]),
    ...(station.safety === undefined ? ["its safety"] : []),
  ];
  if (missing.length > 0) return { severity: "info", text: `The vehicle is received, but not ${missing.join(", not ")}.` };
  const sinceMs = now - (station.vehicleHeardSince ?? now);
  if (sinceMs < settledAfterMs) return { severity: "info", text: "The vehicle is received; how late is not known yet." };
  return undefined;
}

function wellAlert(station: Station, now: number): Alert {
  return { severity: "well", text: `All is well. ${linkText(station, now)}` };
}

/** Time to the forced resume [s]; undefined when there is none. */
export function resumesInS(deadlineS: number, ageMs: number): number | undefined {
  return Number.isFinite(deadlineS) ? Math.max(0, deadlineS - ageMs / 1000) : undefined;
}
