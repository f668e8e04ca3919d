// SPDX-License-Identifier: Apache-2.0
// Decisions that another policy would have made of the same samples, beside those that were made.
import type { Role } from "./messages.ts";
import { type Decision, pauses } from "./series.ts";

/** Which policy is tried; `changes`: its parameters, "alpha=3,th_max_s=20". */
export interface WhatIfQuestion {
  readonly host: Role;
  readonly policy: string;
  readonly changes: string;
}

export interface WhatIf {
  readonly question: WhatIfQuestion;
  readonly decisions: readonly Decision[];
}

interface Row {
  readonly time_s: number;
  readonly qni: number | null;
  readonly state: string;
  readonly statistic: number | null;
  readonly threshold: number | null;
}

/** The words of a request. Throws with a text for people. */
export function queryOf({ host, policy, changes }: WhatIfQuestion): Record<string, string> {
  const query: Record<string, string> = { host, policy };
  for (const word of changes.split(",").map((one) => one.trim()).filter((one) => one !== "")) {
    const [key, value, ...more] = word.split("=");
    if (!key || !value || more.length > 0) throw new Error(`"${word}" is no parameter=value`);
    query[key] = value;
  }
  return query;
}

/** What the tool says; `offsetMs`: of the page's time before the host's clock. Throws when it is something else. */
export function whatIfOf(answer: unknown, question: WhatIfQuestion, offsetMs: number): WhatIf {
  const { rows, recorded } = answer as { rows?: Row[]; recorded?: { began_s?: number } };
  const began = recorded?.began_s;
  if (!Array.isArray(rows) || began === undefined) throw new Error("the answer has no recorded decisions");
  const decisions = rows.map(({ time_s, qni, state, statistic, threshold }): Decision => {
    const made = (began + time_s) * 1000;
    return { at: made + offsetMs, made, qni, statistic, threshold, active: state !== "passive" };
  });
  return { question, decisions };
}

export interface Silence {
  readonly pauses: number;
  readonly seconds: number;
}

/** Pauses between two times, and how long they were together. */
export function silence(decisions: readonly Decision[], from: number, to: number): Silence {
  const within = pauses(decisions)
    .map(([begin, end]) => [Math.max(begin, from), Math.min(end, to)] as const)
    .filter(([begin, end]) => end > begin);
  return { pauses: within.length, seconds: within.reduce((sum, [begin, end]) => sum + end - begin, 0) / 1000 };
}

/** Both, over the time that both know; undefined: there is none. */
export function compare(whatIf: WhatIf, happened: readonly Decision[]): { other: Silence; happened: Silence; seconds: number } | undefined {
  const [first, begin] = [whatIf.decisions[0], happened[0]];
  const [last, end] = [whatIf.decisions.at(-1), happened.at(-1)];
  if (!first || !begin || !last || !end) return undefined;
  const [from, to] = [Math.max(first.at, begin.at), Math.min(last.at, end.at)];
  if (to <= from) return undefined;
  return {
    other: silence(whatIf.decisions, from, to),
    happened: silence(happened, from, to),
    seconds: (to - from) / 1000,
  };
}
