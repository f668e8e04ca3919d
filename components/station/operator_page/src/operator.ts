// SPDX-License-Identifier: Apache-2.0
// The thin shell around the model and the orders: messages go to them, what is due is published.
import type { IWebSocket } from "@foxglove/ws-protocol";

import type { Point } from "./model/geometry.ts";
import { type Row, type Tables, historyOf, rowsOf } from "./model/history.ts";
import { type OccupancyGrid, type Topic, type Topics, isTopicRead, scanTopics, topicsRead } from "./model/messages.ts";
import { Station } from "./model/station.ts";
import { ManualDriving } from "./operator/driving.ts";
import { OperatorMission } from "./operator/mission.ts";
import { OperatorPlace } from "./operator/place.ts";
import { Recordings } from "./operator/recordings.ts";
import { EmergencyStopOrder, type StopHeard } from "./orders/emergency_stop.ts";
import { WhatIfQuery } from "./orders/what_if_query.ts";
import { pageNow } from "./page_now.ts";
import { Connection, type ServerInfo, type UserRole } from "./protocol/connection.ts";
import { emergencyStopRequest } from "./protocol/published.ts";
import { StationFiles } from "./protocol/station_files.ts";
import type { BagSource } from "./replay/bag_source.ts";

const random64 = (): bigint => crypto.getRandomValues(new BigUint64Array(1))[0] ?? 1n;

export class Operator {
  /** The vehicle and the link as they are now. */
  readonly live = new Station();
  readonly connection: Connection;
  readonly stop = new EmergencyStopOrder();
  readonly driving: ManualDriving;
  readonly mission: OperatorMission;
  readonly place: OperatorPlace;
  readonly recordings: Recordings;
  readonly whatIf: WhatIfQuery;
  server: ServerInfo | undefined;
  /** Messages that were received; whoever draws compares it. */
  version = 0;
  #files: StationFiles;

  /** `url`: of the socket; `page`: of the page. Both with the token. */
  constructor(url: string, page: string) {
    this.#files = new StationFiles(page);
    this.connection = this.#connectionTo(url);
    for (const topic of scanTopics) this.connection.want(topic, false);
    const isReplaying = (): boolean => this.recordings.player !== undefined;
    const name = new URL(page).searchParams.get("name") ?? `page_${random64().toString(36).slice(0, 4)}`;
    this.driving = new ManualDriving(name, this.live, this.connection, isReplaying, () => this.role);
    this.recordings = new Recordings(this.#files, this.connection, (text) => this.#say("error", "recording", text));
    this.mission = new OperatorMission(this.live, this.connection, {
      map: () => this.map,
      isReplaying,
      role: () => this.role,
      otherDriver: () => this.driving.authority.other,
      onFault: (text) => this.#say("error", "mission", text),
      onChange: () => ++this.version,
    });
    this.place = new OperatorPlace(this.live, this.connection, (text) => this.#say("error", "position", text));
    this.whatIf = new WhatIfQuery((query) => this.#files.whatIf(query), (host) => {
      const last = this.live.side(host).decisions.decisions.at(-1);
      return last?.made === undefined ? undefined : last.at - last.made;
    });
  }

  /** What the station lets this page do. */
  get role(): UserRole {
    return this.server?.role ?? "operator";
  }

  /** Whether this page may act on the vehicle, which it shows. */
  get mayAct(): boolean {
    return this.recordings.player === undefined && this.mayRelease;
  }

  /** Whether it may release the emergency stop. */
  get mayRelease(): boolean {
    return this.role !== "observer";
  }

  /** What is shown: the bag, or what is. */
  get station(): Station {
    return this.recordings.player?.station ?? this.live;
  }

  /** The floor; of a bag without one it is the one that is known now. */
  get map(): OccupancyGrid | undefined {
    return this.station.map ?? this.live.map;
  }

  /** The time of what is shown. */
  now(): number {
    return this.recordings.player?.position ?? pageNow();
  }

  async openBag(source: BagSource): Promise<void> {
    if (await this.recordings.open(source)) this.mission.draft = undefined;
  }

  /** To be called 20 times a second. */
  tick(now: number): void {
    if (this.recordings.player) ++this.version;
    this.connection.tick();
    this.#tickStop(now);
    this.mission.tick(now);
    this.place.tick(now);
    this.driving.tick(now);
    this.recordings.tick(now);
    if (this.recordings.player === undefined) this.whatIf.tick(now);
  }

  /** The place of the access point on the map; undefined: the station does not know it. */
  get accessPoint(): Point | undefined {
    const [x, y] = (this.server?.metadata.access_point ?? "").split(" ").map(Number);
    return x !== undefined && y !== undefined && Number.isFinite(x + y) ? { x, y } : undefined;
  }

  stopHeard(): StopHeard {
    const { live } = this;
    return {
      station: live.stop?.value,
      safety: live.safety,
      vehicleHeard: live.vehicleHeard,
      connected: this.connection.state.phase === "open",
    };
  }

  #connectionTo(url: string): Connection {
    return new Connection({
      url,
      topics: topicsRead,
      onMessage: (topic, message) => this.#onMessage(topic, message),
      onServer: (server) => {
        if (this.server === undefined) void this.#readHistory();
        this.server = server;
      },
      onParameter: (name, value) => this.recordings.onParameter(name, value),
      onTrouble: (text) => this.#say("warning", "server", text),
      now: pageNow,
      openSocket: (address, subprotocols) => new WebSocket(address, subprotocols) as unknown as IWebSocket,
    });
  }

  #tickStop(now: number): void {
    const wanted = this.stop.due(this.stopHeard(), now);
    if (wanted === undefined) return;
    if (!this.connection.publish(emergencyStopRequest, { data: wanted })) this.stop.notSent();
  }

  /** The trail of before; a station without a recorder that writes tables has none. */
  async #readHistory(): Promise<void> {
    const rows = async (name: keyof Tables): Promise<Row[]> => rowsOf(await this.#files.table(name).catch(() => ""));
    const [location, transmission_state] = await Promise.all([rows("location"), rows("transmission_state")]);
    this.live.onHistory(historyOf({ location, transmission_state }));
    ++this.version;
  }

  #onMessage(topic: string, message: unknown): void {
    if (!isTopicRead(topic)) return;
    this.live.onMessage(topic, message as Topics[Topic], pageNow());
    ++this.version;
    if (topic === "container_state") this.recordings.onContainer(message as Topics["container_state"]);
    if (topic === "teleop/driver") {
      const { driver, asked_by } = message as Topics["teleop/driver"];
      this.driving.authority.onReport({ driver, askedBy: asked_by });
    }
  }

  #say(severity: "warning" | "error", source: string, text: string): void {
    this.live.journal.add({ at: pageNow(), severity, source, text });
  }
}
