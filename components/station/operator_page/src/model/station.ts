// SPDX-License-Identifier: Apache-2.0
import { plainTopic } from "../protocol/topic_name.ts";
import { ellipse95, type Ellipse, isFinitePose, yawOf } from "./geometry.ts";
import type { History } from "./history.ts";
import { Journal } from "./journal.ts";
import { LinkClasses } from "./link_classes.ts";
import { type Heard, vehicleLostAfterMs } from "./freshness.ts";
import {
  type AirtimeUse,
  type BatteryState,
  type CompressedImage,
  type ContainerState,
  type DiagnosticArray,
  type DockingStatus,
  type EmergencyStopState,
  type Goal,
  type LinkState,
  type Log,
  type MissionStatus,
  type NavigationStatus,
  type PlanChoice,
  type NetworkQuality,
  type OccupancyGrid,
  type Path,
  type Pose,
  type PoseWithCovarianceStamped,
  type Role,
  type SafetyStatus,
  type Stamp,
  type Topic,
  type Topics,
  type TrafficReport,
  type TransmissionState,
  type Waypoint,
  roleOf,
} from "./messages.ts";
import { withTile } from "./map_update.ts";
import { reasonText, standingText } from "./reasons.ts";
import { Route } from "./route.ts";
import { ScanOnMap } from "./scan.ts";
import { DecisionSeries } from "./series.ts";
import { SourceClock, stampMs } from "./source_clock.ts";
import { Trail } from "./trail.ts";
import { TrafficTable } from "./traffic.ts";

/** Where the vehicle is. */
export interface Location extends Waypoint {
  readonly ellipse: Ellipse | undefined;
}

/** What the router and the gate of one side say. */
export class Side {
  transmission: Heard<TransmissionState> | undefined;
  link: Heard<LinkState> | undefined;
  heartbeat: number | undefined;
  /** Why the gate is closed: what the decision said that closed it. */
  pausedBecause: string | undefined;
  readonly decisions = new DecisionSeries();
  readonly classes = new LinkClasses();
}

/** Topics that only the vehicle writes. */
const ofVehicle: ReadonlySet<Topic> = new Set<Topic>([
  "location", "network_quality", "navigation_status", "battery_state", "memory_usage", "cpu_load",
  "cpu_temperature", "camera/image_raw/compressed", "safety_status", "docking/status", "teleop/driver",
  "airtime_use",
]);

/** A late reader gets the last one at once, however old it is: no sign that its writer is alive. */
const latched: ReadonlySet<Topic> = new Set<Topic>([
  "navigation_status", "safety_status", "docking/status", "teleop/driver", "transmission_state",
]);
/**
 * All that is known at the station, from the messages that came. Knows no clock, socket or page:
 * `arrival` is when a message came [ms]. It must not decrease.
 */
export class Station {
  readonly uxv = new Side();
  readonly gcs = new Side();
  readonly trail = new Trail();
  readonly route = new Route();
  readonly traffic = new TrafficTable();
  readonly journal = new Journal();
  readonly scan = new ScanOnMap();
  readonly containers = new Map<string, Heard<ContainerState>>();
  readonly diagnostics = new Map<string, Heard<DiagnosticArray["status"][number]>>();
  location: Heard<Location> | undefined;
  quality: Heard<NetworkQuality> | undefined;
  navigation: Heard<NavigationStatus> | undefined;
  mission: Heard<MissionStatus> | undefined;
  memoryPercent: Heard<number> | undefined;
  cpuPercent: Heard<number> | undefined;
  temperatureC: Heard<number> | undefined;
  battery: Heard<BatteryState> | undefined;
  /** Of the channel that vehicles share. */
  airtime: Heard<AirtimeUse> | undefined;
  /** The other site that the vehicle speaks with, told as long as it does. */
  otherSite: Heard<string> | undefined;
  image: Heard<CompressedImage> | undefined;
  safety: Heard<SafetyStatus> | undefined;
  stop: Heard<EmergencyStopState> | undefined;
  docking: Heard<DockingStatus> | undefined;
  map: OccupancyGrid | undefined;
  /** Of the link's signal: 0 is best, 100 is worst, -1 is not known. */
  linkMap: OccupancyGrid | undefined;
  plan: Heard<Path> | undefined;
  /** What the way of the plan costs beside the shortest one. */
  choice: Heard<PlanChoice> | undefined;
  /** When anything of the vehicle was last heard. */
  vehicleHeard: number | undefined;
  /** Since when it is received without a silence: how late its messages are is not known at once. */
  vehicleHeardSince: number | undefined;
  #clocks = new Map<string, SourceClock>();

  onMessage<Name extends Topic>(topic: Name, message: Topics[Name], arrival: number): void {
    const role = "role" in message ? roleOf(String(message.role)) : undefined;
    const isOfVehicle = ofVehicle.has(topic) || role === "uxv";
    const at = this.#heardAt(isOfVehicle ? "uxv" : (role ?? topic), message, arrival);
    if (isOfVehicle) {
      if (!latched.has(topic)) this.#onSignOfLife(at);
      this.traffic.onSample(topic, arrival);
    }
    const handle = this.#handlers[topic] as (message: Topics[Name], at: number) => void;
    handle(message, at);
  }

  /** What was the case before the first message came. */
  onHistory({ trail }: History): void {
    this.trail.prepend(trail);
  }

  side(role: Role): Side {
    return role === "uxv" ? this.uxv : this.gcs;
  }

  #onSignOfLife(at: number): void {
    const before = this.vehicleHeard ?? -Infinity;
    if (at - before > vehicleLostAfterMs) this.vehicleHeardSince = at;
    this.vehicleHeard = Math.max(before, at);
  }

  #heardAt(source: string, message: object, arrival: number): number {
    const { stamp, header } = message as { stamp?: Stamp; header?: { stamp: Stamp } };
    const ms = stampMs(stamp ?? header?.stamp);
    if (ms === undefined) return arrival;
    let clock = this.#clocks.get(source);
    if (clock === undefined) this.#clocks.set(source, (clock = new SourceClock()));
    return clock.heardAt(ms, arrival);
  }

  #sideOf(role: string): Side | undefined {
    const known = roleOf(role);
    return known === undefined ? undefined : this.side(known);
  }

  readonly #handlers: { [Name in Topic]: (message: Topics[Name], at: number) => void } = {
    location: (message, at) => this.#onLocation(message, at),
    network_quality: (value, at) => (this.quality = { value, at }),
    transmission_state: (message, at) => this.#onTransmission(message, at),
    heartbeat: (message, at) => {
      const side = this.#sideOf(message.role);
      if (side) side.heartbeat = at;
    },
    goal: (message, at) => this.#onGoal(message, at),
    navigation_status: (value, at) => this.#onNavigation(value, at),
    mission_status: (value, at) => {
      this.mission = { value, at };
      this.route.onMission(value);
      const text = `mission ${value.mission}: ${value.state}`;
      const severity = value.state === "aborted" ? "error" : "info";
      this.journal.onChange("mission", { at, severity, source: "mission", text });
    },
    "mission/path": ({ poses }) => this.route.onPath(poses.map(({ pose }) => waypointOf(pose))),
    memory_usage: (message, at) => (this.memoryPercent = { value: message.used_percent, at }),
    cpu_load: (message, at) => (this.cpuPercent = { value: message.load_percent, at }),
    cpu_temperature: (message, at) => (this.temperatureC = { value: message.temperature, at }),
    battery_state: (value, at) => (this.battery = { value, at }),
    airtime_use: (value, at) => (this.airtime = { value, at }),
    "camera/image_raw/compressed": (value, at) => (this.image = { value, at }),
    traffic_report: (message, at) => this.#onTraffic(message, at),
    link_state: (value, at) => {
      const side = this.#sideOf(value.role);
      if (!side) return;
      side.link = { value, at };
      side.classes.onState(value, at);
    },
    link_site: ({ data }, at) => (this.otherSite = { value: data, at }),
    safety_status: (value, at) => this.#onSafety(value, at),
    "emergency_stop/state": (value, at) => (this.stop = { value, at }),
    "docking/status": (value, at) => (this.docking = { value, at }),
    "teleop/driver": (message, at) => {
      const text = message.driver === "" ? "" : `${message.driver} drives by hand`;
      this.journal.onChange("driver", { at, severity: "info", source: "vehicle", text });
    },
    container_state: (value, at) => this.#onContainer(value, at),
    diagnostics: (message, at) => this.#onDiagnostics(message, at),
    rosout: (message, at) => this.#onLog(message, at),
    map: (value) => (this.map = value),
    map_updates: (tile) => (this.map = (this.map && withTile(this.map, tile)) ?? this.map),
    link_map: (value) => (this.linkMap = value),
    plan: (value, at) => (this.plan = { value, at }),
    "plan/choice": (value, at) => (this.choice = { value, at }),
    scan: (message) => this.scan.onScan(message),
    tf_static: (message) => this.scan.onTransforms(message),
  };

  #onTraffic(report: TrafficReport, at: number): void {
    if (roleOf(report.role) !== "uxv") return;
    this.traffic.onReport(report, at);
    // What is told on changes only holds as long as its writer lives.
    const tells = (topic: string): boolean => report.topics.some((one) => plainTopic(one.topic) === topic);
    if (this.safety && tells("safety_status")) this.safety = { ...this.safety, at };
    if (this.docking && tells("docking/status")) this.docking = { ...this.docking, at };
  }

  #onLocation(message: PoseWithCovarianceStamped, at: number): void {
    const pose = waypointOf(message.pose.pose);
    if (!isFinitePose(pose)) return;
    this.scan.onLocation(message.header.stamp, pose);
    this.location = { value: { ...pose, ellipse: ellipse95(message.pose.covariance) }, at };
    const transmission = this.uxv.transmission?.value;
    this.trail.add(pose, transmission?.qni, transmission?.active === false);
  }

  #onTransmission(message: TransmissionState, at: number): void {
    const side = this.#sideOf(message.role);
    if (!side) return;
    const wasActive = side.transmission?.value.active;
    side.transmission = { value: message, at };
    side.decisions.onState(message, at);
    if (wasActive === message.active) return;
    side.pausedBecause = message.active ? undefined : message.reason;
    const name = message.role === "uxv" ? "vehicle" : "station";
    if (!message.active) {
      const text = `${name} pauses: ${reasonText(message.reason)}`;
      this.journal.add({ at, severity: "warning", source: "link", text });
    } else if (wasActive === false) {
      const text = `${name} sends all again: ${reasonText(message.reason)}`;
      this.journal.add({ at, severity: "info", source: "link", text });
    }
  }

  #onGoal(goal: Goal, at: number): void {
    this.route.onGoal(goal);
    const text = `goal: waypoint ${goal.waypoint + 1} at (${goal.x.toFixed(1)}, ${goal.y.toFixed(1)}) m`;
    this.journal.onChange("goal", { at, severity: "info", source: "mission", text });
  }

  #onNavigation(value: NavigationStatus, at: number): void {
    this.navigation = { value, at };
    this.route.onStatus(value);
    const standing = standingText(value.state, value.reason);
    const text = standing === undefined ? "" : `the vehicle ${standing}`;
    const severity = value.reason === "sending" ? "info" : "warning";
    this.journal.onChange("navigation", { at, severity, source: "vehicle", text });
  }

  #onSafety(value: SafetyStatus, at: number): void {
    this.safety = { value, at };
    const hindered = hindrances(value).join(", ");
    const entry = { at, severity: "error", source: "safety", text: hindered } as const;
    this.journal.onChange("safety", entry);
  }

  #onContainer(value: ContainerState, at: number): void {
    this.containers.set(value.container, { value, at });
    for (const { name, state, error } of value.components) {
      const text = state === "error" ? `${name}: ${error}` : "";
      this.journal.onChange(`component ${name}`, { at, severity: "error", source: value.container, text });
    }
  }

  #onDiagnostics(message: DiagnosticArray, at: number): void {
    for (const status of message.status) {
      const before = this.diagnostics.get(status.name);
      this.diagnostics.set(status.name, { value: status, at });
      const isNew = before?.value.message !== status.message || before.value.level !== status.level;
      if (!isNew || status.level === 0) continue;
      const severity = status.level === 2 ? "error" : "warning";
      this.journal.add({ at, severity, source: status.name, text: status.message });
    }
  }

  #onLog(message: Log, at: number): void {
    const severity = message.level >= 40 ? "error" : message.level >= 30 ? "warning" : "info";
    this.journal.add({ at, severity, source: message.name, text: message.msg });
  }
}

const waypointOf = ({ position: { x, y }, orientation }: Pose): Waypoint => ({ x, y, yaw: yawOf(orientation) });

const bits = (value: number, names: readonly string[]): string =>
  names.filter((_, index) => value & (1 << index)).join(" and ");

/** Why the vehicle may not move as its drivers want; empty: nothing hinders. */
export function hindrances(status: SafetyStatus): string[] {
  const by = status.stopped_by.length > 0 ? ` of ${status.stopped_by.join(" and ")}` : "";
  const found: string[] = [];
  if (status.emergency_stop) found.push(`emergency stop${by}`);
  if (status.bumper) found.push(`bumper ${bits(status.bumper, ["right", "centre", "left"])}`);
  if (status.cliff) found.push(`cliff ${bits(status.cliff, ["right", "centre", "left"])}`);
  if (status.wheel_drop) found.push(`wheel drop ${bits(status.wheel_drop, ["right", "left"])}`);
  if (!status.enabled) found.push("bumper, cliff and wheel drop are not looked at");
  return found;
}
