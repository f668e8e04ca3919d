// SPDX-License-Identifier: Apache-2.0
import { alertOf } from "../model/alerts.ts";
import type { Operator } from "../operator.ts";
import { StopButton } from "./stop_button.tsx";

export function PageHeader({ operator, now }: { operator: Operator; now: number }) {
  const { phase } = operator.connection.state;
  const words = { open: "connected", connecting: "connecting", lost: "not connected" }[phase];
  const name = operator.server?.metadata.vehicle ?? operator.server?.metadata.host ?? "";
  return (
    <header class="top">
      <div class="brand">
        <strong>Tocsin</strong>
        <span class={`connection ${phase}`}>{name ? `${name}, ` : ""}{words}</span>
      </div>
      <StopButton operator={operator} now={now} />
    </header>
  );
}

/** The one line that tells the worst. It takes its room always, so that nothing jumps. */
export function AlertLine({ operator, now }: { operator: Operator; now: number }) {
  const alert = alertOf(operator.connection.state, operator.station, now);
  return (
    <p class={`alert ${alert?.severity ?? "none"}`} role="status">
      {alert?.text ?? "All is well: vehicle and link are heard."}
    </p>
  );
}
