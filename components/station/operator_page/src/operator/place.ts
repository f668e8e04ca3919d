// SPDX-License-Identifier: Apache-2.0
import { type Point, distance, quaternionOf } from "../model/geometry.ts";
import type { Waypoint } from "../model/messages.ts";
import type { Station } from "../model/station.ts";
import type { Connection } from "../protocol/connection.ts";
import { initialPose } from "../protocol/published.ts";

/** The vehicle's position follows within this time [ms], and comes as near as this [m]. */
const answerMs = 5000;
const nearM = 1;

/** How well a hand places a vehicle: 0.5 m and 15 degrees, as rviz says it [m^2, rad^2]. */
const covariance = Array.from({ length: 36 }, (_, index) => (index === 0 || index === 7 ? 0.25 : index === 35 ? 0.0685 : 0));

/** "The vehicle is here": a place that is pressed on the map and a heading that is dragged, for its localiser. */
export class OperatorPlace {
  /** The next press on the map says where the vehicle is. */
  isArmed = false;
  /** While it is dragged. */
  place: Waypoint | undefined;
  #sent: { readonly place: Waypoint; readonly at: number } | undefined;

  constructor(
    private readonly live: Station,
    private readonly connection: Pick<Connection, "publish">,
    private readonly onFault: (text: string) => void,
  ) {}

  /** Takes the tool, or puts it back. */
  toggle(): void {
    this.isArmed = !this.isArmed;
    this.place = undefined;
  }

  press({ x, y }: Point): void {
    this.place = { x, y, yaw: this.live.location?.value.yaw ?? 0 };
  }

  turn(yaw: number): void {
    if (this.place) this.place = { ...this.place, yaw };
  }

  /** A second pointer moves the map instead. */
  takeBack(): void {
    this.place = undefined;
  }

  /** The pointer is up: what was dragged is sent, the tool is put back. */
  release(now: number): void {
    const { place } = this;
    this.isArmed = false;
    this.place = undefined;
    if (place === undefined) return;
    const pose = { position: { x: place.x, y: place.y, z: 0 }, orientation: quaternionOf(place.yaw) };
    const message = { header: { frame_id: "map" }, pose: { pose, covariance } };
    if (this.connection.publish(initialPose, message)) this.#sent = { place, at: now };
    else this.onFault("the place was not sent: there is no connection");
  }

  tick(now: number): void {
    const sent = this.#sent;
    if (sent === undefined) return;
    const heard = this.live.location;
    const isTaken = heard !== undefined && heard.at > sent.at && distance(heard.value, sent.place) <= nearM;
    if (!isTaken && now - sent.at <= answerMs) return;
    this.#sent = undefined;
    if (!isTaken) this.onFault("the vehicle has not taken the place: it needs a localiser, and a link");
  }
}
