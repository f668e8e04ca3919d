// SPDX-License-Identifier: Apache-2.0
import type { ComponentChildren } from "preact";

import { ageText, freshness } from "../model/freshness.ts";
import type { ClassRow } from "../model/link_classes.ts";
import type { StoredTopic } from "../model/messages.ts";
import type { Side } from "../model/station.ts";
import type { TrafficRow } from "../model/traffic.ts";
import type { Operator } from "../operator.ts";
import { Age, Panel, count, number } from "./parts.tsx";

/** A column: left out on a phone (minor), or notable in some rows. */
type Column<Row> = readonly [
  head: string,
  cell: (row: Row) => ComponentChildren,
  look?: "minor" | ((row: Row) => boolean),
  title?: string,
];

interface TableOf<Row> {
  readonly name: ComponentChildren;
  readonly columns: readonly Column<Row>[];
  readonly rows: readonly Row[];
  readonly nameOf: (row: Row) => string;
  /** What stands in place of rows; undefined: nothing. */
  readonly empty?: string;
  readonly look?: string;
  readonly isStale?: (row: Row) => boolean;
}

function Table<Row>({ name, columns, rows, nameOf, empty, look = "", isStale }: TableOf<Row>) {
  return (
    <table class={look}>
      <thead>
        <tr>
          <th scope="col">{name}</th>
          {columns.map(([head, , kind, title]) => (
            <th key={head} scope="col" class={kind === "minor" ? kind : ""} title={title}>{head}</th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (
          <tr key={nameOf(row)} class={isStale?.(row) ? "stale" : ""}>
            <th scope="row" title={nameOf(row)}>{nameOf(row)}</th>
            {columns.map(([head, cell, kind]) => (
              <td key={head} class={kind === "minor" ? kind : kind?.(row) ? "notable" : ""}>{cell(row)}</td>
            ))}
          </tr>
        ))}
        {rows.length === 0 && empty && <tr><td colSpan={columns.length + 1} class="muted">{empty}</td></tr>}
      </tbody>
    </table>
  );
}

const ofClass: readonly Column<ClassRow>[] = [
  ["a second", ({ deliveredHz }) => number(deliveredHz, 1), "minor"],
  ["kB/s", ({ bytesPerS }) => number(bytesPerS === undefined ? undefined : bytesPerS / 1000, 1), "minor"],
  ["delivered", ({ delivered }) => count(delivered)],
  ["late", ({ late }) => count(late)],
  ["lost", ({ lost }) => count(lost), ({ lost }) => lost > 0],
  ["repaired", ({ repaired }) => count(repaired)],
  ["paused", ({ paused }) => count(paused), ({ paused }) => paused > 0],
  ["not sent", ({ otherDropped }) => count(otherDropped), "minor", "superseded, expired, overflow"],
];

const lostOf = ({ expired, refused }: StoredTopic): number => Number(expired + refused);
/** Of topics of which nothing is to be lost: what did not cross is kept, and backfilled when the link has room. */
const ofStored: readonly Column<StoredTopic>[] = [
  ["stored", ({ stored }) => count(Number(stored))],
  ["backfilled", ({ backfilled }) => count(Number(backfilled))],
  ["waiting", ({ waiting }) => count(waiting), ({ waiting }) => waiting > 0],
  ["lost", (row) => count(lostOf(row)), (row) => lostOf(row) > 0, "the log had no room for it, or not for long enough"],
];

const ofTopic: readonly Column<TrafficRow>[] = [
  ["class", ({ trafficClass }) => trafficClass, "minor"],
  ["a second", ({ rateHz }) => number(rateHz, 1), "minor"],
  ["age", ({ ageMs }) => (ageMs === undefined ? "–" : ageText(ageMs))],
  ["here of sent", ({ received, sent }) => `${count(received)} of ${count(sent)}`],
  ["gate", ({ paused }) => (paused ? <b class="passive">PAUSED</b> : "open")],
  ["dropped", ({ dropped }) => count(dropped), "minor"],
];

/** What crosses the link: by class as the routers count it, by topic as it comes here. */
export function TrafficPanel({ operator, now }: { operator: Operator; now: number }) {
  const { uxv, gcs, traffic } = operator.station;
  const nameOf = (text: string, { link }: Side) => <>{text}<Age at={link?.at} now={now} /></>;
  const ageOf = ({ link }: Side) => freshness(link?.at, now);
  const classes = (name: string, side: Side) => (
    <Table name={nameOf(name, side)} look={ageOf(side)} columns={ofClass} rows={side.classes.rows()}
      nameOf={(row) => row.name} empty="no router heard yet" />
  );
  const stored = (name: string, side: Side, rows = side.link?.value.stored ?? []) => rows.length > 0 && (
    <Table name={nameOf(name, side)} look={`stored ${ageOf(side)}`} columns={ofStored} rows={rows} nameOf={({ topic }) => topic} />
  );
  return (
    <Panel name="traffic" title="Classes and topics">
      <div class="scroll">
        {classes("Uplink, by class", uxv)}
        {classes("Downlink, by class", gcs)}
        <Table name="From the vehicle, by topic" columns={ofTopic} rows={traffic.rows(now)} nameOf={({ topic }) => topic}
          empty="no report yet" isStale={({ ageMs }) => ageMs === undefined || freshness(-ageMs, 0) !== "fresh"} />
        {stored("Stored, from the vehicle", uxv)}
        {stored("Stored, from the station", gcs)}
      </div>
    </Panel>
  );
}
