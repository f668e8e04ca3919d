// SPDX-License-Identifier: Apache-2.0
import { ageText, freshness } from "../model/freshness.ts";
import type { ClassRow } from "../model/link_classes.ts";
import type { StoredTopic } from "../model/messages.ts";
import type { Side } from "../model/station.ts";
import type { TrafficRow } from "../model/traffic.ts";
import type { Operator } from "../operator.ts";
import { Age, Panel, count, number } from "./parts.tsx";

/** What crosses the link: by class as the routers count it, by topic as it comes here. */
export function TrafficPanel({ operator, now }: { operator: Operator; now: number }) {
  const { uxv, gcs, traffic } = operator.station;
  return (
    <Panel name="traffic" title="Classes and topics">
      <div class="scroll">
        <ClassTable name="Uplink, by class" side={uxv} now={now} />
        <ClassTable name="Downlink, by class" side={gcs} now={now} />
        <TopicTable rows={traffic.rows(now)} />
        <StoredTable name="Stored, from the vehicle" side={uxv} now={now} />
        <StoredTable name="Stored, from the station" side={gcs} now={now} />
      </div>
    </Panel>
  );
}

function ClassTable({ name, side, now }: { name: string; side: Side; now: number }) {
  return (
    <table class={freshness(side.link?.at, now)}>
      <thead>
        <tr>
          <th scope="col">{name}<Age at={side.link?.at} now={now} /></th>
          <th scope="col" class="minor">a second</th>
          <th scope="col" class="minor">kB/s</th>
          <th scope="col">delivered</th>
          <th scope="col">late</th>
          <th scope="col">lost</th>
          <th scope="col">repaired</th>
          <th scope="col">paused</th>
          <th scope="col" class="minor" title="superseded, expired, overflow">not sent</th>
        </tr>
      </thead>
      <tbody>
        {side.classes.rows().map((row) => <ClassLine key={row.name} row={row} />)}
        {side.classes.rows().length === 0 && <tr><td colSpan={9} class="muted">no router heard yet</td></tr>}
      </tbody>
    </table>
  );
}

function ClassLine({ row }: { row: ClassRow }) {
  return (
    <tr>
      <th scope="row">{row.name}</th>
      <td class="minor">{number(row.deliveredHz, 1)}</td>
      <td class="minor">{number(row.bytesPerS === undefined ? undefined : row.bytesPerS / 1000, 1)}</td>
      <td>{count(row.delivered)}</td>
      <td>{count(row.late)}</td>
      <td class={row.lost > 0 ? "notable" : ""}>{count(row.lost)}</td>
      <td>{count(row.repaired)}</td>
      <td class={row.paused > 0 ? "notable" : ""}>{count(row.paused)}</td>
      <td class="minor">{count(row.otherDropped)}</td>
    </tr>
  );
}

/** Topics of which nothing is to be lost: what did not cross is kept, and backfilled when the link has room. */
function StoredTable({ name, side, now }: { name: string; side: Side; now: number }) {
  const stored = side.link?.value.stored ?? [];
  if (stored.length === 0) return null;
  return (
    <table class={`stored ${freshness(side.link?.at, now)}`}>
      <thead>
        <tr>
          <th scope="col">{name}<Age at={side.link?.at} now={now} /></th>
          <th scope="col">stored</th>
          <th scope="col">backfilled</th>
          <th scope="col">waiting</th>
          <th scope="col" title="the log had no room for it, or not for long enough">lost</th>
        </tr>
      </thead>
      <tbody>{stored.map((topic) => <StoredLine key={topic.topic} topic={topic} />)}</tbody>
    </table>
  );
}

function StoredLine({ topic }: { topic: StoredTopic }) {
  const lost = Number(topic.expired + topic.refused);
  return (
    <tr>
      <th scope="row" title={topic.topic}>{topic.topic}</th>
      <td>{count(Number(topic.stored))}</td>
      <td>{count(Number(topic.backfilled))}</td>
      <td class={topic.waiting > 0 ? "notable" : ""}>{count(topic.waiting)}</td>
      <td class={lost > 0 ? "notable" : ""}>{count(lost)}</td>
    </tr>
  );
}

function TopicTable({ rows }: { rows: readonly TrafficRow[] }) {
  return (
    <table>
      <thead>
        <tr>
          <th scope="col">From the vehicle, by topic</th>
          <th scope="col" class="minor">class</th>
          <th scope="col" class="minor">a second</th>
          <th scope="col">age</th>
          <th scope="col">here of sent</th>
          <th scope="col">gate</th>
          <th scope="col" class="minor">dropped</th>
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => <TopicLine key={row.topic} row={row} />)}
        {rows.length === 0 && <tr><td colSpan={7} class="muted">no report yet</td></tr>}
      </tbody>
    </table>
  );
}

function TopicLine({ row }: { row: TrafficRow }) {
  const isOld = row.ageMs === undefined || freshness(-row.ageMs, 0) !== "fresh";
  return (
    <tr class={isOld ? "stale" : ""}>
      <th scope="row" title={row.topic}>{row.topic}</th>
      <td class="minor">{row.trafficClass}</td>
      <td class="minor">{number(row.rateHz, 1)}</td>
      <td>{row.ageMs === undefined ? "–" : ageText(row.ageMs)}</td>
      <td>{count(row.received)} of {count(row.sent)}</td>
      <td>{row.paused ? <b class="passive">PAUSED</b> : "open"}</td>
      <td class="minor">{count(row.dropped)}</td>
    </tr>
  );
}
