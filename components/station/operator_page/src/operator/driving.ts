// SPDX-License-Identifier: Apache-2.0
import type { Point } from "../model/geometry.ts";
import type { Stamp } from "../model/messages.ts";
import type { Station } from "../model/station.ts";
import { ControlAuthority, type DriveConditions, whyNotDrive } from "../orders/control_authority.ts";
import { type Speeds, keysVelocity, padVelocity, speedChoices, stickVelocity } from "../orders/stick.ts";
import { TeleopSender, type Velocity } from "../orders/teleop_sender.ts";
import type { Connection, UserRole } from "../protocol/connection.ts";
import { driverRequest, teleopVelocity } from "../protocol/published.ts";

const stampNow = (): Stamp => {
  const ms = Date.now();
  return { sec: Math.floor(ms / 1000), nanosec: (ms % 1000) * 1_000_000 };
};

/** Driving by hand: what keys, finger and gamepad want, whether it counts, and its commands. */
export class ManualDriving {
  readonly authority: ControlAuthority;
  /** The operator sees the vehicle itself. */
  bySight = false;
  speeds: Speeds = speedChoices[1] ?? { linear: 0.2, angular: 0.7 };
  /** Keys that are held while control is taken, and the finger on the touch stick. */
  readonly heldKeys = new Set<string>();
  touch: Point | undefined;
  #sender = new TeleopSender();

  /** `isReplaying`: a recording is on the screen. */
  constructor(
    name: string,
    private readonly live: Station,
    private readonly connection: Connection,
    private readonly isReplaying: () => boolean,
    private readonly role: () => UserRole,
  ) {
    this.authority = new ControlAuthority(name);
  }

  conditions(now: number): DriveConditions {
    const { live } = this;
    const age = (at: number | undefined): number | undefined => (at === undefined ? at : now - at);
    return {
      connected: this.connection.state.phase === "open",
      vehicleAge: age(live.vehicleHeard),
      cameraAge: age(live.image?.at),
      bySight: this.bySight,
      paused: live.uxv.transmission?.value.active === false,
      replaying: this.isReplaying(),
      role: this.role(),
      stopped: live.safety?.value.emergency_stop ?? false,
    };
  }

  tick(now: number): void {
    const { authority, connection } = this;
    const verb = authority.takeRequest();
    if (verb) connection.publish(driverRequest, { stamp: stampNow(), name: authority.name, verb });
    const refused = whyNotDrive(this.conditions(now)) !== undefined;
    this.#sender.hold(authority.command(this.#wanted(), refused));
    const velocity = this.#sender.update(now);
    if (velocity === undefined) return;
    connection.publish(teleopVelocity, {
      header: { stamp: stampNow(), frame_id: authority.name },
      twist: {
        linear: { x: velocity.linear, y: 0, z: 0 },
        angular: { x: 0, y: 0, z: velocity.angular },
      },
    });
  }

  letGo(): void {
    this.heldKeys.clear();
    this.touch = undefined;
  }

  /** What the hands want now. */
  #wanted(): Velocity {
    for (const pad of navigator.getGamepads?.() ?? []) {
      const velocity = pad ? padVelocity(pad, this.speeds) : undefined;
      if (velocity !== undefined) return velocity;
    }
    if (this.touch !== undefined) return stickVelocity(this.touch.x, this.touch.y, this.speeds);
    return keysVelocity(this.heldKeys, this.speeds);
  }
}
