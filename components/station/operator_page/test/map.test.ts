// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { noteShift, scaleLengthM } from "../src/map/draw.ts";
import { gridPixels, isFree, knownBounds, signalPixels } from "../src/map/grid.ts";
import { Viewport, greatestScale } from "../src/map/viewport.ts";
import * as make from "./messages.ts";

const size = { width: 400, height: 200 };
const near = (a: { x: number; y: number }, b: { x: number; y: number }): void =>
  assert.ok(Math.hypot(a.x - b.x, a.y - b.y) < 1e-9, `${JSON.stringify(a)} is not ${JSON.stringify(b)}`);

describe("Viewport", () => {
  it("draws y upwards, and finds back what it has drawn", () => {
    const sut = new Viewport({ x: 1, y: 2 }, 10);
    near(sut.toScreen({ x: 2, y: 3 }, size), { x: 210, y: 90 });
    near(sut.toMap(sut.toScreen({ x: -7, y: 5 }, size), size), { x: -7, y: 5 });
  });
  it("keeps under the pointer what lies there when it zooms", () => {
    const sut = new Viewport({ x: 1, y: 2 }, 10);
    const pixel = { x: 30, y: 150 };
    near(sut.zoomed(3, pixel, size).toMap(pixel, size), sut.toMap(pixel, size));
    assert.equal(sut.zoomed(1e9, pixel, size).scale, greatestScale);
  });
  it("moves with the hand", () => {
    const sut = new Viewport({ x: 0, y: 0 }, 10).panned(20, 30);
    near(sut.toScreen({ x: 0, y: 0 }, size), { x: 220, y: 130 });
  });
  it("shows all of a part of the map", () => {
    const sut = Viewport.fitting({ min: { x: -10, y: 0 }, max: { x: 10, y: 20 } }, size);
    for (const corner of [{ x: -10, y: 0 }, { x: 10, y: 20 }]) {
      const { x, y } = sut.toScreen(corner, size);
      assert.ok(x >= 0 && x <= size.width && y >= 0 && y <= size.height);
    }
  });
  it("keeps a row above the map free", () => {
    const top = 46;
    const sut = Viewport.fitting({ min: { x: -10, y: 0 }, max: { x: 10, y: 20 } }, size, top);
    const { y } = sut.toScreen({ x: 0, y: 20 }, size);
    assert.ok(y > top);
    near(sut.toScreen({ x: 0, y: 10 }, size), { x: size.width / 2, y: (top + size.height) / 2 });
  });
});

describe("A note beside a place", () => {
  it("is moved from the edges into the map", () => {
    assert.equal(noteShift(200, 100, 400), 0);
    assert.equal(noteShift(20, 100, 400), 30);
    assert.equal(noteShift(390, 100, 400), -40);
  });
  it("goes with a place that is not on the map", () => {
    assert.equal(noteShift(-10, 100, 400), 0);
    assert.equal(noteShift(500, 100, 400), 0);
  });
});

describe("Grid", () => {
  const grid = make.grid(0.5, 3, [-1, 0, 100, -1, -1, -1], 5, 6);
  it("paints the row with the greatest y first", () => {
    const colours = { free: [1, 1, 1, 255], occupied: [2, 2, 2, 255], unknown: [3, 3, 3, 255] } as const;
    const pixels = gridPixels(grid, colours);
    assert.deepEqual([...pixels].filter((_, index) => index % 4 === 0), [3, 3, 3, 3, 1, 2]);
  });
  it("tints the floor by the link's signal, and leaves clear what is not known", () => {
    const steps = [1, 2, 3, 4, 5].map((red) => [red, 0, 0, 90] as const);
    const pixels = signalPixels(make.grid(0.5, 3, [-1, 0, 100, 40, 60, 10], 5, 6), steps);
    const [reds, alphas] = [0, 3].map((at) => [...pixels].filter((_, index) => index % 4 === at));
    assert.deepEqual(reds, [4, 3, 5, 0, 5, 1]);
    assert.deepEqual(alphas, [90, 90, 90, 0, 90, 90]);
  });
  it("knows where a vehicle may be sent", () => {
    assert.equal(isFree(grid, { x: 5.6, y: 6.4 }), true);
    for (const [x, y] of [[6.1, 6.2], [5.2, 6.2], [5.6, 6.6], [4.9, 6.2], [6.6, 6.2], [NaN, 6.2]] as const) {
      assert.equal(isFree(grid, { x, y }), false, `${x}, ${y}`);
    }
  });
  it("knows which part of it is known", () => {
    assert.deepEqual(knownBounds(grid), { min: { x: 5.5, y: 6 }, max: { x: 6.5, y: 6.5 } });
    assert.equal(knownBounds({ ...grid, data: [-1, -1, -1, -1, -1, -1] }), undefined);
  });
});

describe("Scale", () => {
  it("is a nice length that fits", () => {
    assert.equal(scaleLengthM(30), 2);
    assert.equal(scaleLengthM(400), 0.2);
  });
});
