// SPDX-License-Identifier: Apache-2.0
// Plane geometry in the map frame: metres, radians, x to the right, y up.
import type { Quaternion, Waypoint } from "./messages.ts";

export interface Point {
  readonly x: number;
  readonly y: number;
}

export const distance = (a: Point, b: Point): number => Math.hypot(a.x - b.x, a.y - b.y);

/** The heading of a rotation about z [rad, -pi to pi]. */
export const yawOf = (q: Quaternion): number =>
  Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));

/** The rotation about z by a heading. */
export const quaternionOf = (yaw: number): Quaternion => ({ x: 0, y: 0, z: Math.sin(yaw / 2), w: Math.cos(yaw / 2) });

export const isFinitePose = (pose: Waypoint): boolean =>
  Number.isFinite(pose.x) && Number.isFinite(pose.y) && Number.isFinite(pose.yaw);

/** An ellipse by its half axes [m] and the direction of the longer one [rad]. */
export interface Ellipse {
  readonly major: number;
  readonly minor: number;
  readonly angle: number;
}

/** 95 % of a normal distribution in the plane lie within so many deviations: sqrt(-2 ln 0.05). */
const deviations95 = Math.sqrt(-2 * Math.log(0.05));

/**
 * Where the position is with 95 %, from a 6 x 6 covariance, row-major (x, y, z, roll, pitch, yaw)
 * [m^2]. Undefined when it is not one, or says nothing (all zero).
 */
export function ellipse95(covariance: ArrayLike<number>): Ellipse | undefined {
  const [xx, xy, yy] = [covariance[0] ?? 0, covariance[1] ?? 0, covariance[7] ?? 0];
  const mean = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  if (!(mean > 0) || !Number.isFinite(spread) || mean - spread < -1e-9) return undefined;
  return {
    major: deviations95 * Math.sqrt(mean + spread),
    minor: deviations95 * Math.sqrt(Math.max(0, mean - spread)),
    angle: Math.atan2(2 * xy, xx - yy) / 2,
  };
}
