// SPDX-License-Identifier: Apache-2.0
// The trail from before the page was opened, from the tables of the station's recorder. Pure.
import { yawOf } from "./geometry.ts";
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
  readonly transmission_state: readonly Row[];
}

export interface History {
  readonly trail: Trail;
}

export function historyOf({ location, transmission_state }: Tables): History {
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
  return { trail };
}

const number = (row: Row | undefined, name: string): number => {
  const text = row?.[name] ?? "";
  return text === "" ? NaN : Number(text);
};
