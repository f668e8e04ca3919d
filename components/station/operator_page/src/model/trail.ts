// SPDX-License-Identifier: Apache-2.0
import { type Point, distance } from "./geometry.ts";
import { qualityStep } from "./quality.ts";

/** A step of the way, with how the link was on the way there. */
export interface TrailPoint extends Point {
  /** Step of quality, see quality.ts; undefined: not known. */
  readonly step: number | undefined;
  /** The vehicle's pausable topics were silent there. */
  readonly paused: boolean;
}

const spacingM = 0.05;
/** Farther apart are two points only when nothing was heard between them. */
const gapM = 2;
/** The line that is drawn is nowhere farther from where the vehicle was. */
const toleranceM = 0.02;
export const longestTrail = 20_000;

/** Directions [rad, relative to the first] in which a straight line passes all points left out. */
interface Cone {
  readonly first: number;
  readonly least: number;
  readonly greatest: number;
}

/**
 * Where the vehicle has been: corners and changes of the link only, as straight stretches need no
 * points between. Points are never changed, only added; behind them comes the tail, the last place.
 */
export class Trail {
  readonly points: (TrailPoint | "gap")[] = [];
  tail: TrailPoint | undefined;
  /** Counts how often old points went away. */
  cuts = 0;
  /** Of all places since the beginning or `clear`. */
  bounds: { readonly min: Point; readonly max: Point } | undefined;
  #cone: Cone = { first: 0, least: -Infinity, greatest: Infinity };

  add(place: Point, qni: number | undefined, paused: boolean): void {
    const point = { x: place.x, y: place.y, step: qualityStep(qni), paused };
    const before = this.tail ?? this.#corner;
    const isSame = before !== undefined && before.step === point.step && before.paused === paused;
    if (before !== undefined && distance(before, point) < (isSame ? spacingM : spacingM / 5)) return;
    this.#widen(point);
    if (before === undefined || distance(before, point) > gapM) this.#begin(point);
    else if (isSame && this.#continues(point)) this.#narrow(point);
    else this.#turn(point);
  }

  /** Puts what was before in front. */
  prepend(earlier: Trail): void {
    const before = [...earlier.points, ...(earlier.tail ? [earlier.tail] : [])];
    const [last, first] = [before.at(-1), this.points[0] ?? this.tail];
    if (last === undefined) return;
    const isApart = last !== "gap" && first !== undefined && first !== "gap" && distance(last, first) > gapM;
    this.points.unshift(...before, ...(isApart ? (["gap"] as const) : []));
    if (earlier.bounds) [earlier.bounds.min, earlier.bounds.max].forEach((corner) => this.#widen(corner));
    ++this.cuts;
  }

  clear(): void {
    this.points.length = 0;
    this.tail = undefined;
    this.bounds = undefined;
    ++this.cuts;
  }

  #widen({ x, y }: Point): void {
    const { min, max } = this.bounds ?? { min: { x, y }, max: { x, y } };
    this.bounds = {
      min: { x: Math.min(min.x, x), y: Math.min(min.y, y) },
      max: { x: Math.max(max.x, x), y: Math.max(max.y, y) },
    };
  }

  get #corner(): TrailPoint | undefined {
    const last = this.points.at(-1);
    return last === "gap" ? undefined : last;
  }

  #begin(point: TrailPoint): void {
    if (this.tail !== undefined) this.#push(this.tail);
    if (this.points.length > 0) this.points.push("gap");
    this.tail = undefined;
    this.#push(point);
  }

  /** The tail becomes a corner. */
  #turn(point: TrailPoint): void {
    if (this.tail !== undefined) this.#push(this.tail);
    const corner = this.#corner ?? point;
    const first = Math.atan2(point.y - corner.y, point.x - corner.x);
    this.#cone = { first, least: -Infinity, greatest: Infinity };
    this.#narrow(point);
  }

  #continues(point: TrailPoint): boolean {
    const corner = this.#corner;
    if (corner === undefined || this.tail === undefined) return false;
    const angle = this.#angle(corner, point);
    const isFarther = distance(corner, point) > distance(corner, this.tail);
    return isFarther && angle >= this.#cone.least && angle <= this.#cone.greatest;
  }

  #narrow(point: TrailPoint): void {
    const corner = this.#corner ?? point;
    const angle = this.#angle(corner, point);
    const play = Math.asin(Math.min(1, toleranceM / distance(corner, point)));
    const { first, least, greatest } = this.#cone;
    this.#cone = { first, least: Math.max(least, angle - play), greatest: Math.min(greatest, angle + play) };
    this.tail = point;
  }

  #angle(from: Point, to: Point): number {
    const turned = Math.atan2(to.y - from.y, to.x - from.x) - this.#cone.first;
    return Math.atan2(Math.sin(turned), Math.cos(turned));
  }

  #push(point: TrailPoint): void {
    this.points.push(point);
    if (this.points.length <= longestTrail) return;
    this.points.splice(0, longestTrail / 10);
    ++this.cuts;
  }
}
