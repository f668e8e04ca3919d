// SPDX-License-Identifier: Apache-2.0
// The link in a word, by the worst of what is known of it. Pure.
import { type Heard, ageText } from "./freshness.ts";
import { qualityStep } from "./quality.ts";
import type { Side, Station } from "./station.ts";

/** What bears on whether the operator may rely on what is shown; undefined: not known, or too old. */
export interface LinkFigures {
  /** Lost share of the probes [%]. */
  readonly perPercent: number | undefined;
  /** The lowest QNI of both sides lately [0, 100]. */
  readonly qni: number | undefined;
  /** Lost share of the routers' transmissions, of the worse side [%]. */
  readonly lossPercent: number | undefined;
  /** Age of the position that is shown, or the wait in the vehicle's radio if that is longer [ms]. */
  readonly ageMs: number | undefined;
}

export const gradeWords = ["very poor", "poor", "fair", "good", "very good"] as const;
export type LinkWord = (typeof gradeWords)[number] | "unknown";
const goodStep = gradeWords.indexOf("good");

export interface LinkGrade {
  readonly word: LinkWord;
  readonly isGood: boolean;
  /** The figures that are below good, the worst first; where all are good, what is known. */
  readonly figures: readonly string[];
}

/** Upper limits of "very good", "good", "fair" and "poor". */
const lossLimits = [5, 10, 20, 40];
const ageLimitsMs = [500, 1000, 3000, 6000];
/** Older measurements say nothing of the link now: the vehicle measures once a second. */
export const measuredWithinMs = 5000;

interface Judged {
  readonly step: number;
  readonly text: string;
}

/** Good only where PER or QNI is known, and the age of what is shown. */
export function gradeLink({ perPercent, qni, lossPercent, ageMs }: LinkFigures): LinkGrade {
  const known = [
    judge(perPercent, (value) => stepBelow(value, lossLimits), (value) => `PER ${value.toFixed(0)} %`),
    judge(qni, (value) => qualityStep(value) ?? 0, (value) => `QNI ${value.toFixed(0)}`),
    judge(lossPercent, (value) => stepBelow(value, lossLimits), (value) => `loss ${value.toFixed(0)} %`),
    judge(ageMs, (value) => stepBelow(value, ageLimitsMs), (value) => `position ${ageText(value)} old`),
  ].filter((one) => one !== undefined);
  const isMeasured = (perPercent ?? qni) !== undefined && ageMs !== undefined;
  const worst = Math.min(...known.map(({ step }) => step));
  const isGood = isMeasured && worst >= goodStep;
  const told = isGood ? known : known.filter(({ step }) => step < goodStep).sort((a, b) => a.step - b.step);
  const isUnknown = !isMeasured && worst >= goodStep;
  return { word: isUnknown ? "unknown" : (gradeWords[worst] ?? "unknown"), isGood, figures: told.map(({ text }) => text) };
}

function judge(
  value: number | undefined,
  step: (value: number) => number,
  text: (value: number) => string,
): Judged | undefined {
  return value === undefined ? undefined : { step: step(value), text: text(value) };
}

/** The step of a value of which less is better. */
function stepBelow(value: number, limits: readonly number[]): number {
  const index = limits.findIndex((limit) => value < limit);
  return index < 0 ? 0 : limits.length - index;
}

/** The lowest of this time [ms] counts: single samples scatter, and one good sample is no good link. */
const qniWithinMs = 3000;

/** As far as the station knows them at `now`. */
export function figuresOf({ quality, uxv, gcs, location }: Station, now: number): LinkFigures {
  const sides = [uxv, gcs];
  const qnis = sides.map((side) => lowestQni(side, now)).filter(isNumber);
  const losses = sides.map(({ link }) => fresh(link, now)?.loss).filter(isNumber);
  const waitS = fresh(uxv.link, now)?.backlog_s;
  const per = fresh(quality, now)?.per_percent;
  return {
    perPercent: isNumber(per) ? per : undefined,
    qni: qnis.length > 0 ? Math.min(...qnis) : undefined,
    lossPercent: losses.length > 0 ? 100 * Math.max(...losses) : undefined,
    ageMs: location === undefined ? undefined : Math.max(now - location.at, isNumber(waitS) ? 1000 * waitS : 0),
  };
}

function lowestQni({ transmission, decisions }: Side, now: number): number | undefined {
  const newest = fresh(transmission, now)?.qni;
  if (!isNumber(newest)) return undefined;
  const recent = decisions.decisions.slice(-10).filter(({ at }) => now - at <= qniWithinMs);
  return Math.min(newest, ...recent.map(({ qni }) => qni ?? newest));
}

const isNumber = (value: number | undefined): value is number => value !== undefined && Number.isFinite(value);

const fresh = <Value>(heard: Heard<Value> | undefined, now: number): Value | undefined =>
  heard !== undefined && now - heard.at <= measuredWithinMs ? heard.value : undefined;
