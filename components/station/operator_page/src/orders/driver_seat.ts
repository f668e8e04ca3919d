// SPDX-License-Identifier: Apache-2.0
import { ageText } from "../model/freshness.ts";
import { type Velocity, isStanding, standing } from "./teleop_sender.ts";

/** A picture that is older is none to drive by. */
export const cameraLimitMs = 1000;
/** A vehicle that was not heard for so long is not driven by hand. */
export const vehicleLimitMs = 1500;
/** Who has not driven for so long has let go of the stick. */
const otherLimitMs = 1000;
/** What the former driver sent before may still come. */
const handOverMs = 700;

/** What must be right for driving by hand. Ages [ms]; undefined: never heard. */
export interface DriveConditions {
  readonly connected: boolean;
  readonly vehicleAge: number | undefined;
  readonly cameraAge: number | undefined;
  /** The operator sees the vehicle itself: the camera does not matter. */
  readonly bySight: boolean;
  readonly stopped: boolean;
}

/** Why the vehicle may not be driven by hand; undefined: it may. */
export function whyNotDrive(conditions: DriveConditions): string | undefined {
  const { connected, vehicleAge, cameraAge, bySight, stopped } = conditions;
  if (!connected) return "no connection to the station";
  if (vehicleAge === undefined) return "the vehicle was never heard";
  if (vehicleAge > vehicleLimitMs) return `the vehicle was last heard ${ageText(vehicleAge)} ago`;
  if (stopped) return "an emergency stop stands";
  if (bySight) return undefined;
  if (cameraAge === undefined) return "there is no picture";
  if (cameraAge > cameraLimitMs) return `the picture is ${ageText(cameraAge)} old`;
  return undefined;
}

/**
 * Who drives: one at a time. A seat is taken by a person's act, while nobody else drives, and given
 * up by it, or when another device drives all the same: that has taken over. Between pages the
 * server keeps the same rule. Pure.
 */
export class DriverSeat {
  #takenAt: number | undefined;
  #other: { device: string; at: number } | undefined;
  #mustRest = true;
  /** Who took over from here last; empty: nobody. */
  lostTo = "";

  constructor(readonly device: string) {}

  get taken(): boolean {
    return this.#takenAt !== undefined;
  }

  take(now: number): void {
    if (this.other(now) !== undefined) return;
    this.#takenAt = now;
    this.#mustRest = true;
    this.lostTo = "";
  }

  leave(): void {
    this.#takenAt = undefined;
  }

  /**
   * What the vehicle is told when the hands want `wanted`. After a refusal, as after taking the
   * seat, they must rest before they count, so that nothing drives off by itself.
   */
  heed(wanted: Velocity, refused: boolean): Velocity {
    if (!this.taken || refused) this.#mustRest = true;
    else if (isStanding(wanted)) this.#mustRest = false;
    return this.#mustRest ? standing : wanted;
  }

  /** Whether the hands must rest before they count. */
  get waitsForRest(): boolean {
    return this.#mustRest;
  }

  /** A command of whatever device was heard. */
  onCommand(device: string, moves: boolean, now: number): void {
    if (device === this.device || !moves) return;
    this.#other = { device, at: now };
    if (this.#takenAt === undefined || now - this.#takenAt < handOverMs) return;
    this.leave();
    this.lostTo = device;
  }

  /** Who else drives now. */
  other(now: number): string | undefined {
    const { device, at } = this.#other ?? { device: "", at: -Infinity };
    return now - at < otherLimitMs ? device : undefined;
  }
}
