// SPDX-License-Identifier: Apache-2.0
// The last turn of the laser on the map: where its beams ended.
import { type Point, yawOf } from "./geometry.ts";
import type { LaserScan, Stamp, TFMessage, Waypoint } from "./messages.ts";
import { stampMs } from "./source_clock.ts";

/** So far from a beam in time a place of the vehicle may be to tell where it was then [ms]. */
const nearMs = 300;
const keptPlaces = 20;

/** `point`, given in the frame of `pose`, in the frame that `pose` is given in. */
const moved = ({ x, y }: Point, pose: Waypoint): Point => {
  const [cos, sin] = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
  return { x: pose.x + cos * x - sin * y, y: pose.y + sin * x + cos * y };
};

interface Place {
  readonly ms: number;
  readonly pose: Waypoint;
}

/** Where it was at `ms`, on the way between two places or on from there at the same speed. */
const placeAt = (one: Place, other: Place, ms: number): Waypoint => {
  const share = other.ms === one.ms ? 0 : (ms - one.ms) / (other.ms - one.ms);
  const turn = Math.atan2(Math.sin(other.pose.yaw - one.pose.yaw), Math.cos(other.pose.yaw - one.pose.yaw));
  const along = (from: number, to: number): number => from + share * (to - from);
  return { x: along(one.pose.x, other.pose.x), y: along(one.pose.y, other.pose.y), yaw: one.pose.yaw + share * turn };
};

export class ScanOnMap {
  #mounts = new Map<string, Waypoint>();
  #places: readonly Place[] = [];
  /** In the frame of the vehicle, each with the time of its beam. */
  #turn: readonly { readonly ms: number; readonly point: Point }[] = [];

  onTransforms({ transforms }: TFMessage): void {
    for (const { child_frame_id, transform: { translation, rotation } } of transforms) {
      this.#mounts.set(child_frame_id, { x: translation.x, y: translation.y, yaw: yawOf(rotation) });
    }
  }

  onLocation(stamp: Stamp, pose: Waypoint): void {
    const ms = stampMs(stamp);
    if (ms === undefined) return;
    this.#places = [...this.#places, { ms, pose }].slice(-keptPlaces);
  }

  /** Nothing without the place of its laser on the vehicle. */
  onScan({ header, angle_min, angle_increment, time_increment, range_min, range_max, ranges }: LaserScan): void {
    const mount = this.#mounts.get(header.frame_id);
    const ms = stampMs(header.stamp);
    if (mount === undefined || ms === undefined) return;
    this.#turn = Array.from(ranges).flatMap((range, beam) => {
      if (!(range >= range_min && range < range_max)) return [];
      const bearing = angle_min + beam * angle_increment;
      const point = moved({ x: range * Math.cos(bearing), y: range * Math.sin(bearing) }, mount);
      return [{ ms: ms + 1e3 * beam * time_increment, point }];
    });
  }

  /** In the frame of the map; what was seen where it is not known where the vehicle was then, is left out. */
  points(): readonly Point[] {
    return this.#turn.flatMap(({ ms, point }) => {
      const pose = this.#poseAt(ms);
      return pose === undefined ? [] : [moved(point, pose)];
    });
  }

  #poseAt(ms: number): Waypoint | undefined {
    const places = this.#places;
    const later = places.findIndex((place) => place.ms >= ms);
    const second = Math.max(later < 0 ? places.length - 1 : later, 1);
    const [one, other = one] = places.slice(second - 1, second + 1);
    if (one === undefined || other === undefined) return undefined;
    const away = Math.min(Math.abs(ms - one.ms), Math.abs(ms - other.ms));
    return away > nearMs ? undefined : placeAt(one, other, ms);
  }

  /** What was seen last is not shown any more. */
  forget(): void {
    this.#turn = [];
  }
}
