// SPDX-License-Identifier: Apache-2.0
// A mission that is edited on the map. Pure: each step gives a draft of its own.
import { type Point, distance } from "./geometry.ts";
import type { Waypoint } from "./messages.ts";

export interface MissionDraft {
  readonly places: readonly Waypoint[];
  /** Index of the place that keys and buttons change; none when there is no place. */
  readonly selected: number | undefined;
}

export const emptyDraft: MissionDraft = { places: [], selected: undefined };

/** A draft of these places, the last one selected. */
export const draftOf = (places: readonly Waypoint[]): MissionDraft => ({
  places: places.map(({ x, y, yaw }) => ({ x, y, yaw })),
  selected: places.length > 0 ? places.length - 1 : undefined,
});

export const select = (draft: MissionDraft, index: number): MissionDraft =>
  index >= 0 && index < draft.places.length ? { ...draft, selected: index } : draft;

/** Behind the selected place; selects it. It heads away from the place before, or from `from`. */
export function add(draft: MissionDraft, place: Point, from?: Point): MissionDraft {
  const index = draft.selected === undefined ? draft.places.length : draft.selected + 1;
  const before = draft.places[index - 1] ?? from;
  const yaw = before ? Math.atan2(place.y - before.y, place.x - before.x) : 0;
  return { places: spliced(draft.places, index, 0, { x: place.x, y: place.y, yaw }), selected: index };
}

/** Changes of the selected place. */
function changed(draft: MissionDraft, change: (place: Waypoint) => Waypoint): MissionDraft {
  const { places, selected } = draft;
  const place = selected === undefined ? undefined : places[selected];
  if (selected === undefined || place === undefined) return draft;
  return { places: spliced(places, selected, 1, change(place)), selected };
}

export const moveTo = (draft: MissionDraft, { x, y }: Point): MissionDraft => changed(draft, ({ yaw }) => ({ x, y, yaw }));

export const moveBy = (draft: MissionDraft, dx: number, dy: number): MissionDraft =>
  changed(draft, ({ x, y, yaw }) => ({ x: x + dx, y: y + dy, yaw }));

export const turnTo = (draft: MissionDraft, yaw: number): MissionDraft => changed(draft, (place) => ({ ...place, yaw: wrap(yaw) }));

export const turnBy = (draft: MissionDraft, angle: number): MissionDraft =>
  changed(draft, (place) => ({ ...place, yaw: wrap(place.yaw + angle) }));

/** Without the selected place; the one that follows is selected, else the last. */
export function remove(draft: MissionDraft): MissionDraft {
  if (draft.selected === undefined) return draft;
  const places = spliced(draft.places, draft.selected, 1);
  return { places, selected: places.length === 0 ? undefined : Math.min(draft.selected, places.length - 1) };
}

/** The selected place `by` places later in the order; negative: earlier. Stays within the mission. */
export function reorder(draft: MissionDraft, by: number): MissionDraft {
  const { places, selected } = draft;
  const place = selected === undefined ? undefined : places[selected];
  if (selected === undefined || place === undefined) return draft;
  const target = Math.min(places.length - 1, Math.max(0, selected + by));
  return { places: spliced(spliced(places, selected, 1), target, 0, place), selected: target };
}

/** The place that lies nearest to a point, within `reach`; of equal ones the later, which is drawn on top. */
export function placeAt({ places }: MissionDraft, point: Point, reach: number): number | undefined {
  let best: { index: number; away: number } | undefined;
  places.forEach((place, index) => {
    const away = distance(place, point);
    if (away <= reach && (best === undefined || away <= best.away)) best = { index, away };
  });
  return best?.index;
}

/** Array.prototype.toSpliced, which Firefox 113 and node 18 lack. */
const spliced = (places: readonly Waypoint[], index: number, count: number, ...others: Waypoint[]): Waypoint[] => [
  ...places.slice(0, index),
  ...others,
  ...places.slice(index + count),
];

const wrap = (angle: number): number => Math.atan2(Math.sin(angle), Math.cos(angle));
