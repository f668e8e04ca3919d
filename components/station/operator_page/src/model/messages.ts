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
/** A pose. */
export type Waypoint = Omit<tocsin_msgs.Waypoint, "send_s">;
export type Goal = tocsin_msgs.Goal;
export type NavigationStatus = tocsin_msgs.NavigationStatus;
export type PlanChoice = tocsin_msgs.PlanChoice;
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
export type AirtimeUse = tocsin_msgs.AirtimeUse;
export type Text = std_msgs.String;
export type StoredTopic = tocsin_msgs.StoredTopic;
export type SafetyStatus = tocsin_msgs.SafetyStatus;
export type EmergencyStopState = tocsin_msgs.EmergencyStopState;
export type DockingStatus = tocsin_msgs.DockingStatus;
export type DriverState = tocsin_msgs.DriverState;
export type ContainerState = tocsin_msgs.ContainerState;
export type DiagnosticArray = diagnostic_msgs.DiagnosticArray;
export type Log = rcl_interfaces.Log;
export type OccupancyGrid = nav_msgs.OccupancyGrid;
export type OccupancyGridUpdate = map_msgs.OccupancyGridUpdate;
export type Path = nav_msgs.Path;
export type LaserScan = sensor_msgs.LaserScan;
export type TFMessage = tf2_msgs.TFMessage;

const of = <Message>(): Message => undefined as unknown as Message;

/** The topics that the page reads, and the types of their messages. */
const topics = {
  location: of<PoseWithCovarianceStamped>(),
  network_quality: of<NetworkQuality>(),
  transmission_state: of<TransmissionState>(),
  heartbeat: of<Heartbeat>(),
  goal: of<Goal>(),
  navigation_status: of<NavigationStatus>(),
  mission_status: of<MissionStatus>(),
  "mission/path": of<Path>(),
  memory_usage: of<MemoryUsage>(),
  cpu_load: of<CpuLoad>(),
  cpu_temperature: of<Temperature>(),
  battery_state: of<BatteryState>(),
  "camera/image_raw/compressed": of<CompressedImage>(),
  traffic_report: of<TrafficReport>(),
  link_state: of<LinkState>(),
  airtime_use: of<AirtimeUse>(),
  link_site: of<Text>(),
  safety_status: of<SafetyStatus>(),
  "emergency_stop/state": of<EmergencyStopState>(),
  "docking/status": of<DockingStatus>(),
  "teleop/driver": of<DriverState>(),
  container_state: of<ContainerState>(),
  diagnostics: of<DiagnosticArray>(),
  rosout: of<Log>(),
  map: of<OccupancyGrid>(),
  map_updates: of<OccupancyGridUpdate>(),
  link_map: of<OccupancyGrid>(),
  plan: of<Path>(),
  "plan/choice": of<PlanChoice>(),
  scan: of<LaserScan>(),
  tf_static: of<TFMessage>(),
};

export type Topics = typeof topics;
export type Topic = keyof Topics;

export const camera = "camera/image_raw/compressed";
/** What comes only while the laser is shown. */
export const scanTopics = ["scan", "tf_static"] as const;
export const topicsRead: ReadonlySet<string> = new Set(Object.keys(topics));
export const isTopicRead = (name: string): name is Topic => topicsRead.has(name);

export type Role = "uxv" | "gcs";
export const roleOf = (text: string): Role | undefined =>
  text === "uxv" || text === "gcs" ? text : undefined;
