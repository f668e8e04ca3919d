// SPDX-License-Identifier: Apache-2.0
import type { ContainerState } from "../model/messages.ts";
import { RecordOrder, recorderNode, recordingParameter } from "../orders/record_order.ts";
import type { Connection } from "../protocol/connection.ts";
import type { StationBag, StationFiles } from "../protocol/station_files.ts";
import { BagFile } from "../replay/bag_file.ts";
import { BagList } from "../replay/bag_list.ts";
import { BagPlayer } from "../replay/bag_player.ts";
import type { BagSource } from "../replay/bag_source.ts";

/** What the station records, its recordings, and the one that is shown. */
export class Recordings {
  readonly order = new RecordOrder();
  readonly list: BagList;
  /** A bag that is shown in place of the vehicle. */
  player: BagPlayer | undefined;
  /** Process of the recorder that is watched. */
  #recorder: number | undefined;

  constructor(
    private readonly files: StationFiles,
    private readonly connection: Connection,
    private readonly onFault: (text: string) => void,
  ) {
    this.list = new BagList(() => files.bags());
  }

  /** Shows a bag in place of what is; the emergency stop stays what it is. True: it is shown. */
  async open(source: BagSource): Promise<boolean> {
    try {
      this.player = new BagPlayer(await BagFile.open(source), source.name);
      this.list.show(false);
      return true;
    } catch (error) {
      this.onFault(`${source.name} cannot be shown: ${String(error)}`);
      return false;
    }
  }

  sourceOf(bag: StationBag): BagSource {
    return this.files.source(bag);
  }

  close(): void {
    if (this.player?.trouble) this.onFault(this.player.trouble);
    this.player = undefined;
  }

  tick(now: number): void {
    this.player?.tick(now);
    this.list.tick(now);
    if (this.connection.state.phase !== "open") {
      this.#recorder = undefined;
      this.order.forget();
    }
    const wanted = this.order.due(now);
    if (wanted !== undefined && !this.connection.setParameter(recordingParameter, wanted)) this.order.notSent();
    if (!this.order.unheeded) return;
    this.order.unheeded = false;
    this.onFault("the station's recorder has not done what was asked");
  }

  /** Watches what the recorder does as soon as there is one, and anew when it was restarted. */
  onContainer({ components, pid }: ContainerState): void {
    if (pid === this.#recorder || !components.some(({ name }) => name === recorderNode)) return;
    this.#recorder = pid;
    this.order.forget();
    this.connection.watchParameters([recordingParameter]);
  }

  onParameter(name: string, value: unknown): void {
    if (name === recordingParameter) this.order.onValue(value);
  }
}
