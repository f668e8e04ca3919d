// SPDX-License-Identifier: Apache-2.0
import type { LinkClass, LinkState } from "./messages.ts";

/** What a router did with one traffic class lately, and since it started. */
export interface ClassRow {
  readonly name: string;
  /** A second, over the last few seconds; undefined while that is not known. */
  readonly deliveredHz: number | undefined;
  readonly bytesPerS: number | undefined;
  readonly delivered: number;
  readonly late: number;
  readonly lost: number;
  readonly repaired: number;
  readonly paused: number;
  /** Thinned, superseded, expired, overflow: not sent for another reason than the gate. */
  readonly otherDropped: number;
  readonly waiting: number;
  readonly delayMs: number | undefined;
}

interface Sample {
  readonly at: number;
  readonly delivered: number;
  readonly bytes: number;
}

const windowMs = 5000;

/** Makes rates of the counts that a router tells. A router that restarts begins anew. */
export class LinkClasses {
  #samples = new Map<string, Sample[]>();
  #rows: ClassRow[] = [];

  rows(): readonly ClassRow[] {
    return this.#rows;
  }

  onState(state: LinkState, now: number): void {
    this.#rows = state.classes.map((one) => this.#row(one, now));
  }

  #row(one: LinkClass, now: number): ClassRow {
    const sample = { at: now, delivered: Number(one.delivered), bytes: Number(one.bytes) };
    let samples = this.#samples.get(one.traffic_class) ?? [];
    if ((samples.at(-1)?.bytes ?? 0) > sample.bytes) samples = [];
    samples = [...samples.filter(({ at }) => now - at <= windowMs), sample];
    this.#samples.set(one.traffic_class, samples);
    const first = samples[0] ?? sample;
    const seconds = (now - first.at) / 1000;
    const rate = (grown: number): number | undefined => (seconds > 0.5 ? grown / seconds : undefined);
    return {
      name: one.traffic_class,
      deliveredHz: rate(sample.delivered - first.delivered),
      bytesPerS: rate(sample.bytes - first.bytes),
      delivered: sample.delivered,
      late: Number(one.late),
      lost: Number(one.lost),
      repaired: Number(one.repaired),
      paused: Number(one.dropped_paused),
      otherDropped: Number(
        one.dropped_superseded + one.dropped_expired + one.dropped_overflow,
      ),
      waiting: one.queue_samples,
      delayMs: Number.isNaN(one.delay_s) ? undefined : one.delay_s * 1000,
    };
  }
}
