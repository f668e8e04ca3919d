// SPDX-License-Identifier: Apache-2.0
import type { RefObject } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";

import { MapCanvas } from "../map/map_canvas.ts";
import { type MissionDraft, emptyDraft, remove, reorder, select, turnBy } from "../model/mission_draft.ts";
import { qualityWords } from "../model/quality.ts";
import type { Operator } from "../operator.ts";
import { Panel } from "./parts.tsx";

export function MapPanel({ operator }: { operator: Operator }) {
  const element = useRef<HTMLCanvasElement>(null);
  const map = useRef<MapCanvas>(undefined);
  const [, redraw] = useState(0);
  useEffect(() => {
    if (element.current === null) return;
    const canvas = new MapCanvas(element.current, operator, () => redraw((count) => count + 1));
    map.current = canvas;
    return () => canvas.dispose();
  }, [operator]);
  const { draft } = operator.mission;
  const setDraft = (next: typeof draft): void => {
    operator.mission.draft = next;
    map.current?.touch();
    redraw((count) => count + 1);
  };
  return (
    <Panel name="map" title="Map" aside={<Legend />}>
      <div class="map-frame">
        <canvas ref={element} tabIndex={0} aria-label="Map: drag to move, wheel or + and - to zoom" />
        <Tools operator={operator} map={map} onMission={() => setDraft(draft ? undefined : emptyDraft)} />
      </div>
      {operator.place.isArmed && <p class="mission-bar" role="status">Press where the vehicle is, drag for its heading.</p>}
      {draft && <MissionBar operator={operator} setDraft={setDraft} />}
    </Panel>
  );
}

function Tools({ operator, map, onMission }: { operator: Operator; map: RefObject<MapCanvas | undefined>; onMission: () => void }) {
  const onPlace = (): void => {
    operator.place.toggle();
    map.current?.touch();
    map.current?.onChange();
  };
  return (
    <div class="tools">
      <button type="button" title="Zoom in (+)" onClick={() => map.current?.zoom(1.4)}>+</button>
      <button type="button" title="Zoom out (-)" onClick={() => map.current?.zoom(1 / 1.4)}>−</button>
      <button type="button" title="Show all (0)" onClick={() => map.current?.fit()}>All</button>
      <button
        type="button"
        title="Follow the vehicle (F)"
        aria-pressed={map.current?.follows ?? false}
        onClick={() => map.current?.follow(!map.current.follows)}
      >
        Follow
      </button>
      <button type="button" title="Choose places (G)" aria-pressed={operator.mission.draft !== undefined} onClick={onMission}>Mission</button>
      <LaserButton operator={operator} map={map} />
      <button
        type="button"
        title="Say where the vehicle is (L)"
        aria-pressed={operator.place.isArmed}
        disabled={!operator.mayAct}
        onClick={onPlace}
      >
        Place
      </button>
    </div>
  );
}

function LaserButton({ operator, map }: { operator: Operator; map: RefObject<MapCanvas | undefined> }) {
  return (
    <button
      type="button"
      title="Show what the laser sees"
      aria-pressed={map.current?.showsScan ?? false}
      disabled={!operator.connection.offered.has("scan") && operator.recordings.player === undefined}
      onClick={() => map.current?.showScan(!map.current.showsScan)}
    >
      Laser
    </button>
  );
}

/** What is edited, with buttons for fingers and for who has no pointer. */
function MissionBar({ operator, setDraft }: { operator: Operator; setDraft: (draft: Operator["mission"]["draft"]) => void }) {
  const draft = operator.mission.draft ?? emptyDraft;
  const fault = operator.mission.whyNotSend();
  const count = draft.places.length;
  const selected = draft.selected ?? -1;
  const { phase } = operator.mission;
  const refusal = fault ?? (phase.kind === "failed" && draft === operator.mission.refused ? `Place ${selected + 1} of ${count}. Refused: ${phase.reason}` : undefined);
  const step = (label: string, title: string, next: MissionDraft, disabled = selected < 0) => (
    <button type="button" title={title} aria-label={title} disabled={disabled} onClick={() => setDraft(next)}>{label}</button>
  );
  return (
    <div class="mission-bar">
      {refusal !== undefined && count > 0
        ? <span class="refused" role="status">{refusal}</span>
        : <span title="Arrow keys move, [ ] turn, Insert adds, Delete removes, PageUp and PageDown reorder" role="status">
            {fault ?? `Place ${selected + 1} of ${count}: drag to move. A press beside it adds one.`}
          </span>}
      <span class="buttons edit">
        {step("‹", "Select the place before (,)", select(draft, selected - 1), selected <= 0)}
        {step("›", "Select the next place (.)", select(draft, selected + 1), selected + 1 >= count)}
        {step("↑", "Earlier in the order (PageUp)", reorder(draft, -1), selected <= 0)}
        {step("↓", "Later in the order (PageDown)", reorder(draft, 1), selected + 1 >= count)}
        {step("↺", "Turn left ([)", turnBy(draft, Math.PI / 12))}
        {step("↻", "Turn right (])", turnBy(draft, -Math.PI / 12))}
        {step("Remove", "Remove the place (Delete)", remove(draft))}
        {count === 0 && operator.station.route.points().length > 0 &&
          <button type="button" onClick={() => { operator.mission.edit(); setDraft(operator.mission.draft); }}>Edit the present one</button>}
      </span>
      <span class="buttons">
        <button type="button" onClick={() => setDraft(undefined)}>Leave <kbd>Esc</kbd></button>
        <button type="button" class="go" disabled={fault !== undefined} onClick={() => void operator.mission.send()}>
          {count > 1 ? `Send ${count} places` : "Drive there"} <kbd>Enter</kbd>
        </button>
      </span>
    </div>
  );
}

function Legend() {
  return (
    <ul class="legend" aria-label="Colours of the trail: link quality">
      {qualityWords.map((word, step) => (
        <li key={word}><i style={`background: var(--quality-${step})`} /><span>{word}</span></li>
      ))}
    </ul>
  );
}
