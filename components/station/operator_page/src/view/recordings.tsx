// SPDX-License-Identifier: Apache-2.0
import type { TargetedEvent } from "preact";

import type { Operator } from "../operator.ts";
import { pageNow } from "../page_now.ts";
import type { StationBag } from "../protocol/station_files.ts";
import { bagText } from "../replay/bag_list.ts";
import { sourceOfFile } from "../replay/bag_source.ts";

/** Opens the list; says when the station records. */
export function RecordingsButton({ operator }: { operator: Operator }) {
  const { list, order } = operator.recordings;
  return (
    <button type="button" class="recordings-button" aria-expanded={list.shown} onClick={() => list.show(!list.shown)}>
      {order.recording && <i class="rec" aria-hidden="true">●</i>}
      {order.recording ? "Recording" : "Recordings"}
    </button>
  );
}

/** Record now, the station's recordings, and files of this computer. */
export function RecordingsBar({ operator }: { operator: Operator }) {
  const { bags } = operator.recordings.list;
  return (
    <section class="recordings" aria-label="Recordings">
      <div class="buttons">
        <RecordNow operator={operator} />
        <OpenFile operator={operator} />
        <button type="button" onClick={() => operator.recordings.list.show(false)}>Close</button>
      </div>
      {operator.recordings.list.trouble && <p class="refused">The station's recordings: {operator.recordings.list.trouble}</p>}
      <ul>
        {bags?.map((bag) => <BagLine key={bag.path} bag={bag} operator={operator} />)}
        {bags?.length === 0 && <li class="muted">The station has no recording.</li>}
      </ul>
    </section>
  );
}

function RecordNow({ operator: { recordings: { order }, role } }: { operator: Operator }) {
  const { recording, pending } = order;
  if (recording === undefined) return <span class="muted">No recorder of the station can be told to record.</span>;
  return (
    <button type="button" class={recording ? "stop-recording" : "go"} disabled={pending || role === "observer"}
      onClick={() => order.ask(!recording, pageNow())}>
      {recording ? "End recording" : "Record now"}
    </button>
  );
}

/** Chooses a bag from this computer. */
function OpenFile({ operator }: { operator: Operator }) {
  const open = (event: TargetedEvent<HTMLInputElement>): void => {
    const file = event.currentTarget.files?.[0];
    event.currentTarget.value = "";
    if (file) void operator.openBag(sourceOfFile(file, file.name));
  };
  return (
    <label class="open-bag">
      Open a file of this computer
      <input type="file" accept=".mcap" onChange={open} />
    </label>
  );
}

function BagLine({ bag, operator }: { bag: StationBag; operator: Operator }) {
  const isWhole = bag.end_s !== undefined;
  return (
    <li>
      <button type="button" disabled={!isWhole} title={isWhole ? "Show it" : "It can be shown when it has ended"}
        onClick={() => void operator.openBag(operator.recordings.sourceOf(bag))}>
        Open
      </button>
      <span>
        <b>{bag.path}</b> <span class="muted">{bagText(bag)}</span>
      </span>
    </li>
  );
}
