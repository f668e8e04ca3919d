// SPDX-License-Identifier: Apache-2.0
// The messages that the page reads, as far as it reads them. What the fields mean: idl/.

/** Since the Unix epoch, by the clock of its writer. */
export interface Stamp {
  readonly sec: number;
  readonly nanosec: number;
}

export interface Header {
  readonly stamp: Stamp;
  readonly frame_id: string;
}

export interface Vector3 {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

export interface Quaternion extends Vector3 {
  readonly w: number;
}

export interface Pose {
  readonly position: Vector3;
  readonly orientation: Quaternion;
}

export interface PoseWithCovarianceStamped {
  readonly header: Header;
  readonly pose: { readonly pose: Pose; readonly covariance: ArrayLike<number> };
}

export interface NetworkQuality {
  readonly stamp: Stamp;
  readonly per_percent: number;
  readonly rtt_mean_ms: number;
  readonly signal_dbm: number;
  readonly quality_percent: number;
}

export interface TransmissionState {
  readonly stamp: Stamp;
  readonly role: string;
  readonly active: boolean;
  readonly policy: string;
  readonly reason: string;
  readonly qni: number;
  readonly statistic: number;
  readonly threshold: number;
  readonly deadline_s: number;
}

export interface Heartbeat {
  readonly stamp: Stamp;
  readonly role: string;
}

export interface Waypoint {
  readonly x: number;
  readonly y: number;
  readonly yaw: number;
}

export interface Goal extends Waypoint {
  readonly stamp: Stamp;
  readonly id: bigint;
  readonly waypoint: number;
  readonly tolerance_m: number;
  readonly lifetime_s: number;
  readonly ahead: readonly Waypoint[];
  readonly mission: bigint;
}

export interface NavigationStatus {
  readonly stamp: Stamp;
  readonly goal_id: bigint;
  readonly state: string;
  readonly distance_m: number;
  readonly mission: bigint;
}

export interface MissionStatus {
  readonly stamp: Stamp;
  readonly mission: string;
  readonly state: string;
  readonly waypoint: number;
  readonly waypoints: number;
  readonly elapsed_s: number;
}

export interface MemoryUsage {
  readonly used_percent: number;
}

export interface CpuLoad {
  readonly load_percent: number;
}

export interface Temperature {
  readonly temperature: number;
}

export interface BatteryState {
  readonly voltage: number;
  readonly current: number;
  readonly percentage: number;
  readonly power_supply_status: number;
}

export interface CompressedImage {
  readonly header: Header;
  readonly format: string;
  readonly data: Uint8Array;
}

export interface TopicTraffic {
  readonly topic: string;
  readonly traffic_class: string;
  readonly paused: boolean;
  readonly sent: bigint;
  readonly dropped: bigint;
}

export interface TrafficReport {
  readonly stamp: Stamp;
  readonly role: string;
  readonly process: string;
  readonly topics: readonly TopicTraffic[];
}

export interface LinkClass {
  readonly traffic_class: string;
  readonly offered: bigint;
  readonly sent: bigint;
  readonly delivered: bigint;
  readonly late: bigint;
  readonly lost: bigint;
  readonly repaired: bigint;
  readonly dropped_paused: bigint;
  readonly dropped_superseded: bigint;
  readonly dropped_thinned: bigint;
  readonly dropped_expired: bigint;
  readonly dropped_overflow: bigint;
  readonly bytes: bigint;
  readonly queue_samples: number;
  readonly delay_s: number;
}

export interface LinkState {
  readonly stamp: Stamp;
  readonly role: string;
  readonly paused: boolean;
  readonly live_peers: number;
  readonly silent_peers: number;
  readonly capacity_bytes_per_s: number;
  readonly backlog_s: number;
  readonly loss: number;
  readonly scale: number;
  readonly repair_share: number;
  readonly bytes: bigint;
  readonly classes: readonly LinkClass[];
  readonly capacity_measured: boolean;
  readonly stored: readonly StoredTopic[];
}

export interface StoredTopic {
  readonly topic: string;
  readonly stored: bigint;
  readonly filled_in: bigint;
  readonly expired: bigint;
  readonly refused: bigint;
  readonly waiting: number;
}

export interface SafetyStatus {
  readonly stamp: Stamp;
  readonly emergency_stop: boolean;
  readonly bumper: number;
  readonly cliff: number;
  readonly wheel_drop: number;
  readonly enabled: boolean;
  readonly stopped_by: readonly string[];
}

export interface EmergencyStopState {
  readonly asked: string;
  readonly vehicle: string;
  readonly stopped_by: readonly string[];
}

export interface DockingStatus {
  readonly state: string;
  readonly result: string;
}

export interface DriverState {
  readonly driver: string;
  readonly asked_by: string;
}

export interface ContainerState {
  readonly stamp: Stamp;
  readonly host: string;
  readonly container: string;
  readonly pid: number;
  readonly components: readonly {
    readonly library: string;
    readonly name: string;
    readonly state: string;
    readonly error: string;
  }[];
}

export interface DiagnosticArray {
  readonly header: Header;
  readonly status: readonly {
    readonly level: number;
    readonly name: string;
    readonly message: string;
    }[];
}

/** A line of a log, as rcl_interfaces/msg/Log on `rosout`. */
export interface Log {
  readonly stamp: Stamp;
  readonly level: number;
  readonly name: string;
  readonly msg: string;
}

export interface OccupancyGrid {
  readonly info: {
    readonly resolution: number;
    readonly width: number;
    readonly height: number;
    readonly origin: Pose;
  };
  readonly data: ArrayLike<number>;
}

export interface Path {
  readonly poses: readonly { readonly pose: Pose }[];
}

/** The topics that the page reads, and their messages. */
export interface Topics {
  location: PoseWithCovarianceStamped;
  network_quality: NetworkQuality;
  transmission_state: TransmissionState;
  heartbeat: Heartbeat;
  goal: Goal;
  navigation_status: NavigationStatus;
  mission_status: MissionStatus;
  "mission/path": Path;
  memory_usage: MemoryUsage;
  cpu_load: CpuLoad;
  cpu_temperature: Temperature;
  battery_state: BatteryState;
  "camera/image_raw/compressed": CompressedImage;
  traffic_report: TrafficReport;
  link_state: LinkState;
  safety_status: SafetyStatus;
  "emergency_stop/state": EmergencyStopState;
  "docking/status": DockingStatus;
  "teleop/driver": DriverState;
  container_state: ContainerState;
  diagnostics: DiagnosticArray;
  rosout: Log;
  map: OccupancyGrid;
  plan: Path;
}

export type Topic = keyof Topics;

const everyTopic: Record<Topic, true> = {
  location: true,
  network_quality: true,
  transmission_state: true,
  heartbeat: true,
  goal: true,
  navigation_status: true,
  mission_status: true,
  "mission/path": true,
  memory_usage: true,
  cpu_load: true,
  cpu_temperature: true,
  battery_state: true,
  "camera/image_raw/compressed": true,
  traffic_report: true,
  link_state: true,
  safety_status: true,
  "emergency_stop/state": true,
  "docking/status": true,
  "teleop/driver": true,
  container_state: true,
  diagnostics: true,
  rosout: true,
  map: true,
  plan: true,
};

export const camera = "camera/image_raw/compressed";
export const topicsRead: ReadonlySet<string> = new Set(Object.keys(everyTopic));
export const isTopicRead = (name: string): name is Topic => topicsRead.has(name);

export type Role = "uxv" | "gcs";
export const roleOf = (text: string): Role | undefined =>
  text === "uxv" || text === "gcs" ? text : undefined;
