// SPDX-License-Identifier: Apache-2.0
import { type Point, distance } from "../model/geometry.ts";
import { qualitySteps } from "../model/quality.ts";
import type { Trail, TrailPoint } from "../model/trail.ts";

/** How a step of quality is drawn, with and without a pause; the last two are of unknown quality. */
export const lookOf = (step: number | undefined, paused: boolean): number =>
  2 * (step ?? qualitySteps) + (paused ? 1 : 0);

/** What a canvas's Path2D can do, as far as it is used here. */
export interface PathSink {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
}

/** A part of the trail, in map coordinates, that looks the same from end to end. */
export interface TrailPiece<Path> {
  readonly look: number;
  readonly path: Path;
  /** [m] of the same look before it, so that dashes go on where they were. */
  readonly beforeM: number;
}

/** Points of a piece: one path of thousands costs a browser far more than its parts do. */
const longestPiece = 100;

/**
 * A trail in pieces, each of which is drawn once: `added` has what was not given before, `tail` what
 * moves with the vehicle.
 */
export class TrailPieces<Path extends PathSink> {
  #taken = 0;
  #last: { readonly point: TrailPoint; readonly look: number; readonly lengthM: number } | undefined;

  constructor(private readonly make: () => Path) {}

  /** Everything is given again. */
  restart(): void {
    this.#taken = 0;
    this.#last = undefined;
  }

  /** Of one trail that only grows; after anything else, `restart` first. */
  added(trail: Trail): TrailPiece<Path>[] {
    const pieces: TrailPiece<Path>[] = [];
    let length = 0;
    for (; this.#taken < trail.points.length; ++this.#taken) {
      const point = trail.points[this.#taken];
      const before = this.#last;
      if (point === "gap" || point === undefined) {
        this.#last = undefined;
        continue;
      }
      const look = lookOf(point.step, point.paused);
      if (before !== undefined) {
        if (length === 0 || before.look !== look || length === longestPiece) {
          pieces.push(this.#pieceFrom(before, look));
          length = 0;
        }
        pieces.at(-1)?.path.lineTo(point.x, point.y);
        ++length;
      }
      this.#last = { point, look, lengthM: lengthAt(before, look, point) };
      if (before === undefined) length = 0;
    }
    return pieces;
  }

  /** From the last point that was taken to where the vehicle is. */
  tail({ tail }: Trail): TrailPiece<Path>[] {
    if (tail === undefined || this.#last === undefined) return [];
    const piece = this.#pieceFrom(this.#last, lookOf(tail.step, tail.paused));
    piece.path.lineTo(tail.x, tail.y);
    return [piece];
  }

  #pieceFrom(last: { point: Point; look: number; lengthM: number }, look: number): TrailPiece<Path> {
    const path = this.make();
    path.moveTo(last.point.x, last.point.y);
    return { look, path, beforeM: last.look === look ? last.lengthM : 0 };
  }
}

/** [m] of one look up to `point`. */
function lengthAt(before: { point: Point; look: number; lengthM: number } | undefined, look: number, point: Point): number {
  if (before === undefined) return 0;
  return (before.look === look ? before.lengthM : 0) + distance(before.point, point);
}
