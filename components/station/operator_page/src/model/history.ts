// SPDX-License-Identifier: Apache-2.0
// The trail and the mission from before the page was opened, from the tables of the station's recorder. Pure.
import { yawOf } from "./geometry.ts";
import type { Goal, Waypoint } from "./messages.ts";
import { Route } from "./route.ts";
import { Trail } from "./trail.ts";

export type Row = Readonly<Record<string, string>>;

/** The rows of a table, by the names of its first line. What is cut off at the end, as it is still written, is left out. */
export function rowsOf(text: string): Row[] {
  const lines = text.slice(0, text.lastIndexOf("\n") + 1).split("\n").slice(0, -1).map(cellsOf);
  const [names, ...rows] = lines;
  if (names === undefined) return [];
  return rows
    .filter((cells) => cells.length === names.length)
    .map((cells) => Object.fromEntries(names.map((name, index) => [name, cells[index] ?? ""])));
}

/** Cells are apart by commas; one with commas or quotes is quoted, with each quote twice. No cell has a line end. */
function cellsOf(line: string): string[] {
  const cells = `,${line}`.matchAll(/,(?:"((?:[^"]|"")*)"|([^",]*))/g);
  return [...cells].map(([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain ?? "");
}

export interface Tables {
  readonly location: readonly Row[];
  readonly goal: readonly Row[];
  readonly transmission_state: readonly Row[];
}

export interface History {
  readonly trail: Trail;
  readonly route: Route;
}

export function historyOf({ location, goal, transmission_state }: Tables): History {
  const route = new Route();
  for (const row of goal) route.onGoal(goalOf(row));
  const decisions = transmission_state.filter(({ role }) => role === "uxv");
  const trail = new Trail();
  let next = 0;
  for (const row of location) {
    while (next < decisions.length && number(decisions[next], "receive_s") <= number(row, "receive_s")) ++next;
    const decision = decisions[next - 1];
    const place = { x: number(row, "pose.pose.position.x"), y: number(row, "pose.pose.position.y") };
    const yaw = yawOf({ x: 0, y: 0, z: number(row, "pose.pose.orientation.z"), w: number(row, "pose.pose.orientation.w") });
    if (!Number.isFinite(place.x + place.y + yaw)) continue;
    trail.add(place, decision && number(decision, "qni"), decision?.["active"] === "0");
  }
  return { trail, route };
}

const number = (row: Row | undefined, name: string): number => {
  const text = row?.[name] ?? "";
  return text === "" ? NaN : Number(text);
};

const big = (text: string | undefined): bigint => BigInt.asUintN(64, BigInt(/^-?\d+$/.test(text ?? "") ? (text ?? "0") : "0"));

function goalOf(row: Row): Goal {
  return {
    ...{ stamp: { sec: number(row, "stamp.sec"), nanosec: number(row, "stamp.nanosec") }, id: big(row["id"]) },
    ...{ waypoint: number(row, "waypoint"), x: number(row, "x"), y: number(row, "y"), yaw: number(row, "yaw") },
    ...{ tolerance_m: number(row, "tolerance_m"), lifetime_s: number(row, "lifetime_s"), mission: big(row["mission"]) },
    ahead: placesOf(row["ahead"] ?? "[]"),
  };
}

function placesOf(json: string): Waypoint[] {
  try {
    return JSON.parse(json) as Waypoint[];
  } catch {
    return []; // cut off by the recorder
  }
}
