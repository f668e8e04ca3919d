// SPDX-License-Identifier: Apache-2.0

/** Forward [m/s] and to the left [rad/s]. */
export interface Velocity {
  readonly linear: number;
  readonly angular: number;
}

export const standing: Velocity = { linear: 0, angular: 0 };
export const isStanding = (velocity: Velocity): boolean =>
  velocity.linear === 0 && velocity.angular === 0;

const periodMs = 100;
const zeros = 3;

/**
 * What an operator holds becomes commands, as in components/station/console/teleop: at once when it
 * changes, repeated while it is not zero, zero three times at release, then silence. Pure.
 */
export class TeleopSender {
  #held = standing;
  #changed = false;
  #zerosLeft = 0;
  #next = -Infinity;

  hold(velocity: Velocity): void {
    if (velocity.linear === this.#held.linear && velocity.angular === this.#held.angular) return;
    if (isStanding(velocity)) this.#zerosLeft = zeros;
    this.#held = velocity;
    this.#changed = true;
  }

  update(now: number): Velocity | undefined {
    if (!this.#changed && now < this.#next) return undefined;
    if (isStanding(this.#held) && this.#zerosLeft === 0) return undefined;
    if (isStanding(this.#held)) --this.#zerosLeft;
    this.#changed = false;
    this.#next = now + periodMs;
    return this.#held;
  }

  get driving(): boolean {
    return !isStanding(this.#held);
  }
}
