// SPDX-License-Identifier: Apache-2.0
import type { TransmissionState } from "./messages.ts";
import { stampMs } from "./source_clock.ts";

/** One decision, as it is plotted. */
export interface Decision {
  readonly at: number;
  /** By the clock of who made it [ms]; undefined: it did not say. */
  readonly made: number | undefined;
  readonly qni: number | null;
  readonly statistic: number | null;
  readonly threshold: number | null;
  readonly active: boolean;
}

const keptMs = 10 * 60_000;
const finite = (value: number): number | null => (Number.isFinite(value) ? value : null);

/** The decisions of one side, of the last ten minutes. */
export class DecisionSeries {
  decisions: Decision[] = [];

  onState(state: TransmissionState, now: number): void {
    const last = this.decisions.at(-1);
    if (last !== undefined && now <= last.at) return; // the same one, repeated
    this.decisions.push({
      at: now,
      made: stampMs(state.stamp),
      qni: finite(state.qni),
      statistic: finite(state.statistic),
      threshold: finite(state.threshold),
      active: state.active,
    });
    const first = this.decisions[0];
    if (first !== undefined && now - first.at > 1.1 * keptMs) {
      this.decisions = this.decisions.filter(({ at }) => now - at <= keptMs);
    }
  }
}

/** Times in which the gate was closed; an interval that goes on ends at Infinity. */
export function pauses(decisions: readonly Decision[]): [number, number][] {
  const found: [number, number][] = [];
  let begin: number | undefined;
  for (const { at, active } of decisions) {
    if (!active && begin === undefined) begin = at;
    if (active && begin !== undefined) {
      found.push([begin, at]);
      begin = undefined;
    }
  }
  if (begin !== undefined) found.push([begin, Infinity]);
  return found;
}
