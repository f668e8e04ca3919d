// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { ScanOnMap } from "../src/model/scan.ts";

const stamp = (ms: number): { sec: number; nanosec: number } => ({ sec: Math.floor(ms / 1000), nanosec: (ms % 1000) * 1e6 });
const turned = { x: 0, y: 0, z: 1, w: 0 }; // by half a turn

/** A laser that sits 0.1 m before the middle and looks backwards. */
const mounted = (): ScanOnMap => {
  const sut = new ScanOnMap();
  const transform = { translation: { x: 0.1, y: 0, z: 0.2 }, rotation: turned };
  sut.onTransforms({ transforms: [{ header: { stamp: stamp(1), frame_id: "base_link" }, child_frame_id: "laser", transform }] });
  return sut;
};

const scanAt = (ms: number, ranges: number[]): Parameters<ScanOnMap["onScan"]>[0] => ({
  header: { stamp: stamp(ms), frame_id: "laser" },
  angle_min: 0,
  angle_max: Math.PI / 2,
  angle_increment: Math.PI / 2,
  time_increment: 0,
  scan_time: 0.1,
  range_min: 0.15,
  range_max: 12,
  ranges,
  intensities: [],
});

const near = (points: readonly { x: number; y: number }[], wanted: number[][]): void => {
  assert.equal(points.length, wanted.length);
  points.forEach(({ x, y }, i) => assert.ok(Math.hypot(x - (wanted[i]?.[0] ?? NaN), y - (wanted[i]?.[1] ?? NaN)) < 1e-9));
};

describe("ScanOnMap", () => {
  it("a scan lies where the vehicle was when it was made", () => {
    const sut = mounted();
    sut.onLocation(stamp(10000), { x: 5, y: 1, yaw: Math.PI / 2 });
    sut.onLocation(stamp(10200), { x: 5, y: 2, yaw: Math.PI / 2 });
    sut.onScan(scanAt(10190, [2, 1]));
    near(sut.points(), [[5, 0.05], [6, 2.05]]);
    sut.onScan(scanAt(10010, [2, 1]));
    near(sut.points(), [[5, -0.85], [6, 1.15]]);
  });

  it("each beam lies where the vehicle was when it was measured", () => {
    const sut = mounted();
    sut.onLocation(stamp(10000), { x: 0, y: 0, yaw: 0 });
    sut.onLocation(stamp(10200), { x: 0, y: 0, yaw: Math.PI / 2 });
    sut.onScan({ ...scanAt(10000, [2.1, 1]), time_increment: 0.2 });
    near(sut.points(), [[-2, 0], [1, 0.1]]);
  });

  it("after the last location the vehicle goes on as before, the short way round", () => {
    const sut = mounted();
    sut.onLocation(stamp(10000), { x: 0, y: 0, yaw: Math.PI - 0.1 });
    sut.onLocation(stamp(10200), { x: 0.2, y: 0, yaw: -Math.PI + 0.1 });
    sut.onScan(scanAt(10100, [2.1]));
    near(sut.points(), [[2.1, 0]]);
    sut.onScan(scanAt(10300, [2.1]));
    near(sut.points(), [[0.3 + 2 * Math.cos(0.2), 2 * Math.sin(0.2)]]);
  });

  it("what met nothing, is too near, or is no number, is no point", () => {
    const sut = mounted();
    sut.onLocation(stamp(10000), { x: 0, y: 0, yaw: 0 });
    sut.onScan(scanAt(10000, [Infinity, 12, 0.1, NaN, 2]));
    assert.equal(sut.points().length, 1);
  });

  it("nothing is shown of a turn whose place is not known", () => {
    const sut = mounted();
    sut.onScan(scanAt(10000, [2, 1]));
    assert.equal(sut.points().length, 0);
    sut.onLocation(stamp(10400), { x: 0, y: 0, yaw: 0 });
    assert.equal(sut.points().length, 0, "too late");
    const unmounted = new ScanOnMap();
    unmounted.onLocation(stamp(10000), { x: 0, y: 0, yaw: 0 });
    unmounted.onScan(scanAt(10000, [2, 1]));
    assert.equal(unmounted.points().length, 0);
  });

  it("forgets the last turn", () => {
    const sut = mounted();
    sut.onLocation(stamp(10000), { x: 0, y: 0, yaw: 0 });
    sut.onScan(scanAt(10000, [2, 1]));
    sut.forget();
    assert.equal(sut.points().length, 0);
  });
});
