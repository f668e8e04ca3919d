// SPDX-License-Identifier: Apache-2.0

export type Severity = "info" | "warning" | "error";

/** Something that happened, for people. */
export interface Entry {
  readonly at: number;
  readonly severity: Severity;
  readonly source: string;
  readonly text: string;
  /** How often it was said in a row. */
  readonly times: number;
}

const kept = 300;

/** The last entries, newest first; one that repeats itself is counted. */
export class Journal {
  entries: readonly Entry[] = [];
  #said = new Map<string, string>();

  add(entry: Omit<Entry, "times">): void {
    const [newest, ...older] = this.entries;
    const repeats = newest?.source === entry.source && newest.text === entry.text;
    this.entries = repeats
      ? [{ ...entry, times: newest.times + 1 }, ...older]
      : [{ ...entry, times: 1 }, ...this.entries].slice(0, kept);
  }

  /** Says it when it is new about its subject. An empty text is not said, only remembered. */
  onChange(subject: string, entry: Omit<Entry, "times">): void {
    const before = this.#said.get(subject);
    if (before === entry.text) return;
    this.#said.set(subject, entry.text);
    if (entry.text !== "") this.add(entry);
  }
}
