// SPDX-License-Identifier: Apache-2.0
// The messages that the page reads. Their types are printed from idl/ at build time: generated/.

/** Since the Unix epoch, by the clock of its writer. */
export type Stamp = builtin_interfaces.Time;
export type PoseWithCovarianceStamped = geometry_msgs.PoseWithCovarianceStamped;
export type Quaternion = geometry_msgs.Quaternion;
export type Pose = geometry_msgs.Pose;
export type NetworkQuality = tocsin_msgs.NetworkQuality;
export type TransmissionState = tocsin_msgs.TransmissionState;
export type Heartbeat = tocsin_msgs.Heartbeat;
export type Waypoint = tocsin_msgs.Waypoint;
export type Goal = tocsin_msgs.Goal;
export type NavigationStatus = tocsin_msgs.NavigationStatus;
export type MissionStatus = tocsin_msgs.MissionStatus;
export type MemoryUsage = tocsin_msgs.MemoryUsage;
export type CpuLoad = tocsin_msgs.CpuLoad;
export type Temperature = sensor_msgs.Temperature;
export type BatteryState = sensor_msgs.BatteryState;
export type CompressedImage = sensor_msgs.CompressedImage;
export type TopicTraffic = tocsin_msgs.TopicTraffic;
export type TrafficReport = tocsin_msgs.TrafficReport;
export type LinkClass = tocsin_msgs.LinkClass;
export type LinkState = tocsin_msgs.LinkState;
export type StoredTopic = tocsin_msgs.StoredTopic;
export type SafetyStatus = tocsin_msgs.SafetyStatus;
export type EmergencyStopState = tocsin_msgs.EmergencyStopState;
export type DockingStatus = tocsin_msgs.DockingStatus;
export type DriverState = tocsin_msgs.DriverState;
export type ContainerState = tocsin_msgs.ContainerState;
export type DiagnosticArray = diagnostic_msgs.DiagnosticArray;
export type Log = rcl_interfaces.Log;
export type OccupancyGrid = nav_msgs.OccupancyGrid;
export type Path = nav_msgs.Path;

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
