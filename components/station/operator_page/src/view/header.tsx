// SPDX-License-Identifier: Apache-2.0
import { type Alert, alertOf } from "../model/alerts.ts";
import type { Operator } from "../operator.ts";
import { pageNow } from "../page_now.ts";
import { RecordingsButton } from "./recordings.tsx";
import { StopButton } from "./stop_button.tsx";
import { StripView } from "./strip.tsx";

export function PageHeader({ operator, now }: { operator: Operator; now: number }) {
  const { phase } = operator.connection.state;
  const words = { open: "connected", connecting: "connecting", lost: "not connected" }[phase];
  const { vehicle, host } = operator.server?.metadata ?? {};
  const name = vehicle ?? host ?? "";
  const role = operator.role === "operator" ? "" : `, ${operator.role}`;
  return (
    <header class="top">
      <div class="brand">
        <strong>Tocsin</strong>
        <span class={`connection ${phase}`}>{name ? `${name}, ` : ""}{words}{role}</span>
        {operator.server?.metadata.fleet && <a href={`fleet.html${window.location.search}`}>fleet</a>}
      </div>
      <StripView operator={operator} now={now} />
      <RecordingsButton operator={operator} />
      <StopButton operator={operator} now={pageNow()} />
    </header>
  );
}

const recordingAlert = (name: string): Alert => ({
  severity: "warning",
  text: `This is the recording ${name}, not the vehicle now. The emergency stop acts on the vehicle.`,
});

/** The one line that tells the worst. It takes its room always, so that nothing jumps. */
export function AlertLine({ operator, now }: { operator: Operator; now: number }) {
  const alert = operator.recordings.player
    ? recordingAlert(operator.recordings.player.name)
    : alertOf(operator.connection.state, operator.station, now);
  return (
    <p class={`alert ${alert.severity}`} role="status">{alert.text}</p>
  );
}
