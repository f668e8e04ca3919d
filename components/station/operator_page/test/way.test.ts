// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { isFree } from "../src/map/grid.ts";
import { WayAhead, WayFinder } from "../src/map/way.ts";
import { type Point, distance } from "../src/model/geometry.ts";
import type { OccupancyGrid } from "../src/model/messages.ts";
import * as make from "./messages.ts";

/** A room of 6 m x 4 m in cells of 5 cm, with a wall at x = 3 from y = 0 to `wallTo`. */
function room(wallTo: number): OccupancyGrid {
  const [width, height, resolution] = [120, 80, 0.05];
  const data = new Int8Array(width * height);
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      const isEdge = row === 0 || column === 0 || row === height - 1 || column === width - 1;
      const isWall = (column === 59 || column === 60) && row * resolution < wallTo;
      data[row * width + column] = isEdge || isWall ? 100 : 0;
    }
  }
  return make.grid(resolution, width, data);
}

const [left, right] = [{ x: 1, y: 1 }, { x: 5, y: 1 }];
const lengthOf = (way: readonly Point[]): number =>
  way.slice(1).reduce((sum, point, index) => sum + distance(way[index] as Point, point), 0);

/** Places along a way, 2 cm apart. */
function along(way: readonly Point[]): Point[] {
  return way.slice(1).flatMap((to, index) => {
    const from = way[index] as Point;
    const steps = Math.max(1, Math.ceil(distance(from, to) / 0.02));
    return Array.from({ length: steps + 1 }, (_, step) => ({
      x: from.x + (step / steps) * (to.x - from.x),
      y: from.y + (step / steps) * (to.y - from.y),
    }));
  });
}

describe("WayFinder", () => {
  it("goes straight where nothing is in between", () => {
    assert.deepEqual(new WayFinder(room(0.5)).way(left, right), [left, right]);
  });
  it("goes around a wall by about the shortest way, and keeps 15 cm from it", () => {
    const map = room(3);
    const way = new WayFinder(map).way(left, right) ?? [];
    assert.deepEqual([way[0], way.at(-1)], [left, right]);
    const shortest = 2 * Math.hypot(2, 2.1);
    assert.ok(lengthOf(way) >= 2 * Math.hypot(1.9, 2) && lengthOf(way) < 1.1 * shortest, `${lengthOf(way)} m of ${shortest}`);
    for (const { x, y } of along(way)) {
      const around = [[0.15, 0], [-0.15, 0], [0, 0.15], [0, -0.15]] as const;
      for (const [dx, dy] of around) assert.ok(isFree(map, { x: x + dx, y: y + dy }), `${x}, ${y}`);
    }
  });
  it("knows no way through a wall, out of the map, or from within one", () => {
    assert.equal(new WayFinder(room(4)).way(left, right), undefined);
    assert.equal(new WayFinder(room(0)).way(left, { x: 9, y: 1 }), undefined);
  });
  it("begins in a wall's clearance, where a vehicle can stand", () => {
    const way = new WayFinder(room(3)).way({ x: 2.85, y: 1 }, left);
    assert.deepEqual([way?.[0], way?.at(-1)], [{ x: 2.85, y: 1 }, left]);
  });
  it("searches a large map in a moment", () => {
    const [width, height] = [700, 500];
    const data = new Int8Array(width * height).map((_, cell) => (cell % width === 350 && cell < 490 * width ? 100 : 0));
    const began = performance.now();
    assert.ok(new WayFinder(make.grid(0.05, width, data)).way({ x: 1, y: 1 }, { x: 34, y: 1 }));
    assert.ok(performance.now() - began < 3000, `${performance.now() - began} ms`);
  });
});

describe("WayAhead", () => {
  it("is straight without a map, and ends with the last place", () => {
    assert.deepEqual(new WayAhead().through(undefined, left, [right]), [[left, right]]);
    assert.deepEqual(new WayAhead().through(undefined, undefined, [left, right]), [[left, right]]);
    assert.deepEqual(new WayAhead().through(room(3), left, []), []);
  });
  it("leads through all places around the walls", () => {
    const [way, ...others] = new WayAhead().through(room(3), left, [right, { x: 5, y: 3 }, left]) as [Point[]];
    assert.deepEqual(others, []);
    assert.ok(lengthOf(way) > 10);
    for (const place of along(way)) assert.ok(isFree(room(3), place));
  });
  it("drops what is passed while the vehicle keeps to it", () => {
    const sut = new WayAhead();
    const map = room(3);
    const [before] = sut.through(map, left, [right]) as [Point[]];
    const beyond = { x: 4, y: 2 };
    const [after] = sut.through(map, beyond, [right]) as [Point[]];
    assert.ok(before.length > 2);
    assert.deepEqual([after[0], after.at(-1)], [beyond, right]);
    assert.ok(lengthOf(after) < 0.5 * lengthOf(before));
  });
  it("is another one when the vehicle has left it, or the map is another", () => {
    const sut = new WayAhead();
    sut.through(room(3), left, [right]);
    const aside = { x: 1, y: 3.5 };
    const [way] = sut.through(room(3), aside, [right]) as [Point[]];
    assert.deepEqual(way[0], aside);
    assert.deepEqual(sut.through(room(0.5), left, [right]), [[left, right]]);
  });
  it("has a gap, and no line through the wall, where the map knows no way", () => {
    const closed = room(4);
    const lines = new WayAhead().through(closed, left, [{ x: 1, y: 3 }, right, { x: 5, y: 3 }]);
    assert.deepEqual(lines.map((line) => [line[0], line.at(-1)]), [[left, { x: 1, y: 3 }], [right, { x: 5, y: 3 }]]);
  });
  it("searches a few new legs in a call, until all are known", () => {
    const sut = new WayAhead();
    const places = Array.from({ length: 1000 }, (_, index) => ({ x: 1 + (index % 7) * 0.2, y: 1 + (index % 11) * 0.2 }));
    let calls = 0;
    do sut.through(room(3), left, places);
    while (!sut.isComplete && ++calls < 1000);
    assert.ok(calls > 10, `${calls}`);
    assert.equal(sut.through(room(3), left, places).length > 0, true);
  });
});
