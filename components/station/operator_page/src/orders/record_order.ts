// SPDX-License-Identifier: Apache-2.0

/** The station's recorder that waits to be told, and its parameter. */
export const recorderNode = "operator_recorder";
export const recordingParameter = `/${recorderNode}.recording`;

const patienceMs = 5000;

/** Whether the station records, by its recorder's own word, and what was asked of it. */
export class RecordOrder {
  /** Undefined: there is no such recorder, or it was not heard. */
  recording: boolean | undefined;
  /** It has not done what was asked; whoever says it sets it back. */
  unheeded = false;
  #wanted: { readonly value: boolean; readonly at: number } | undefined;
  #sent = false;

  get pending(): boolean {
    return this.#wanted !== undefined;
  }

  ask(value: boolean, now: number): void {
    this.#wanted = { value, at: now };
    this.#sent = false;
  }

  /** What to tell the recorder now; undefined: nothing. */
  due(now: number): boolean | undefined {
    const wanted = this.#wanted;
    if (wanted === undefined) return undefined;
    if (now - wanted.at > patienceMs) {
      this.#wanted = undefined;
      this.unheeded = true;
      return undefined;
    }
    if (this.#sent) return undefined;
    this.#sent = true;
    return wanted.value;
  }

  /** It could not be sent: again at the next turn. */
  notSent(): void {
    this.#sent = false;
  }

  onValue(value: unknown): void {
    this.recording = typeof value === "boolean" ? value : undefined;
    if (this.recording === this.#wanted?.value) this.#wanted = undefined;
  }

  /** The connection is lost, or the recorder is another process: what it does is not known. */
  forget(): void {
    this.recording = undefined;
  }
}
