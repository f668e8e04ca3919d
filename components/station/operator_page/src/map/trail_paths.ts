// SPDX-License-Identifier: Apache-2.0
import { qualitySteps } from "../model/quality.ts";
import type { Trail, TrailPoint } from "../model/trail.ts";

/** Index of a path by quality and pause; the last two are of unknown quality. */
export const pathIndex = (step: number | undefined, paused: boolean): number =>
  2 * (step ?? qualitySteps) + (paused ? 1 : 0);
export const pathCount = 2 * (qualitySteps + 1);

/** What a canvas's Path2D can do, as far as it is used here. */
export interface PathSink {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
}

/**
 * A trail as one path for each look, in map coordinates, so that an hour of it is drawn with a
 * dozen calls. Points that were added since the last time are added to the paths.
 */
export class TrailPaths<Path extends PathSink> {
  paths: Path[] = [];
  /** From the last point to where the vehicle is. */
  tail: { readonly path: Path; readonly index: number } | undefined;
  #drawn = 0;
  #version = -1;
  #of: Trail | undefined;
  #last: { point: TrailPoint; path: number } | undefined;

  constructor(private readonly make: () => Path) {
    this.#reset();
  }

  update(trail: Trail): void {
    if (trail === this.#of && trail.version === this.#version) return;
    if (trail !== this.#of || trail.points.length < this.#drawn) this.#reset();
    this.#of = trail;
    this.#version = trail.version;
    for (; this.#drawn < trail.points.length; ++this.#drawn) {
      const point = trail.points[this.#drawn];
      if (point === "gap" || point === undefined) this.#last = undefined;
      else this.#add(point);
    }
    this.tail = this.#tailOf(trail.tail);
  }

  #add(point: TrailPoint): void {
    const index = pathIndex(point.step, point.paused);
    const path = this.paths[index];
    if (path === undefined) return;
    if (this.#last !== undefined) {
      if (this.#last.path !== index) path.moveTo(this.#last.point.x, this.#last.point.y);
      path.lineTo(point.x, point.y);
    } else {
      path.moveTo(point.x, point.y);
    }
    this.#last = { point, path: index };
  }

  #tailOf(point: TrailPoint | undefined): { path: Path; index: number } | undefined {
    if (point === undefined || this.#last === undefined) return undefined;
    const path = this.make();
    path.moveTo(this.#last.point.x, this.#last.point.y);
    path.lineTo(point.x, point.y);
    return { path, index: pathIndex(point.step, point.paused) };
  }

  #reset(): void {
    this.paths = Array.from({ length: pathCount }, this.make);
    this.#drawn = 0;
    this.#last = undefined;
  }
}
