// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "preact/hooks";

import { isWriting } from "../keys.ts";
import type { Operator } from "../operator.ts";
import { isDrivingKey } from "../orders/stick.ts";
import { pageNow } from "../page_now.ts";
import { CameraPanel } from "./camera_panel.tsx";
import { DrivePanel } from "./drive_panel.tsx";
import { AlertLine, PageHeader } from "./header.tsx";
import { LinkPanel } from "./link_panel.tsx";
import { LogPanel } from "./log_panel.tsx";
import { MapPanel } from "./map_panel.tsx";
import { MissionPanel } from "./mission_panel.tsx";
import { RecordingsBar } from "./recordings.tsx";
import { ReplayBar } from "./replay_bar.tsx";
import { TrafficPanel } from "./traffic_panel.tsx";
import { VehiclePanel } from "./vehicle_panel.tsx";

const drawnEveryMs = 200;
const tabs = ["Map", "Drive", "Link", "Topics", "Vehicle"] as const;
type Tab = (typeof tabs)[number];

/** The whole page. On a phone the tabs choose what is seen; wider ones show everything. */
export function Page({ operator }: { operator: Operator }) {
  const [, draw] = useState(0);
  const now = operator.now();
  const [tab, setTab] = useState<Tab>("Map");
  useEffect(() => {
    const timer = setInterval(() => draw((count) => count + 1), drawnEveryMs);
    return () => clearInterval(timer);
  }, []);
  useEffect(() => listenToKeys(operator), [operator]);
  const looks = { operator, now };
  return (
    <>
      <PageHeader {...looks} />
      <AlertLine {...looks} />
      {operator.recordings.list.shown && <RecordingsBar operator={operator} />}
      {operator.recordings.player && <ReplayBar operator={operator} player={operator.recordings.player} />}
      <main class={`board tab-${tab.toLowerCase()}`}>
        <MapPanel operator={operator} />
        <CameraPanel {...looks} />
        <DrivePanel {...looks} />
        <MissionPanel {...looks} />
        <LinkPanel {...looks} />
        <VehiclePanel {...looks} />
        <TrafficPanel {...looks} />
        <LogPanel operator={operator} />
      </main>
      <nav class="tabs" aria-label="Parts of the page">
        {tabs.map((name) => (
          <button type="button" key={name} aria-pressed={name === tab} onClick={() => setTab(name)}>{name}</button>
        ))}
      </nav>
    </>
  );
}

/** Space stops, wherever the focus is; M takes control; keys that are held drive. */
function listenToKeys(operator: Operator): () => void {
  const { driving } = operator;
  const down = (event: KeyboardEvent): void => {
    if (event.code === "Space") {
      event.preventDefault();
      event.stopPropagation();
      if (!event.repeat) operator.stop.press(pageNow());
    } else if (isWriting(event.target)) {
      return; // letters are letters there
    } else if (event.code === "KeyM" && !event.repeat && !event.ctrlKey && !event.metaKey) {
      driving.authority.toggle();
    } else if (driving.authority.taken && isDrivingKey(event.code)) {
      event.preventDefault();
      driving.heldKeys.add(event.code);
    }
  };
  const up = (event: KeyboardEvent): void => {
    if (event.code === "Space") event.preventDefault(); // it would press the button in focus
    driving.heldKeys.delete(event.code);
  };
  const letGo = (): void => driving.letGo();
  window.addEventListener("keydown", down, { capture: true });
  window.addEventListener("keyup", up, { capture: true });
  window.addEventListener("blur", letGo);
  document.addEventListener("visibilitychange", letGo);
  return () => {
    window.removeEventListener("keydown", down, { capture: true });
    window.removeEventListener("keyup", up, { capture: true });
    window.removeEventListener("blur", letGo);
    document.removeEventListener("visibilitychange", letGo);
  };
}
