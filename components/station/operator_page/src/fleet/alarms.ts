// SPDX-License-Identifier: Apache-2.0
import type { Alert, AlertKind } from "../model/alerts.ts";

/** Something about a vehicle that a person should know of: one for each kind that stands or is not acknowledged. */
export interface Alarm {
  readonly vehicle: string;
  readonly kind: AlertKind;
  readonly severity: "warning" | "error";
  /** As it was told last. */
  readonly text: string;
  readonly since: number;
  /** When it was over; undefined: it stands. */
  readonly until: number | undefined;
  readonly acknowledged: boolean;
  /** How often it began. */
  readonly times: number;
}

/** So long a finding must last; what is shown for a moment only, as while a page connects, is none. */
const lastsMs = 1000;

/** Not what no person needs to look at: all is well, or not known yet. */
const isAlarm = ({ severity }: Alert): boolean => severity === "warning" || severity === "error";

/**
 * The alarms of all vehicles, newest first. One that is over stays until it is acknowledged; an acknowledged one stays
 * until it is over. Pure.
 */
export class Alarms {
  list: readonly Alarm[] = [];
  #found = new Map<string, { readonly kind: AlertKind; readonly since: number }>();

  /** The worst of a vehicle at `now`: it stands, and no other one of this vehicle does. */
  onFinding(vehicle: string, finding: Alert & { readonly kind: AlertKind }, now: number): void {
    const isOf = (one: Alarm): boolean => one.vehicle === vehicle;
    const earlier = this.#found.get(vehicle);
    const since = earlier?.kind === finding.kind ? earlier.since : now;
    this.#found.set(vehicle, { kind: finding.kind, since });
    this.list = this.list.flatMap((one) => {
      const goesOn = isAlarm(finding) && one.kind === finding.kind;
      if (!isOf(one) || goesOn || one.until !== undefined) return [one];
      return one.acknowledged ? [] : [{ ...one, until: now }];
    });
    const stands = this.list.some((one) => isOf(one) && one.kind === finding.kind && one.until === undefined);
    const lasts = finding.kind === "safety" || now - since >= lastsMs;
    if (!isAlarm(finding) || (!stands && !lasts)) return;
    const severity = finding.severity === "error" ? "error" : "warning";
    const { kind, text } = finding;
    const before = this.list.find((one) => isOf(one) && one.kind === kind);
    if (before === undefined) {
      this.list = [{ vehicle, kind, severity, text, since, until: undefined, acknowledged: false, times: 1 }, ...this.list];
      return;
    }
    const began = before.until === undefined ? {} : { until: undefined, since, times: before.times + 1 };
    this.list = this.list.map((one) => (one === before ? { ...one, ...began, severity, text } : one));
  }

  acknowledge({ vehicle, kind }: Alarm): void {
    this.list = this.list.flatMap((one) => {
      if (one.vehicle !== vehicle || one.kind !== kind) return [one];
      return one.until === undefined ? [{ ...one, acknowledged: true }] : [];
    });
  }
}
