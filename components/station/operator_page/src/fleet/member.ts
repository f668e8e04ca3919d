// SPDX-License-Identifier: Apache-2.0
// One vehicle of a fleet, as its own server tells of it.
import type { IWebSocket } from "@foxglove/ws-protocol";

import { type AlertKind, type Alert, alertKinds, findingOf } from "../model/alerts.ts";
import { type Topic, type Topics, isTopicRead } from "../model/messages.ts";
import { Station } from "../model/station.ts";
import { EmergencyStopOrder, type StopHeard } from "../orders/emergency_stop.ts";
import { Connection } from "../protocol/connection.ts";
import { emergencyStopRequest } from "../protocol/published.ts";
import { type Address, socketOf } from "./addresses.ts";

/** What a list and a map of vehicles show; no pictures. */
const topics: ReadonlySet<Topic> = new Set<Topic>([
  "location", "network_quality", "transmission_state", "heartbeat", "navigation_status", "mission_status", "mission/path", "goal",
  "battery_state", "link_state", "traffic_report", "safety_status", "emergency_stop/state", "docking/status", "teleop/driver",
  "container_state", "diagnostics", "map", "airtime_use", "link_site",
]);

export type Finding = Alert & { readonly kind: AlertKind };

export class Member {
  readonly station = new Station();
  readonly stop = new EmergencyStopOrder();
  readonly connection: Connection;
  readonly name: string;
  mayRelease = true;
  /** Messages that were received. */
  version = 0;

  /** `page`: with the token. */
  constructor({ name, page }: Address, private readonly now: () => number) {
    this.name = name;
    this.connection = new Connection({
      url: socketOf(page),
      topics,
      onMessage: (topic, message) => this.#onMessage(topic, message),
      onServer: ({ role }) => (this.mayRelease = role !== "observer"),
      onParameter: () => undefined,
      onTrouble: () => undefined,
      now,
      openSocket: (address, subprotocols) => new WebSocket(address, subprotocols) as unknown as IWebSocket,
    });
  }

  stopHeard(): StopHeard {
    const { stop, safety, vehicleHeard } = this.station;
    return { station: stop?.value, safety, vehicleHeard, connected: this.connection.state.phase === "open" };
  }

  /** To be called 20 times a second. */
  tick(): void {
    this.connection.tick();
    const wanted = this.stop.due(this.stopHeard(), this.now());
    if (wanted === undefined) return;
    if (!this.connection.publish(emergencyStopRequest, { data: wanted })) this.stop.notSent();
  }

  finding(): Finding {
    return findingOf(this.connection.state, this.station, this.now());
  }

  #onMessage(topic: string, message: unknown): void {
    if (!isTopicRead(topic)) return;
    this.station.onMessage(topic, message as Topics[Topic], this.now());
    ++this.version;
  }
}

const severities = ["error", "warning", "info", "well"] as const;

/** Who needs a person comes first: by severity, by what it is, then by name. */
export function byUrgency(one: { name: string; finding: Finding }, other: { name: string; finding: Finding }): number {
  const rank = ({ severity, kind }: Finding): number => severities.indexOf(severity) * alertKinds.length + alertKinds.indexOf(kind);
  return rank(one.finding) - rank(other.finding) || one.name.localeCompare(other.name, "en", { numeric: true });
}
