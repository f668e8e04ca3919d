// SPDX-License-Identifier: Apache-2.0
import type { BatteryState } from "../model/messages.ts";
import { hindrances } from "../model/station.ts";
import type { Operator } from "../operator.ts";
import { Panel, Value, number } from "./parts.tsx";

const statuses = ["", "charging", "", "not charging", "full"];

export function VehiclePanel({ operator, now }: { operator: Operator; now: number }) {
  const { station } = operator;
  const safety = station.safety;
  return (
    <Panel name="vehicle" title="Vehicle">
      <dl class="values">
        <Value label="Safety" heard={safety} now={now} bad={(value) => hindrances(value).length > 0}
          show={(value) => hindrances(value).join(", ") || "nothing hinders"} />
        <Value label="Battery" heard={station.battery} now={now} bad={({ percentage }) => percentage < 0.2}
          show={batteryText} />
        <Value label="CPU" heard={station.cpuPercent} now={now} bad={(value) => value > 90}
          show={(value) => number(value, 0, "%")} />
        <Value label="Memory" heard={station.memoryPercent} now={now} bad={(value) => value > 90}
          show={(value) => number(value, 0, "%")} />
        <Value label="CPU heat" heard={station.temperatureC} now={now} bad={(value) => value > 85}
          show={(value) => number(value, 0, "°C")} />
        <Value label="Docking" heard={station.docking} now={now}
          show={({ state, result }) => (result === "none" || result === "" ? state : `${state}, ${result}`)} />
      </dl>
    </Panel>
  );
}

function batteryText({ percentage, voltage, power_supply_status }: BatteryState): string {
  const status = statuses[power_supply_status];
  return `${number(100 * percentage, 0, "%")}, ${number(voltage, 1, "V")}${status ? `, ${status}` : ""}`;
}
