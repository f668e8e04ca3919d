// SPDX-License-Identifier: Apache-2.0
import { type Heard, ageText, vehicleLostAfterMs } from "../model/freshness.ts";
import type { EmergencyStopState, SafetyStatus } from "../model/messages.ts";

/** What the station and the vehicle say of the stop. */
export interface StopHeard {
  readonly station: EmergencyStopState | undefined;
  readonly safety: Heard<SafetyStatus> | undefined;
  /** When anything of the vehicle was last heard. */
  readonly vehicleHeard: number | undefined;
  readonly connected: boolean;
}

/** How the stop stands, for the eye and for words. */
export interface StopShown {
  readonly kind: "clear" | "asking" | "stands" | "releasing" | "unheard";
  readonly text: string;
}

const repeatMs = 300;
const releaseLimitMs = 5000;

/**
 * What a person wants of the emergency stop: said at once, and again until the vehicle itself has
 * confirmed it. A stop is wanted until then, whatever it takes; a release that is not confirmed
 * within 5 s lapses, so that no vehicle drives off later. Pure.
 */
export class EmergencyStopOrder {
  #wish: "stop" | "release" | undefined;
  #since = 0;
  #next = 0;

  press(now: number): void {
    this.#begin("stop", now);
  }

  release(now: number): void {
    this.#begin("release", now);
  }

  /** What to say on emergency_stop/request now, if anything. */
  due(heard: StopHeard, now: number): boolean | undefined {
    if (this.#wish === undefined) return undefined;
    const confirmed = stands(heard) === (this.#wish === "stop") && now > this.#since;
    const lapsed = this.#wish === "release" && now - this.#since > releaseLimitMs;
    if ((confirmed && isAnswered(heard, this.#wish)) || lapsed) {
      this.#wish = undefined;
      return undefined;
    }
    if (now < this.#next) return undefined;
    this.#next = now + repeatMs;
    return this.#wish === "stop";
  }

  /** It could not be sent: it is due again. */
  notSent(): void {
    this.#next = 0;
  }

  shown(heard: StopHeard, now: number): StopShown {
    const waits = ageText(now - this.#since);
    if (this.#wish === "stop" && !stands(heard)) return { kind: "asking", text: unconfirmed(heard, waits) };
    if (this.#wish === "release") return { kind: "releasing", text: `Release asked ${waits} ago` };
    const age = heard.vehicleHeard === undefined ? Infinity : now - heard.vehicleHeard;
    if (stands(heard)) {
      const by = (heard.safety?.value.stopped_by ?? heard.station?.stopped_by ?? []).join(", ");
      const when = age > vehicleLostAfterMs ? `, as it said ${ageText(age)} ago` : "";
      return { kind: "stands", text: `Vehicle confirms: stopped${by ? ` by ${by}` : ""}${when}` };
    }
    if (age > vehicleLostAfterMs) {
      return { kind: "unheard", text: "Vehicle not heard: a stop reaches it when the link is back" };
    }
    return { kind: "clear", text: "No stop stands" };
  }

  #begin(wish: "stop" | "release", now: number): void {
    this.#wish = wish;
    this.#since = now;
    this.#next = now;
  }
}

/** Whether the vehicle says that a stop stands. */
function stands(heard: StopHeard): boolean {
  return heard.safety?.value.emergency_stop ?? heard.station?.vehicle === "stands";
}

/** The station has taken the order, or is not there to take it: then the vehicle's word will do. */
function isAnswered(heard: StopHeard, wish: "stop" | "release"): boolean {
  return heard.station === undefined || heard.station.asked === (wish === "stop" ? "on" : "off");
}

function unconfirmed(heard: StopHeard, waits: string): string {
  if (!heard.connected) return `NOT SENT for ${waits}: no connection to the station`;
  if (heard.station?.asked !== "on") return `STOP asked ${waits} ago: the station has not answered`;
  return `STOP asked ${waits} ago: the vehicle has not confirmed`;
}
