// SPDX-License-Identifier: Apache-2.0
// Messages for tests: plausible ones, of which a test states what matters.
import type * as m from "../src/model/messages.ts";

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

export const transmission = (changes: Partial<m.TransmissionState>): m.TransmissionState => ({
  stamp: stampOf(0),
  role: "uxv",
  active: true,
  policy: "tocp_dsp",
  reason: "steady",
  qni: 80,
  statistic: 0,
  threshold: 5.5,
  deadline_s: NaN,
  ...changes,
});

export const safety = (changes: Partial<m.SafetyStatus> = {}): m.SafetyStatus => ({
  stamp: stampOf(0),
  emergency_stop: false,
  bumper: 0,
  cliff: 0,
  wheel_drop: 0,
  enabled: true,
  stopped_by: [],
  ...changes,
});

export const navigation = (changes: Partial<m.NavigationStatus>): m.NavigationStatus => ({
  stamp: stampOf(0),
  goal_id: 0n,
  state: "idle",
  distance_m: NaN,
  mission: 0n,
  ...changes,
});

export const mission = (changes: Partial<m.MissionStatus>): m.MissionStatus => ({
  stamp: stampOf(0),
  mission: "mission_a",
  state: "running",
  waypoint: 0,
  waypoints: 9,
  elapsed_s: 0,
  ...changes,
});

export const goal = (changes: Partial<m.Goal>): m.Goal => ({
  stamp: stampOf(0),
  id: 1n,
  waypoint: 0,
  x: 0,
  y: 0,
  yaw: 0,
  tolerance_m: 0.15,
  lifetime_s: 60,
  ahead: [],
  mission: 7n,
  ...changes,
});

export const topicTraffic = (topic: string, sent: number, changes: Partial<m.TopicTraffic> = {}): m.TopicTraffic => ({
  topic,
  traffic_class: "high",
  paused: false,
  sent: BigInt(sent),
  dropped: 0n,
  ...changes,
});

export const trafficReport = (topics: m.TopicTraffic[], ms = 0, process = "drive"): m.TrafficReport => ({
  stamp: stampOf(ms),
  role: "uxv",
  process,
  topics,
});

export const linkClass = (changes: Partial<m.LinkClass>): m.LinkClass => ({
  traffic_class: "high",
  offered: 0n,
  sent: 0n,
  delivered: 0n,
  late: 0n,
  lost: 0n,
  repaired: 0n,
  dropped_paused: 0n,
  dropped_superseded: 0n,
  dropped_thinned: 0n,
  dropped_expired: 0n,
  dropped_overflow: 0n,
  bytes: 0n,
  queue_samples: 0,
  delay_s: NaN,
  ...changes,
});

export const linkState = (classes: m.LinkClass[]): m.LinkState => ({
  stamp: stampOf(0),
  role: "uxv",
  paused: false,
  live_peers: 1,
  silent_peers: 0,
  capacity_bytes_per_s: 1e5,
  backlog_s: 0,
  loss: 0,
  scale: 1,
  repair_share: 0,
  bytes: 0n,
  classes,
  capacity_measured: true,
  stored: [],
});

export const quality = (changes: Partial<m.NetworkQuality>): m.NetworkQuality => ({
  stamp: stampOf(0),
  per_percent: 0,
  rtt_mean_ms: 3,
  signal_dbm: -50,
  quality_percent: 80,
  ...changes,
});

export const battery = (changes: Partial<m.BatteryState>): m.BatteryState => ({
  voltage: 16,
  current: -0.5,
  percentage: 0.8,
  power_supply_status: 2,
  ...changes,
});
