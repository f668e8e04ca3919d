// SPDX-License-Identifier: Apache-2.0
import type { MissionStatus, PlanChoice } from "../model/messages.ts";
import type { Operator } from "../operator.ts";
import { leads } from "../orders/mission_order.ts";
import type { Phase } from "../orders/mission_request.ts";
import { pageNow } from "../page_now.ts";
import { Panel, Value, number } from "./parts.tsx";

/** How far the mission is, by mission_control's word, and what is asked of it. */
export function MissionPanel({ operator, now }: { operator: Operator; now: number }) {
  const { station } = operator;
  const state = station.mission?.value.state;
  const runs = operator.mayAct && leads(station.mission?.value);
  return (
    <Panel name="mission" title="Mission">
      <div class="buttons">
        <button type="button" disabled={!runs} onClick={() => operator.mission.pause(pageNow())}>Pause</button>
        <button type="button" class={state === "paused" ? "go" : ""} disabled={!operator.mayAct || state !== "paused"}
          onClick={() => operator.mission.resume(pageNow())}>
          Resume
        </button>
        <button type="button" disabled={!runs} title="Leave out the present waypoint"
          onClick={() => operator.mission.skipWaypoint(pageNow())}>
          Skip waypoint
        </button>
        <button type="button" disabled={!operator.mayAct || !canCancel(station.mission?.value) || operator.mission.isPending}
          title="End the mission: the vehicle halts" onClick={() => void operator.mission.cancel()}>
          Cancel mission
        </button>
      </div>
      <dl class="values">
        <Value label="Mission" heard={station.mission} now={now} bad={({ state }) => state === "aborted"}
          show={({ mission, state }) => `${mission}: ${state}`} />
        <Value label="Waypoint" heard={station.mission} now={now} show={waypointText} />
        <Value label="Time" heard={station.mission} now={now} show={({ elapsed_s }) => minutes(elapsed_s)} />
        <Value label="Vehicle" heard={station.navigation} now={now} bad={({ state }) => state === "blocked"}
          show={({ state, reason }) => (reason === "" ? state : `${state}: ${reason.replaceAll("_", " ")}`)} />
        <Value label="To go" heard={station.navigation} now={now} show={({ distance_m }) => number(distance_m, 1, "m")} />
        {station.choice && <Value label="Way" heard={station.choice} now={now} show={wayText} />}
        <Value label="At" heard={station.location} now={now}
          show={({ x, y }) => `${x.toFixed(2)}, ${y.toFixed(2)}\u202fm`} />
      </dl>
      {station.mission && <Progress mission={station.mission.value} />}
      <Answer phase={operator.mission.phase} />
    </Panel>
  );
}

/** What mission_control answered to what this page has asked. */
function Answer({ phase }: { phase: Phase }) {
  if (phase.kind === "none") return null;
  const isRefused = phase.kind === "failed";
  const text = isRefused ? `Mission refused: ${phase.reason}` : answers[phase.kind];
  return <p class={isRefused ? "refused" : "answer"} role="status">{text}</p>;
}

const answers = { sending: "Mission sent, no answer yet", accepted: "Mission accepted", canceled: "Mission canceled" };

/** A mission from a file is no goal that can be canceled: it is paused, or another one takes its place. */
const canCancel = (mission: MissionStatus | undefined): boolean =>
  mission?.mission === "follow_waypoints" && (leads(mission) || mission.state === "paused");

function Progress({ mission }: { mission: MissionStatus }) {
  const done = mission.state === "done" ? mission.waypoints : mission.waypoint;
  return <progress value={done} max={Math.max(1, mission.waypoints)} aria-label="Waypoints passed" />;
}

/** What the way costs, and the shortest one, which the map shows dotted, where that is another. */
function wayText({ way_m, silence_s, shortest, shortest_m, shortest_silence_s }: PlanChoice): string {
  const cost = (m: number, s: number): string => `${number(m, 1, "m")}, ${number(s, 0, "s")} without link`;
  const chosen = cost(way_m, silence_s);
  return shortest.length === 0 ? chosen : `${chosen} (shortest: ${cost(shortest_m, shortest_silence_s)})`;
}

const waypointText = ({ waypoint, waypoints }: MissionStatus): string =>
  `${Math.min(waypoint + 1, waypoints)} of ${waypoints}`;

function minutes(seconds: number): string {
  if (!(seconds >= 0)) return "–";
  return `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, "0")}\u202fmin`;
}
