// SPDX-License-Identifier: Apache-2.0
import { ageText } from "../model/freshness.ts";
import type { UserRole } from "../protocol/connection.ts";
import { type Velocity, isStanding, standing } from "./teleop_sender.ts";

/** A picture that is older is none to drive by. */
export const cameraLimitMs = 1000;
/** A vehicle that was not heard for so long is not driven by hand. */
export const vehicleLimitMs = 1500;
/** What must be right for driving by hand. Ages [ms]; undefined: never heard. */
export interface DriveConditions {
  readonly connected: boolean;
  readonly vehicleAge: number | undefined;
  readonly cameraAge: number | undefined;
  /** The operator sees the vehicle itself: the camera does not matter. */
  readonly bySight: boolean;
  /** The gate keeps the camera from the link. */
  readonly paused: boolean;
  readonly stopped: boolean;
  /** A recording is on the screen, not the vehicle. */
  readonly replaying: boolean;
  /** What the station lets this page do. */
  readonly role: UserRole;
}

/** Why the vehicle may not be driven by hand; undefined: it may. */
export function whyNotDrive(conditions: DriveConditions): string | undefined {
  const { connected, vehicleAge, cameraAge, bySight, paused, stopped, replaying, role } = conditions;
  if (role === "observer") return "you are an observer";
  if (replaying) return "a recording is shown";
  if (!connected) return "no connection to the station";
  if (vehicleAge === undefined) return "the vehicle was never heard";
  if (vehicleAge > vehicleLimitMs) return `the vehicle was last heard ${ageText(vehicleAge)} ago`;
  if (stopped) return "an emergency stop stands";
  if (bySight) return undefined;
  if (cameraAge !== undefined && cameraAge <= cameraLimitMs) return undefined;
  if (paused) return "the camera is paused by the gate";
  return cameraAge === undefined ? "there is no picture" : `the picture is ${ageText(cameraAge)} old`;
}

export type ControlVerb = "ask" | "give" | "keep" | "take";

/** Who drives by hand, as the vehicle reports (teleop/driver). */
export interface DriverReport {
  /** Whom the vehicle follows; empty: nobody, the next to drive is. */
  readonly driver: string;
  /** Who waits for control; empty: nobody. */
  readonly askedBy: string;
}

/**
 * The operator's part of control authority: the vehicle follows one, and reports whom. Control is
 * taken by a person's act: at once while nobody drives, else by asking who does, whose it stays
 * until the vehicle says otherwise. It is lost when the vehicle follows another. Pure.
 */
export class ControlAuthority {
  #taken = false;
  #asks = false;
  #mustRest = true;
  #requests: ControlVerb[] = [];
  #reported: DriverReport = { driver: "", askedBy: "" };
  /** Who drives in our place since; empty: nobody. */
  lostTo = "";

  constructor(readonly name: string) {}

  get taken(): boolean {
    return this.#taken;
  }

  /** Whether control was asked for, and is still another's. */
  get asks(): boolean {
    return this.#asks;
  }

  /** Who else drives; empty: nobody. */
  get other(): string {
    return this.#isOurs ? "" : this.#reported.driver;
  }

  /** Who else asks us for control; empty: nobody. */
  get askedBy(): string {
    return this.#taken && this.#isOurs ? this.#reported.askedBy : "";
  }

  take(): void {
    this.lostTo = "";
    if (this.other === "") return this.#begin();
    this.#asks = true;
    this.#requests.push("ask");
  }

  /** At once, whoever drives: for a supervisor. */
  takeOver(): void {
    this.lostTo = "";
    this.#asks = true;
    this.#requests.push("take");
  }

  release(): void {
    if (this.#isOurs) this.#requests.push("give");
    this.#taken = false;
    this.#asks = false;
  }

  toggle(): void {
    if (this.#taken) this.release();
    else this.take();
  }

  keep(): void {
    this.#requests.push("keep");
  }

  onReport(report: DriverReport): void {
    this.#reported = report;
    if (this.#isOurs && this.#asks) this.#begin();
    if (this.other === "") {
      this.lostTo = "";
      if (this.#asks) this.#begin(); // it has become free
    } else if (this.#taken) {
      this.#taken = false;
      this.lostTo = this.other;
    }
  }

  /** The request to send now, if any. */
  takeRequest(): ControlVerb | undefined {
    return this.#requests.shift();
  }

  /**
   * The command when the hands want `wanted`. After a refusal, as after taking control, they must
   * rest before they count, so that nothing drives off by itself.
   */
  command(wanted: Velocity, refused: boolean): Velocity {
    if (!this.taken || refused) this.#mustRest = true;
    else if (isStanding(wanted)) this.#mustRest = false;
    return this.#mustRest ? standing : wanted;
  }

  /** Whether the hands must rest before they count. */
  get waitsForRest(): boolean {
    return this.#mustRest;
  }

  get #isOurs(): boolean {
    return this.#reported.driver === this.name;
  }

  #begin(): void {
    this.#taken = true;
    this.#asks = false;
    this.#mustRest = true;
  }
}
