// SPDX-License-Identifier: Apache-2.0
import { type Point, distance } from "./geometry.ts";
import { qualityStep } from "./quality.ts";

/** A step of the way, with how the link was there. */
export interface TrailPoint extends Point {
  /** Step of quality, see quality.ts; undefined: not known. */
  readonly step: number | undefined;
  /** The vehicle's pausable topics were silent there. */
  readonly paused: boolean;
}

const spacingM = 0.05;
/** Farther apart are two points only when nothing was heard between them. */
const gapM = 2;
/** 20,000 points are a kilometre. */
export const longestTrail = 20_000;

/** Where the vehicle has been. Points are never changed, only added; `version` counts upwards. */
export class Trail {
  readonly points: (TrailPoint | "gap")[] = [];
  version = 0;

  add(place: Point, qni: number | undefined, paused: boolean): void {
    const point = { x: place.x, y: place.y, step: qualityStep(qni), paused };
    const last = this.points.at(-1);
    if (last !== undefined && last !== "gap") {
      const way = distance(last, place);
      const same = last.step === point.step && last.paused === point.paused;
      if (way < (same ? spacingM : spacingM / 5)) return;
      if (way > gapM) this.points.push("gap");
    }
    this.points.push(point);
    if (this.points.length > longestTrail) this.points.splice(0, longestTrail / 10);
    ++this.version;
  }

  clear(): void {
    this.points.length = 0;
    ++this.version;
  }
}
