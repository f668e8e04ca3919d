// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { Backdrop, type Layer, type Scene } from "../src/map/backdrop.ts";
import type { Sheet } from "../src/map/draw.ts";
import type { Theme } from "../src/map/theme.ts";
import { TrailPieces, lookOf } from "../src/map/trail_pieces.ts";
import { Viewport } from "../src/map/viewport.ts";
import { Trail, longestTrail } from "../src/model/trail.ts";
import * as make from "./messages.ts";

class RecordedPath {
  calls: string[] = [];
  moveTo(x: number, y: number): void {
    this.calls.push(`M${x},${y}`);
  }
  lineTo(x: number, y: number): void {
    this.calls.push(`L${x},${y}`);
  }
}

/** To and fro, a corner each. */
const corner = (i: number): { x: number; y: number } => ({ x: 0.1 * Math.abs((i % 80) - 40), y: i % 2 });

/** A trail of so many corners. */
function zigzag(corners: number): Trail {
  const trail = new Trail();
  for (let i = 0; i < corners; ++i) trail.add(corner(i), 80, false);
  return trail;
}

describe("TrailPieces", () => {
  const calls = (pieces: { look: number; path: RecordedPath }[]): unknown[] =>
    pieces.map(({ look, path }) => [look, path.calls.join(" ")]);

  it("goes on where another quality ended, without a gap, up to the vehicle", () => {
    const trail = new Trail();
    const sut = new TrailPieces(() => new RecordedPath());
    trail.add({ x: 0, y: 0 }, 80, false);
    trail.add({ x: 1, y: 0 }, 80, false);
    assert.deepEqual(calls(sut.added(trail)), []);
    assert.deepEqual(calls(sut.tail(trail)), [[lookOf(4, false), "M0,0 L1,0"]]);
    trail.add({ x: 2, y: 0 }, 10, true);
    trail.add({ x: 2, y: 1 }, 10, true);
    const expected = [[lookOf(4, false), "M0,0 L1,0"], [lookOf(0, true), "M1,0 L2,0"]];
    assert.deepEqual(calls(sut.added(trail)), expected);
    assert.deepEqual(calls(sut.added(trail)), [], "each is given once");
    assert.deepEqual(calls(sut.tail(trail)), [[lookOf(0, true), "M2,0 L2,1"]]);
    sut.restart();
    assert.deepEqual(calls(sut.added(trail)), expected);
  });
  it("leaves a gap", () => {
    const trail = new Trail();
    const sut = new TrailPieces(() => new RecordedPath());
    for (const x of [0, 1, 9, 10]) trail.add({ x, y: 0 }, undefined, false);
    assert.deepEqual(calls(sut.added(trail)), [[lookOf(undefined, false), "M0,0 L1,0"]]);
    assert.deepEqual(calls(sut.tail(trail)), [[lookOf(undefined, false), "M9,0 L10,0"]]);
  });
  it("gives the same lines and dashes point by point as at once", () => {
    const whole = zigzag(450);
    const sut = new TrailPieces(() => new RecordedPath());
    const atOnce = sut.added(whole);
    assert.ok(atOnce.length === 5, `${atOnce.length} pieces`);
    const lines = (pieces: { path: RecordedPath }[]): string[] =>
      pieces.flatMap(({ path }) => path.calls).filter((call) => call.startsWith("L"));
    const growing = new Trail();
    const other = new TrailPieces(() => new RecordedPath());
    const parts = Array.from({ length: 450 }, (_, i) => {
      growing.add(corner(i), 80, false);
      return other.added(growing);
    }).flat();
    assert.deepEqual(lines(parts), lines(atOnce));
    for (const { path, beforeM } of atOnce) {
      const same = parts.find((part) => part.path.calls[0] === path.calls[0] && part.beforeM === beforeM);
      assert.ok(same, `dashes of the piece at ${beforeM} m`);
    }
  });
});

/** Counts what is drawn on it; all else that a canvas does is nothing here. */
class CountingContext {
  strokes = 0;
  images: number[][] = [];
  stroke(): void {
    ++this.strokes;
  }
  drawImage(_: unknown, ...box: number[]): void {
    this.images.push(box);
  }
}
const countingContext = (): CountingContext =>
  new Proxy(new CountingContext(), { get: (counts, name) => Reflect.get(counts, name) ?? (() => undefined) });

class Bench {
  readonly front = countingContext();
  readonly back = countingContext();
  resized: number[][] = [];
  paths: RecordedPath[] = [];
  pictures = 0;
  view = new Viewport({ x: 2, y: 0 }, 30);
  size = { width: 400, height: 200 };
  ratio = 1;
  theme = { quality: [], muted: "grey", text: "black", halo: "white" } as unknown as Theme;
  scene: Scene;
  readonly sut = new Backdrop({
    layer: (): Layer => ({
      image: {} as CanvasImageSource,
      context: this.back as unknown as CanvasRenderingContext2D,
      resize: (...size) => this.resized.push(size),
    }),
    path: () => {
      this.paths.push(new RecordedPath());
      return this.paths.at(-1) as unknown as Path2D;
    },
    picture: () => {
      ++this.pictures;
      return {} as CanvasImageSource;
    },
    signalPicture: () => ({}) as CanvasImageSource,
  });

  constructor(trail = zigzag(2000)) {
    this.scene = { map: make.grid(0.5, 2, [0, 0]), linkMap: undefined, accessPoint: { x: 1, y: 1 }, trail };
  }

  /** What one more frame draws. */
  draw(): { front: number; back: number; lines: number; wholes: number } {
    const { front, back, paths, resized } = this;
    front.strokes = back.strokes = paths.length = resized.length = 0;
    const sheet: Sheet = { context: front as unknown as CanvasRenderingContext2D, view: this.view, size: this.size, theme: this.theme };
    this.sut.draw(sheet, this.ratio, this.scene);
    const lines = paths.flatMap(({ calls }) => calls).filter((call) => call.startsWith("L")).length;
    return { front: front.strokes, back: back.strokes, lines, wholes: resized.length };
  }
}

describe("Backdrop", () => {
  it("draws as much for a new place with a long trail as with a short one", () => {
    const costs = [20, 200, 2000, longestTrail - 100].map((corners) => {
      const sut = new Bench(zigzag(corners));
      sut.draw();
      return Array.from({ length: 50 }, (_, i) => {
        sut.scene.trail.add(corner(corners + i), 80, false);
        return sut.draw();
      });
    });
    for (const cost of costs) {
      for (const frame of cost) assert.deepEqual(frame, { front: 1, back: 1, lines: 2, wholes: 0 });
    }
  });
  it("draws nothing but the tail and one picture when nothing is new", () => {
    const sut = new Bench();
    const first = sut.draw();
    assert.equal(first.wholes, 1);
    assert.ok(first.lines >= 1998, `${first.lines} lines`);
    sut.front.images = [];
    assert.deepEqual(sut.draw(), { front: 1, back: 0, lines: 1, wholes: 0 });
    assert.deepEqual(sut.front.images, [[-100, -50, 600, 300]]);
    assert.equal(sut.pictures, 1);
  });
  const changes: Record<string, (sut: Bench) => void> = {
    "the scale": (sut) => (sut.view = new Viewport(sut.view.centre, 31)),
    "the size": (sut) => (sut.size = { width: 401, height: 200 }),
    "the pixels of the screen": (sut) => (sut.ratio = 2),
    "the colours": (sut) => (sut.theme = { ...sut.theme }),
    "the map": (sut) => (sut.scene = { ...sut.scene, map: undefined }),
    "the link's map": (sut) => (sut.scene = { ...sut.scene, linkMap: make.grid(1, 1, [50]) }),
    "the access point": (sut) => (sut.scene = { ...sut.scene, accessPoint: { x: 1, y: 2 } }),
    "the trail": (sut) => (sut.scene = { ...sut.scene, trail: zigzag(3) }),
    "the trail's beginning": (sut) => sut.scene.trail.clear(),
  };
  for (const [what, change] of Object.entries(changes)) {
    it(`draws all again, once, for a change of ${what}`, () => {
      const sut = new Bench();
      sut.draw();
      change(sut);
      assert.equal(sut.draw().wholes, 1);
      assert.equal(sut.draw().wholes, 0);
    });
  }
  it("moves the picture by whole pixels while its margin lasts, then draws all again", () => {
    const sut = new Bench();
    sut.draw();
    sut.view = sut.view.panned(99.3, -49.8);
    sut.front.images = [];
    assert.equal(sut.draw().wholes, 0);
    assert.deepEqual(sut.front.images, [[-1, -100, 600, 300]]);
    sut.view = sut.view.panned(1, 0);
    assert.equal(sut.draw().wholes, 1);
    assert.deepEqual(sut.front.images.at(-1), [-100, -50, 600, 300]);
  });
  it("does without map, access point and trail", () => {
    const sut = new Bench(new Trail());
    sut.scene = { map: undefined, linkMap: undefined, accessPoint: undefined, trail: sut.scene.trail };
    assert.deepEqual(sut.draw(), { front: 0, back: 0, lines: 0, wholes: 1 });
  });
});
