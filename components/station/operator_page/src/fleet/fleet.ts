// SPDX-License-Identifier: Apache-2.0
// All vehicles of a site in one page: a connection to the server of each.
import type { IWebSocket } from "@foxglove/ws-protocol";

import type { OccupancyGrid } from "../model/messages.ts";
import { Connection, type ServerInfo } from "../protocol/connection.ts";
import { type Address, addressesOf, withToken } from "./addresses.ts";
import { Alarms } from "./alarms.ts";
import { type Finding, Member, byUrgency } from "./member.ts";

export interface Row {
  readonly name: string;
  readonly member: Member;
  readonly finding: Finding;
  /** Of its own page. */
  readonly page: string;
  /** 0: needs a person before all others. */
  readonly rank: number;
}

export class Fleet {
  readonly alarms = new Alarms();
  members: readonly { readonly address: Address; readonly member: Member }[] = [];
  #connection: Connection;

  /** `here`: the address of this page, which one of the vehicles' servers serves. */
  constructor(
    private readonly here: string,
    socket: string,
    private readonly now: () => number,
  ) {
    this.#connection = new Connection({
      url: socket,
      topics: new Set(),
      onMessage: () => undefined,
      onServer: (server) => this.#onServer(server),
      onParameter: () => undefined,
      onTrouble: () => undefined,
      now,
      openSocket: (address, subprotocols) => new WebSocket(address, subprotocols) as unknown as IWebSocket,
    });
  }

  /** Whether the vehicles' addresses are known. */
  get isKnown(): boolean {
    return this.members.length > 0;
  }

  /** The floor, of whichever vehicle has one. */
  get map(): OccupancyGrid | undefined {
    return this.members.find(({ member }) => member.station.map !== undefined)?.member.station.map;
  }

  get version(): number {
    return this.members.reduce((sum, { member }) => sum + member.version, 0);
  }

  /** To be called 20 times a second. */
  tick(): void {
    this.#connection.tick();
    for (const { member } of this.members) member.tick();
  }

  /** Everyone's worst, in an order that stays; alarms follow it. */
  rows(): Row[] {
    const rows = this.members.map(({ address, member }) => ({ name: member.name, member, finding: member.finding(), page: address.page }));
    for (const { name, finding } of rows) this.alarms.onFinding(name, finding, this.now());
    const urgent = [...rows].sort(byUrgency);
    return rows.map((row) => ({ ...row, rank: urgent.indexOf(row) }));
  }

  stopAll(): void {
    for (const { member } of this.members) member.stop.press(this.now());
  }

  #onServer({ metadata }: ServerInfo): void {
    if (this.isKnown) return;
    const told = addressesOf(metadata.fleet ?? "");
    const own = { name: metadata.vehicle ?? metadata.host ?? "vehicle", page: new URL("/", this.here).href };
    this.members = (told.length > 0 ? told : [own]).map(({ name, page }) => {
      const address = { name, page: withToken(page, this.here) };
      return { address, member: new Member(address, this.now) };
    });
  }
}
