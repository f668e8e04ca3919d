// SPDX-License-Identifier: Apache-2.0
// Messages for tests: plausible ones, of which a test states what matters.
import { DiagnosticArray, DiagnosticStatus } from "../generated/diagnostic_msgs.ts";
import { OccupancyGrid } from "../generated/nav_msgs.ts";
import { BatteryState } from "../generated/sensor_msgs.ts";
import {
  EmergencyStopState, Goal, Heartbeat, LinkClass, LinkState, MissionStatus, NavigationStatus, NetworkQuality, SafetyStatus, TopicTraffic,
  TransmissionState,
} from "../generated/tocsin_msgs.ts";
import type * as m from "../src/model/messages.ts";
import { decoderOf, encoderOf } from "../src/protocol/codec.ts";

/** All fields zero, but for these. */
function zero<Message>({ text }: { text: string }, changes: NoInfer<Partial<Message>>): Message {
  const decode = decoderOf({ name: "", encoding: "ros2msg", text });
  return { ...(decode?.(encoderOf(text)({})) as Message), ...changes };
}

export const stampOf = (ms: number): m.Stamp => ({
  sec: Math.floor(ms / 1000),
  nanosec: Math.round((ms % 1000) * 1e6),
});

export const location = (x: number, y: number, ms = 0): m.PoseWithCovarianceStamped => ({
  header: { stamp: stampOf(ms), frame_id: "map" },
  pose: {
    pose: { position: { x, y, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } },
    covariance: new Float64Array(36),
  },
});

export const transmission = (changes: Partial<m.TransmissionState>): m.TransmissionState =>
  zero(TransmissionState, {
    ...{ role: "uxv", active: true, policy: "tocp_dsp", reason: "steady", qni: 80, threshold: 5.5, deadline_s: NaN },
    ...changes,
  });

export const heartbeat = (ms: number, role = "uxv"): m.Heartbeat => zero(Heartbeat, { stamp: stampOf(ms), role });

export const safety = (changes: Partial<m.SafetyStatus> = {}): m.SafetyStatus => zero(SafetyStatus, { enabled: true, ...changes });

export const stopState = (changes: Partial<m.EmergencyStopState>): m.EmergencyStopState => zero(EmergencyStopState, changes);

export const navigation = (changes: Partial<m.NavigationStatus>): m.NavigationStatus =>
  zero(NavigationStatus, { state: "idle", distance_m: NaN, ...changes });

export const mission = (changes: Partial<m.MissionStatus>): m.MissionStatus =>
  zero(MissionStatus, { mission: "mission_a", state: "running", waypoints: 9, ...changes });

export const goal = (changes: Partial<m.Goal>): m.Goal =>
  zero(Goal, { id: 1n, tolerance_m: 0.15, lifetime_s: 60, mission: 7n, ...changes });

export const topicTraffic = (topic: string, sent: number, changes: Partial<m.TopicTraffic> = {}): m.TopicTraffic =>
  zero(TopicTraffic, { topic, traffic_class: "high", sent: BigInt(sent), ...changes });

export const trafficReport = (topics: m.TopicTraffic[], ms = 0, process = "drive"): m.TrafficReport => ({
  stamp: stampOf(ms),
  role: "uxv",
  process,
  topics,
});

export const linkClass = (changes: Partial<m.LinkClass>): m.LinkClass =>
  zero(LinkClass, { traffic_class: "high", delay_s: NaN, ...changes });

export const linkState = (classes: m.LinkClass[]): m.LinkState =>
  zero(LinkState, { role: "uxv", live_peers: 1, capacity_bytes_per_s: 1e5, scale: 1, classes, capacity_measured: true });

export const quality = (changes: Partial<m.NetworkQuality>): m.NetworkQuality =>
  zero(NetworkQuality, { rtt_mean_ms: 3, signal_dbm: -50, quality_percent: 80, ...changes });

export const battery = (changes: Partial<m.BatteryState>): m.BatteryState =>
  zero(BatteryState, { voltage: 16, current: -0.5, percentage: 0.8, power_supply_status: 2, ...changes });

/** One finding. */
export const diagnostics = (name: string, level: number, message: string): m.DiagnosticArray =>
  zero(DiagnosticArray, { status: [zero(DiagnosticStatus, { name, level, message })] });

/** Origin at `x`, `y`. */
export function grid(resolution: number, width: number, data: ArrayLike<number>, x = 0, y = 0): m.OccupancyGrid {
  const { info } = zero<m.OccupancyGrid>(OccupancyGrid, {});
  const origin = { ...info.origin, position: { x, y, z: 0 } };
  return zero(OccupancyGrid, { info: { ...info, resolution, width, height: data.length / width, origin }, data });
}
