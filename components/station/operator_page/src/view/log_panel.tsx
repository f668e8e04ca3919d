// SPDX-License-Identifier: Apache-2.0
import type { Entry } from "../model/journal.ts";
import type { Operator } from "../operator.ts";
import { Panel } from "./parts.tsx";

const levels = ["ok", "warning", "error", "stale"];

/** What happened, newest first, above it what diagnostics find wrong now. */
export function LogPanel({ operator }: { operator: Operator }) {
  const { diagnostics, journal } = operator.station;
  const found = [...diagnostics.values()].filter(({ value }) => value.level !== 0);
  return (
    <Panel name="log" title="Log">
      <div class="scroll">
        <ul class="findings">
          {found.map(({ value }) => (
            <li key={value.name} class={levels[value.level] ?? "error"}>
              <b>{value.name}</b> {value.message}
            </li>
          ))}
        </ul>
        <ol class="entries" aria-live="off">
          {journal.entries.slice(0, 100).map((entry) => <Line key={`${entry.at}${entry.text}`} entry={entry} />)}
          {journal.entries.length === 0 && <li class="muted">Nothing yet</li>}
        </ol>
      </div>
    </Panel>
  );
}

function Line({ entry }: { entry: Entry }) {
  const time = new Date(entry.at).toLocaleTimeString("en-GB");
  return (
    <li class={entry.severity}>
      <time>{time}</time> <b>{entry.source}</b> {entry.text}{entry.times > 1 && ` (${entry.times} times)`}
    </li>
  );
}
