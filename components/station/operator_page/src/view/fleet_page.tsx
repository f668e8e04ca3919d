// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState } from "preact/hooks";

import type { Alarm } from "../fleet/alarms.ts";
import type { Fleet, Row } from "../fleet/fleet.ts";
import { FleetMap } from "../fleet/fleet_map.ts";
import type { AirtimeUse } from "../model/messages.ts";
import { ageText } from "../model/freshness.ts";
import { pageNow } from "../page_now.ts";
import { Panel, Value, number } from "./parts.tsx";
import { StopButton } from "./stop_button.tsx";

const drawnEveryMs = 200;

/** All vehicles: who needs a person first, on the map, and what happened. */
export function FleetPage({ fleet }: { fleet: Fleet }) {
  const [, draw] = useState(0);
  const now = pageNow();
  useEffect(() => {
    const timer = setInterval(() => draw((count) => count + 1), drawnEveryMs);
    return () => clearInterval(timer);
  }, []);
  useEffect(() => listenToSpace(fleet), [fleet]);
  const rows = fleet.rows();
  return (
    <>
      <FleetHeader fleet={fleet} rows={rows} />
      <main class="board fleet">
        <Panel name="map" title="Map"><FleetMapFrame fleet={fleet} /></Panel>
        <Panel name="vehicles" title="Vehicles">
          {fleet.isKnown ? <ul>{rows.map((row) => <VehicleRow key={row.name} row={row} now={now} />)}</ul> : <p class="muted">Asking the station.</p>}
        </Panel>
        <AlarmPanel fleet={fleet} now={now} />
      </main>
    </>
  );
}

function FleetHeader({ fleet, rows }: { fleet: Fleet; rows: readonly Row[] }) {
  const needing = rows.filter(({ finding }) => finding.severity === "error" || finding.severity === "warning").length;
  const words = needing === 0 ? "none needs a person" : needing === 1 ? "1 needs a person" : `${needing} need a person`;
  return (
    <header class="top">
      <div class="brand">
        <strong>Tocsin</strong>
        <span class="muted">{rows.length} vehicles, {words}</span>
      </div>
      <div class="stop all">
        <button type="button" class="press" title="Emergency stop of all vehicles (space bar)" onPointerDown={() => fleet.stopAll()} onClick={() => fleet.stopAll()}>
          STOP ALL<kbd>space</kbd>
        </button>
      </div>
    </header>
  );
}

/** Of the channel, for what can wait; a vehicle alone on it has no bound. */
function airText({ used, share }: AirtimeUse): string {
  return share < 1 ? `${number(100 * used, 0)} of ${number(100 * share, 0)} %` : number(100 * used, 0, "%");
}

/** Placed by its rank in the style: elements that are moved lose focus, and Chromium keeps old colours in them. */
function VehicleRow({ row: { name, member, finding, page, rank }, now }: { row: Row; now: number }) {
  const { station } = member;
  const is = `is-${finding.severity}`;
  return (
    <li class={`vehicle-row ${is}`} style={{ order: rank }}>
      <h3 class={is}><a href={page} target="_blank" rel="noreferrer">{name}</a></h3>
      <p role="status" class={is}>{finding.text}</p>
      <dl class="values">
        <Value label="Mission" heard={station.mission} now={now} show={({ state, waypoint, waypoints }) => (waypoints > 0 ? `${state} ${waypoint + 1}/${waypoints}` : state)} />
        <Value label="QNI" heard={station.uxv.transmission} now={now} show={({ qni }) => number(qni, 0)} />
        <Value label="Air" heard={station.airtime} now={now} show={airText} />
        <Value label="Battery" heard={station.battery} now={now} show={({ percentage }) => number(100 * percentage, 0, "%")} bad={({ percentage }) => percentage < 0.2} />
      </dl>
      <StopButton operator={member} now={now} hasKey={false} />
    </li>
  );
}

function AlarmPanel({ fleet, now }: { fleet: Fleet; now: number }) {
  const { list } = fleet.alarms;
  const open = list.filter(({ acknowledged }) => !acknowledged);
  return (
    <Panel name="alarms" title="Alarms" aside={<span class="muted">{open.length} not acknowledged</span>}>
      {list.length === 0 && <p class="muted">There was none since this page was opened.</p>}
      <ul>{list.map((alarm) => <AlarmLine key={`${alarm.vehicle} ${alarm.kind}`} alarm={alarm} now={now} onKnown={() => fleet.alarms.acknowledge(alarm)} />)}</ul>
    </Panel>
  );
}

function AlarmLine({ alarm, now, onKnown }: { alarm: Alarm; now: number; onKnown: () => void }) {
  const { vehicle, severity, text, since, until, acknowledged, times } = alarm;
  const when = until === undefined ? `for ${ageText(now - since)}` : `over for ${ageText(now - until)}`;
  return (
    <li class={`alarm is-${until === undefined ? severity : "over"}${acknowledged ? " is-known" : ""}`}>
      <b class={until === undefined ? `is-${severity}` : ""}>{vehicle}</b>
      <span>{text}{times > 1 && ` (${times} times)`}</span>
      <span class="muted">{when}</span>
      {!acknowledged && <button type="button" onClick={onKnown}>Acknowledge</button>}
    </li>
  );
}

function FleetMapFrame({ fleet }: { fleet: Fleet }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    if (canvas.current === null) return;
    const map = new FleetMap(canvas.current, fleet, pageNow);
    return () => map.dispose();
  }, [fleet]);
  return <div class="map-frame"><canvas ref={canvas} aria-label="Map with all vehicles" /></div>;
}

/** Stops all, wherever the focus is. */
function listenToSpace(fleet: Fleet): () => void {
  const down = (event: KeyboardEvent): void => {
    if (event.code !== "Space") return;
    event.preventDefault();
    event.stopPropagation();
    if (!event.repeat) fleet.stopAll();
  };
  const up = (event: KeyboardEvent): void => {
    if (event.code === "Space") event.preventDefault(); // it would press the button in focus
  };
  window.addEventListener("keydown", down, { capture: true });
  window.addEventListener("keyup", up, { capture: true });
  return () => {
    window.removeEventListener("keydown", down, { capture: true });
    window.removeEventListener("keyup", up, { capture: true });
  };
}
