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

/** The last entries by time, newest first, as messages come late; one that repeats itself is counted. */
export class Journal {
  entries: readonly Entry[] = [];
  #said = new Map<string, string>();

  add(entry: Omit<Entry, "times">): void {
    const later = this.entries.filter(({ at }) => at > entry.at);
    const [before, ...older] = this.entries.slice(later.length);
    const repeats = before?.source === entry.source && before.text === entry.text;
    const rest = before === undefined ? [] : [before, ...older];
    const added = repeats ? [{ ...entry, times: before.times + 1 }, ...older] : [{ ...entry, times: 1 }, ...rest];
    this.entries = [...later, ...added].slice(0, kept);
  }

  /** Says it when it is new about its subject. An empty text is not said, only remembered. */
  onChange(subject: string, entry: Omit<Entry, "times">): void {
    const before = this.#said.get(subject);
    if (before === entry.text) return;
    this.#said.set(subject, entry.text);
    if (entry.text !== "") this.add(entry);
  }
}
