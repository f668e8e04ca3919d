// SPDX-License-Identifier: Apache-2.0
// The last turn of the laser on the map: where its beams ended.
import { type Point, yawOf } from "./geometry.ts";
import type { LaserScan, Stamp, TFMessage, Waypoint } from "./messages.ts";
import { stampMs } from "./source_clock.ts";

/** So far from a scan in time a place of the vehicle may be to be its place [ms]. */
const nearMs = 300;
const keptPoses = 20;

/** `point`, given in the frame of `pose`, in the frame that `pose` is given in. */
const moved = ({ x, y }: Point, pose: Waypoint): Point => {
  const [cos, sin] = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
  return { x: pose.x + cos * x - sin * y, y: pose.y + sin * x + cos * y };
};

export class ScanOnMap {
  #mounts = new Map<string, Waypoint>();
  #poses: { readonly ms: number; readonly pose: Waypoint }[] = [];
  /** Of the vehicle, with the time of the turn. */
  #turn: { readonly ms: number; readonly points: readonly Point[] } | undefined;

  onTransforms({ transforms }: TFMessage): void {
    for (const { child_frame_id, transform: { translation, rotation } } of transforms) {
      this.#mounts.set(child_frame_id, { x: translation.x, y: translation.y, yaw: yawOf(rotation) });
    }
  }

  onLocation(stamp: Stamp, pose: Waypoint): void {
    const ms = stampMs(stamp);
    if (ms === undefined) return;
    this.#poses = [...this.#poses, { ms, pose }].slice(-keptPoses);
  }

  /** Nothing without the place of its laser on the vehicle. */
  onScan({ header, angle_min, angle_increment, range_min, range_max, ranges }: LaserScan): void {
    const mount = this.#mounts.get(header.frame_id);
    const ms = stampMs(header.stamp);
    if (mount === undefined || ms === undefined) return;
    const points: Point[] = [];
    Array.from(ranges).forEach((range, beam) => {
      if (!(range >= range_min && range < range_max)) return;
      const bearing = angle_min + beam * angle_increment;
      points.push(moved({ x: range * Math.cos(bearing), y: range * Math.sin(bearing) }, mount));
    });
    this.#turn = { ms, points };
  }

  /** In the frame of the map; none where it is not known where the vehicle was then. */
  points(): readonly Point[] {
    const turn = this.#turn;
    if (turn === undefined) return [];
    const away = ({ ms }: { ms: number }): number => Math.abs(ms - turn.ms);
    const [nearest] = [...this.#poses].sort((one, other) => away(one) - away(other));
    if (nearest === undefined || away(nearest) > nearMs) return [];
    return turn.points.map((point) => moved(point, nearest.pose));
  }

  /** What was seen last is not shown any more. */
  forget(): void {
    this.#turn = undefined;
  }
}
