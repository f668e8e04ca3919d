// SPDX-License-Identifier: Apache-2.0
import { plainTopic } from "../protocol/topic_name.ts";
import type { TrafficReport } from "./messages.ts";

/** What is shown of a topic that crosses the link towards the station. */
export interface TrafficRow {
  readonly topic: string;
  readonly trafficClass: string;
  /** Samples a second that came here, over the last 5 s. */
  readonly rateHz: number;
  /** Since the last sample; undefined before the first [ms]. */
  readonly ageMs: number | undefined;
  /** Here, and by the vehicle in the same time, as far as it has told. */
  readonly received: number;
  readonly sent: number;
  /** By the vehicle's router, since it started. */
  readonly dropped: number;
  readonly paused: boolean;
  /** Of what the vehicle told. */
  readonly reportAgeMs: number;
}

interface Writer {
  sentBefore: number;
  sent: number;
  dropped: number;
}

interface Entry {
  trafficClass: string;
  paused: boolean;
  reportedAt: number;
  readonly writers: Map<string, Writer>;
  recent: number[];
  /** So many may be there before old ones are thrown away. */
  room: number;
  last: number | undefined;
  received: number;
  receivedBefore: number;
}

const windowMs = 5000;
const leastRoom = 1000;
const classes = ["critical", "high", "normal", "low"];
const rank = (name: string): number => (classes.indexOf(name) + classes.length + 1) % (classes.length + 1);

/** Joins what the vehicle's traffic reports say was sent with what came here. */
export class TrafficTable {
  #entries = new Map<string, Entry>();

  onSample(topic: string, now: number): void {
    const entry = this.#entry(topic);
    entry.recent.push(now);
    if (entry.recent.length > entry.room) {
      entry.recent = entry.recent.filter((at) => now - at <= windowMs);
      entry.room = Math.max(leastRoom, 2 * entry.recent.length); // so a burst costs each sample the same
    }
    entry.last = now;
    ++entry.received;
  }

  /** Of the vehicle. Both counts of a topic begin anew when its writer is new or was restarted. */
  onReport(report: TrafficReport, now: number): void {
    for (const told of report.topics) {
      const entry = this.#entry(plainTopic(told.topic));
      const sent = Number(told.sent);
      const before = entry.writers.get(report.process);
      const writer = before ?? { sentBefore: sent, sent, dropped: 0 };
      entry.writers.set(report.process, writer);
      const restarted = sent < writer.sent;
      writer.sent = sent;
      writer.dropped = Number(told.dropped);
      if (before === undefined || restarted) restart(entry);
      entry.trafficClass = told.traffic_class;
      entry.paused = told.paused;
      entry.reportedAt = now;
    }
  }

  /** In the order of the classes, then by name. */
  rows(now: number): TrafficRow[] {
    const rows = [...this.#entries].filter(([, entry]) => entry.writers.size > 0);
    return rows
      .map(([topic, entry]) => row(topic, entry, now))
      .sort((a, b) => rank(a.trafficClass) - rank(b.trafficClass) || a.topic.localeCompare(b.topic));
  }

  #entry(topic: string): Entry {
    const found = this.#entries.get(topic);
    if (found !== undefined) return found;
    const entry: Entry = {
      trafficClass: "",
      paused: false,
      reportedAt: 0,
      writers: new Map(),
      recent: [],
      room: leastRoom,
      last: undefined,
      received: 0,
      receivedBefore: 0,
    };
    this.#entries.set(topic, entry);
    return entry;
  }
}

function restart(entry: Entry): void {
  entry.receivedBefore = entry.received;
  for (const writer of entry.writers.values()) writer.sentBefore = writer.sent;
}

function row(topic: string, entry: Entry, now: number): TrafficRow {
  const writers = [...entry.writers.values()];
  const sent = writers.reduce((sum, writer) => sum + writer.sent - writer.sentBefore, 0);
  const recent = entry.recent.filter((at) => now - at <= windowMs).length;
  return {
    topic,
    trafficClass: entry.trafficClass,
    rateHz: recent / (windowMs / 1000),
    ageMs: entry.last === undefined ? undefined : now - entry.last,
    received: Math.min(sent, entry.received - entry.receivedBefore),
    sent,
    dropped: writers.reduce((sum, writer) => sum + writer.dropped, 0),
    paused: entry.paused,
    reportAgeMs: now - entry.reportedAt,
  };
}
