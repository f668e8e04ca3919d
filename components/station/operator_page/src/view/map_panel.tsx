// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef, useState } from "preact/hooks";

import { MapCanvas } from "../map/map_canvas.ts";
import { isFree } from "../map/grid.ts";
import { qualityWords } from "../model/quality.ts";
import { type Operator, pageNow } from "../operator.ts";
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
  const { draft } = operator;
  const setDraft = (poses: typeof draft): void => {
    operator.draft = poses;
    redraw((count) => count + 1);
  };
  return (
    <Panel name="map" title="Map" aside={<Legend />}>
      <div class="map-frame">
        <canvas ref={element} tabIndex={0} aria-label="Map: drag to move, wheel or + and - to zoom" />
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
          <button
            type="button"
            title="Choose a goal (G)"
            aria-pressed={draft !== undefined}
            onClick={() => setDraft(draft ? undefined : [])}
          >
            Goal
          </button>
        </div>
        {draft && <GoalBar operator={operator} setDraft={setDraft} />}
      </div>
    </Panel>
  );
}

function GoalBar({ operator, setDraft }: { operator: Operator; setDraft: (poses: Operator["draft"]) => void }) {
  const draft = operator.draft ?? [];
  const { map } = operator;
  const blocked = draft.findIndex((place) => map !== undefined && !isFree(map, place));
  return (
    <div class="goal-bar">
      {blocked >= 0
        ? <span class="refused">Place {blocked + 1} is in a wall or beyond the map.</span>
        : draft.length === 0
        ? <span title="Arrow keys move, [ ] turn">Press on the map, drag for the heading.</span>
        : <span>{draft.length === 1 ? "Goal" : `Route of ${draft.length}`}. Shift adds a place.</span>}
      <span class="buttons">
        <button type="button" onClick={() => setDraft(undefined)}>Cancel <kbd>Esc</kbd></button>
        <button
          type="button"
          class="go"
          disabled={draft.length === 0 || blocked >= 0 || operator.player !== undefined}
          onClick={() => operator.driveTo(draft, pageNow())}
        >
          Drive there <kbd>Enter</kbd>
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
