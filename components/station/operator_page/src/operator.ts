// SPDX-License-Identifier: Apache-2.0
// The thin shell around the model and the orders: what comes in goes to them, what is due goes out.
import type { IWebSocket } from "@foxglove/ws-protocol";

import { isFree } from "./map/grid.ts";
import type { Point } from "./model/geometry.ts";
import { type Row, type Tables, historyOf, rowsOf } from "./model/history.ts";
import { type OccupancyGrid, type Stamp, type Topic, type Topics, isTopicRead, topicsRead } from "./model/messages.ts";
import { type MissionDraft, draftOf } from "./model/mission_draft.ts";
import { Station } from "./model/station.ts";
import { type DriveConditions, DriverSeat, whyNotDrive } from "./orders/driver_seat.ts";
import { EmergencyStopOrder, type StopHeard } from "./orders/emergency_stop.ts";
import { MissionOrder } from "./orders/mission_order.ts";
import { RecordOrder, recorderNode, recordingParameter } from "./orders/record_order.ts";
import { MissionRequest } from "./orders/mission_request.ts";
import { type Speeds, keysVelocity, padVelocity, speedChoices, stickVelocity } from "./orders/stick.ts";
import { TeleopSender, type Velocity } from "./orders/teleop_sender.ts";
import { WhatIfQuery } from "./orders/what_if_query.ts";
import { BagFile } from "./replay/bag_file.ts";
import { BagList } from "./replay/bag_list.ts";
import { BagPlayer } from "./replay/bag_player.ts";
import type { BagSource } from "./replay/bag_source.ts";
import { Connection, type ServerInfo } from "./protocol/connection.ts";
import { type StationBag, StationFiles } from "./protocol/station_files.ts";
import { driverRequest, emergencyStopRequest, missionCommand, teleopVelocity } from "./protocol/published.ts";

const drawId = (): Uint8Array => crypto.getRandomValues(new Uint8Array(16));
const random64 = (): bigint => crypto.getRandomValues(new BigUint64Array(1))[0] ?? 1n;
const stampNow = (): Stamp => {
  const ms = Date.now();
  return { sec: Math.floor(ms / 1000), nanosec: (ms % 1000) * 1_000_000 };
};

/** The time of the page [ms]: never goes back. */
export const pageNow = (): number => performance.timeOrigin + performance.now();

export class Operator {
  /** The vehicle and the link as they are now. */
  readonly live = new Station();
  /** A bag that is shown in their place. */
  player: BagPlayer | undefined;
  readonly connection: Connection;
  readonly stop = new EmergencyStopOrder();
  readonly missionRequest = new MissionRequest((service, request) => this.connection.call(service, request), drawId);
  readonly missionOrder = new MissionOrder();
  readonly record = new RecordOrder();
  readonly bags: BagList;
  readonly whatIf: WhatIfQuery;
  readonly seat = new DriverSeat(`page_${random64().toString(36).slice(0, 4)}`);
  server: ServerInfo | undefined;
  /** Messages that came; whoever draws compares it. */
  version = 0;
  /** A mission that is edited on the map; undefined: none. */
  draft: MissionDraft | undefined;
  /** The draft that mission_control has refused as it is. */
  refused: MissionDraft | undefined;
  bySight = false;
  speeds: Speeds = speedChoices[1] ?? { linear: 0.2, angular: 0.7 };
  /** Keys that are held while the seat is taken, and the finger on the touch stick. */
  readonly heldKeys = new Set<string>();
  touch: Point | undefined;
  hands: "keys" | "touch" | "gamepad" = "keys";
  #sender = new TeleopSender();
  #files: StationFiles;
  /** Process of the recorder that is watched. */
  #recorder: number | undefined;

  /** `url`: of the socket; `page`: of the page. Both with the token. */
  constructor(url: string, page: string) {
    this.#files = new StationFiles(page);
    this.bags = new BagList(() => this.#files.bags());
    this.whatIf = new WhatIfQuery((query) => this.#files.whatIf(query), (host) => {
      const last = this.live.side(host).decisions.decisions.at(-1);
      return last?.made === undefined ? undefined : last.at - last.made;
    });
    this.connection = new Connection({
      url,
      topics: topicsRead,
      onMessage: (topic, message) => this.#onMessage(topic, message),
      onServer: (server) => {
        if (this.server === undefined) void this.#readHistory();
        this.server = server;
      },
      onParameter: (name, value) => {
        if (name === recordingParameter) this.record.onValue(value);
      },
      onTrouble: (text) => this.#say("warning", "server", text),
      now: pageNow,
      openSocket: (address, subprotocols) => new WebSocket(address, subprotocols) as unknown as IWebSocket,
    });
  }

  /** What is shown: the bag, or what is. */
  get station(): Station {
    return this.player?.station ?? this.live;
  }

  /** The floor; of a bag without one it is the one that is known now. */
  get map(): OccupancyGrid | undefined {
    return this.station.map ?? this.live.map;
  }

  /** The time of what is shown. */
  now(): number {
    return this.player?.position ?? pageNow();
  }

  /** Shows a bag in place of what is; the emergency stop stays what it is. */
  async openBag(source: BagSource): Promise<void> {
    try {
      this.player = new BagPlayer(await BagFile.open(source), source.name);
      this.draft = undefined;
      this.bags.show(false);
    } catch (error) {
      this.#say("error", "recording", `${source.name} cannot be shown: ${String(error)}`);
    }
  }

  openStationBag(bag: StationBag): Promise<void> {
    return this.openBag(this.#files.source(bag));
  }

  closeBag(): void {
    if (this.player?.trouble) this.#say("error", "recording", this.player.trouble);
    this.player = undefined;
  }

  /** To be called 20 times a second. */
  tick(now: number): void {
    if (this.player) {
      this.player.tick(now);
      ++this.version;
    }
    this.connection.tick();
    this.#tickStop(now);
    this.#tickMission(now);
    this.#tickDriving(now);
    this.#tickRecording(now);
    this.bags.tick(now);
    if (this.player === undefined) this.whatIf.tick(now);
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

  driveConditions(now: number): DriveConditions {
    const { live } = this;
    const age = (at: number | undefined): number | undefined => (at === undefined ? at : now - at);
    return {
      connected: this.connection.state.phase === "open",
      vehicleAge: age(live.vehicleHeard),
      cameraAge: age(live.image?.at),
      bySight: this.bySight,
      paused: live.uxv.transmission?.value.active === false,
      replaying: this.player !== undefined,
      stopped: live.safety?.value.emergency_stop ?? false,
    };
  }

  /** Hands them to mission_control as one mission; a draft that is refused stays, to be mended. */
  async sendDraft(): Promise<void> {
    const { draft } = this;
    if (draft === undefined || this.whyNotSend() !== undefined) return;
    const accepted = await this.missionRequest.send(draft.places);
    if (accepted && this.draft === draft) this.draft = undefined;
    this.refused = accepted ? undefined : draft;
    this.#onAnswer("the mission");
  }

  /** Why the draft cannot be sent as it is; undefined: it can. */
  whyNotSend(): string | undefined {
    const { map } = this;
    const places = this.draft?.places ?? [];
    const blocked = places.findIndex((place) => map !== undefined && !isFree(map, place));
    if (this.player) return "A recording is shown.";
    if (this.seat.other !== "") return `${this.seat.other} drives by hand: ask for the wheel before.`;
    if (blocked >= 0) return `Place ${blocked + 1} is in a wall or beyond the map.`;
    if (places.length === 0) return "Press on the map, drag for the heading.";
    return this.missionRequest.isPending ? "Sent, no answer yet." : undefined;
  }

  /** Begins a draft with what is left of the present mission. */
  editMission(): void {
    this.draft = draftOf(this.live.route.points().filter(({ state }) => state !== "passed"));
  }

  async cancelMission(): Promise<void> {
    await this.missionRequest.cancel();
    this.#onAnswer("its end");
  }

  #onAnswer(what: string): void {
    ++this.version;
    const { phase } = this.missionRequest;
    if (phase.kind === "failed") this.#say("error", "mission", `${what} is refused: ${phase.reason}`);
  }

  /** mission_control holds the vehicle where it is. */
  pauseMission(now: number): void {
    this.missionOrder.pause(now);
  }

  /** The mission goes on with the waypoint where it was paused. */
  resumeMission(now: number): void {
    this.missionOrder.resume(now);
  }

  skipWaypoint(now: number): void {
    const mission = this.live.mission?.value;
    if (mission !== undefined) this.missionOrder.skip(mission.waypoint, now);
  }

  /** What the hands want now. */
  #handsWant(): Velocity {
    const pads = navigator.getGamepads?.() ?? [];
    for (const pad of pads) {
      const velocity = pad ? padVelocity(pad, this.speeds) : undefined;
      if (velocity === undefined) continue;
      this.hands = "gamepad";
      return velocity;
    }
    this.hands = this.touch === undefined ? "keys" : "touch";
    if (this.touch !== undefined) return stickVelocity(this.touch.x, this.touch.y, this.speeds);
    return keysVelocity(this.heldKeys, this.speeds);
  }

  #tickStop(now: number): void {
    const wanted = this.stop.due(this.stopHeard(), now);
    if (wanted === undefined) return;
    if (!this.connection.publish(emergencyStopRequest, { data: wanted })) this.stop.notSent();
  }

  #tickMission(now: number): void {
    const words = this.missionOrder.due(this.live.mission?.value, now);
    if (words !== undefined) this.connection.publish(missionCommand, { data: words });
    if (this.missionOrder.unheeded) this.#notHeeded();
  }

  #tickDriving(now: number): void {
    const verb = this.seat.takeRequest();
    if (verb) this.connection.publish(driverRequest, { stamp: stampNow(), name: this.seat.name, verb });
    const refused = whyNotDrive(this.driveConditions(now)) !== undefined;
    this.#sender.hold(this.seat.heed(this.#handsWant(), refused));
    const velocity = this.#sender.update(now);
    if (velocity === undefined) return;
    this.connection.publish(teleopVelocity, {
      header: { stamp: stampNow(), frame_id: this.seat.name },
      twist: {
        linear: { x: velocity.linear, y: 0, z: 0 },
        angular: { x: 0, y: 0, z: velocity.angular },
      },
    });
  }

  #tickRecording(now: number): void {
    if (this.connection.state.phase !== "open") {
      this.#recorder = undefined;
      this.record.forget();
    }
    const wanted = this.record.due(now);
    if (wanted !== undefined && !this.connection.setParameter(recordingParameter, wanted)) this.record.notSent();
    if (!this.record.unheeded) return;
    this.record.unheeded = false;
    this.#say("error", "recording", "the station's recorder has not done what was asked");
  }

  /** Hears what the recorder does as soon as there is one, and anew when it was restarted. */
  #watchRecorder({ components, pid }: Topics["container_state"]): void {
    if (pid === this.#recorder || !components.some(({ name }) => name === recorderNode)) return;
    this.#recorder = pid;
    this.record.forget();
    this.connection.watchParameters([recordingParameter]);
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
    if (topic === "container_state") this.#watchRecorder(message as Topics["container_state"]);
    if (topic === "teleop/driver") {
      const { driver, asked_by } = message as Topics["teleop/driver"];
      this.seat.onWheel({ driver, askedBy: asked_by });
    }
  }

  #notHeeded(): void {
    this.missionOrder.unheeded = false;
    this.#say("error", "mission", "mission_control has not done what was asked");
  }

  #say(severity: "info" | "warning" | "error", source: string, text: string): void {
    this.live.journal.add({ at: pageNow(), severity, source, text });
  }
}
