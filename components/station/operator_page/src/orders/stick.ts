// SPDX-License-Identifier: Apache-2.0
// From keys, gamepads and fingers to velocities. Pure.
import { type Velocity, standing } from "./teleop_sender.ts";

/** Top speeds that the operator has chosen. */
export interface Speeds {
  readonly linear: number;
  readonly angular: number;
}

export const speedChoices: readonly Speeds[] = [
  { linear: 0.1, angular: 0.4 },
  { linear: 0.2, angular: 0.7 },
  { linear: 0.3, angular: 1.0 },
  { linear: 0.5, angular: 1.5 },
];

const keys: Readonly<Record<string, readonly [forward: number, left: number]>> = {
  KeyW: [1, 0], ArrowUp: [1, 0],
  KeyS: [-1, 0], ArrowDown: [-1, 0],
  KeyA: [0, 1], ArrowLeft: [0, 1],
  KeyD: [0, -1], ArrowRight: [0, -1],
};

export const isDrivingKey = (code: string): boolean => code in keys;

/** Of the keys that are held down, by their KeyboardEvent.code. Opposite ones cancel out. */
export function keysVelocity(held: ReadonlySet<string>, speeds: Speeds): Velocity {
  let [forward, left] = [0, 0];
  for (const [dx, dy] of [...held].map((code) => keys[code] ?? [0, 0])) {
    forward += dx;
    left += dy;
  }
  return scaled(Math.sign(forward), Math.sign(left), speeds);
}

const deadZone = 0.12;

/** `right` and `up` of a stick in [-1, 1]; a share around its middle counts as none. */
export function stickVelocity(right: number, up: number, speeds: Speeds): Velocity {
  const length = Math.hypot(right, up);
  if (!(length > deadZone)) return standing;
  const stretch = Math.min(1, (length - deadZone) / (1 - deadZone)) / length;
  return scaled(up * stretch, -right * stretch, speeds);
}

/** A gamepad as browsers tell it, as far as it is used. */
export interface Pad {
  readonly connected: boolean;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean }[];
}

/** Any shoulder button is the dead-man button, the left stick drives. Undefined: it is not held. */
export function padVelocity(pad: Pad, speeds: Speeds): Velocity | undefined {
  const isHeld = [4, 5, 6, 7].some((index) => pad.buttons[index]?.pressed);
  if (!pad.connected || !isHeld) return undefined;
  return stickVelocity(pad.axes[0] ?? 0, -(pad.axes[1] ?? 0), speeds);
}

function scaled(forward: number, left: number, speeds: Speeds): Velocity {
  return { linear: forward * speeds.linear || 0, angular: left * speeds.angular || 0 };
}
