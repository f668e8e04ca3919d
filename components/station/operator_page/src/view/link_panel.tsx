// SPDX-License-Identifier: Apache-2.0
import { useCallback } from "preact/hooks";

import { resumesInS } from "../model/alerts.ts";
import type { Heard } from "../model/freshness.ts";
import { freshness } from "../model/freshness.ts";
import type { LinkState, TransmissionState } from "../model/messages.ts";
import { qualityStep } from "../model/quality.ts";
import type { Side } from "../model/station.ts";
import type { Operator } from "../operator.ts";
import { DecisionChart } from "./decision_chart.tsx";
import { Age, Panel, Value, number } from "./parts.tsx";
import { WhatIfBar } from "./what_if_bar.tsx";

/** The radio as it was measured, and what both sides decide by it. */
export function LinkPanel({ operator, now }: { operator: Operator; now: number }) {
  const { quality, uxv, gcs } = operator.station;
  const time = useCallback(() => operator.now(), [operator]);
  const whatIf = useCallback(() => (operator.recordings.player ? undefined : operator.whatIf.result), [operator]);
  return (
    <Panel name="link" title="Link">
      <dl class="values">
        <Value label="PER" heard={quality} now={now} bad={({ per_percent }) => per_percent >= 30}
          show={({ per_percent }) => number(per_percent, 0, "%")} />
        <Value label="RTT" heard={quality} now={now} show={({ rtt_mean_ms }) => number(rtt_mean_ms, 1, "ms")} />
        <Value label="Signal" heard={quality} now={now} show={({ signal_dbm }) => number(signal_dbm, 0, "dBm")} />
        <Value label="Quality" heard={quality} now={now} show={({ quality_percent }) => number(quality_percent, 0, "%")} />
      </dl>
      <div class="sides">
        <SideView name="Vehicle" way="Uplink" side={uxv} now={now} />
        <SideView name="Station" way="Downlink" side={gcs} now={now} />
      </div>
      <DecisionChart uxv={uxv} gcs={gcs} now={time} whatIf={whatIf} />
      <WhatIfBar operator={operator} />
    </Panel>
  );
}

function SideView({ name, way, side, now }: { name: string; way: string; side: Side; now: number }) {
  const { transmission, link } = side;
  if (transmission === undefined) return <div class="side unknown"><h3>{name}</h3><p>no decision yet</p></div>;
  const { value, at } = transmission;
  return (
    <div class={`side ${freshness(at, now)}`}>
      <h3>
        {name} <b class={value.active ? "active" : "passive"}>{value.active ? "sends all" : "PAUSES"}</b>
        <Age at={at} now={now} />
      </h3>
      <Gauge qni={value.qni} />
      <p>{value.policy}: {side.pausedBecause ?? value.reason}</p>
      <p>statistic {number(value.statistic, 1)} of {number(value.threshold, 1)}{resumeText(transmission, now)}</p>
      {link && <p class="muted">{way} {linkText(link.value)}<Age at={link.at} now={now} /></p>}
    </div>
  );
}

function Gauge({ qni }: { qni: number }) {
  const step = qualityStep(qni);
  const known = step !== undefined;
  return (
    <div class="gauge" role="meter" aria-label="QNI" aria-valuemin={0} aria-valuemax={100} aria-valuenow={known ? qni : 0}>
      <i style={known ? `width: ${Math.min(100, Math.max(0, qni))}%; background: var(--quality-${step})` : "width: 0"} />
      <span>QNI {number(qni, 0)}</span>
    </div>
  );
}

function resumeText({ value, at }: Heard<TransmissionState>, now: number): string {
  const left = value.active ? undefined : resumesInS(value.deadline_s, now - at);
  return left === undefined ? "" : `, resumes in ${left.toFixed(0)}\u202fs at most`;
}

function linkText(link: LinkState): string {
  const capacity = link.capacity_measured
    ? number(link.capacity_bytes_per_s / 1000, 0, "kB/s")
    : "capacity not measured";
  const words = [
    capacity,
    `backlog ${number(link.backlog_s * 1000, 0, "ms")}`,
    `loss ${number(link.loss * 100, 0, "%")}`,
    `scale ${number(link.scale, 2)}`,
  ];
  if (link.silent_peers > 0 && link.live_peers === 0) words.push("peer silent");
  const [first, second] = link.paths;
  if (first !== undefined && second !== undefined) {
    words.push(first.chosen ? "by the first path" : "by the second path");
    if ((first.chosen ? second : first).silent) words.push("the other silent");
  }
  return words.join(", ");
}
