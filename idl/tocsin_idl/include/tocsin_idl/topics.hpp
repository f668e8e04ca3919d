// SPDX-License-Identifier: Apache-2.0
// The one list of topics: type, name, QoS profile, scope. Both ends name the struct.
#pragma once

#include "idl_support/topic_info.hpp"
#include "ros_idl/diagnostic_msgs.hpp"
#include "ros_idl/geometry_msgs.hpp"
#include "ros_idl/map_msgs.hpp"
#include "ros_idl/nav2_msgs.hpp"
#include "ros_idl/nav_msgs.hpp"
#include "ros_idl/sensor_msgs.hpp"
#include "ros_idl/std_msgs.hpp"
#include "ros_idl/tf2_msgs.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin::topic {

// On the vehicle.

/// Velocity for the base: linear.x [m/s], angular.z [rad/s].
struct CmdVel {
  using Message = geometry_msgs::msg::Twist;
  static constexpr TopicInfo info{"cmd_vel", "command", Scope::host};
};
/// Pose and velocity from the wheels, frame odom.
struct Odom {
  using Message = nav_msgs::msg::Odometry;
  static constexpr TopicInfo info{"odom", "sensor", Scope::host};
};
struct JointStates {
  using Message = sensor_msgs::msg::JointState;
  static constexpr TopicInfo info{"joint_states", "sensor", Scope::host};
};
struct Imu {
  using Message = sensor_msgs::msg::Imu;
  static constexpr TopicInfo info{"sensors/imu_data", "sensor", Scope::host};
};
struct Tf {
  using Message = tf2_msgs::msg::TFMessage;
  static constexpr TopicInfo info{"tf", "sensor", Scope::host};
};
/// Places of sensors on the vehicle.
struct TfStatic {
  using Message = tf2_msgs::msg::TFMessage;
  static constexpr TopicInfo info{"tf_static", "state", Scope::host};
};
/// A turn of the laser.
struct Scan {
  using Message = sensor_msgs::msg::LaserScan;
  static constexpr TopicInfo info{"scan", "sensor", Scope::host};
};
/// Health of devices and components, a status each, about once a second.
struct Diagnostics {
  using Message = diagnostic_msgs::msg::DiagnosticArray;
  static constexpr TopicInfo info{"diagnostics", "event", Scope::host};
};

// The way of a velocity to the base: sources, velocity_mux, velocity_smoother, safety_controller.

/// What the navigator wants.
struct CmdVelNavigation {
  using Message = geometry_msgs::msg::Twist;
  static constexpr TopicInfo info{"cmd_vel/navigation", "command", Scope::host};
};
/// What docking wants.
struct CmdVelDocking {
  using Message = geometry_msgs::msg::Twist;
  static constexpr TopicInfo info{"cmd_vel/docking", "command", Scope::host};
};
/// What an operator wants, as long as it is fresh.
struct CmdVelTeleop {
  using Message = geometry_msgs::msg::Twist;
  static constexpr TopicInfo info{"cmd_vel/teleop", "command", Scope::host};
};
/// What the source wants whose turn it is.
struct CmdVelSelected {
  using Message = geometry_msgs::msg::Twist;
  static constexpr TopicInfo info{"cmd_vel/selected", "command", Scope::host};
};
/// Velocity that what the laser sees allows, from the collision brake.
struct CmdVelChecked {
  using Message = geometry_msgs::msg::Twist;
  static constexpr TopicInfo info{"cmd_vel/checked", "command", Scope::host};
};
/// The same within speed and acceleration limits.
struct CmdVelSmoothed {
  using Message = geometry_msgs::msg::Twist;
  static constexpr TopicInfo info{"cmd_vel/smoothed", "command", Scope::host};
};
/// The input whose turn it is; "idle" when none.
struct MuxActive {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"velocity_mux/active", "state", Scope::host};
};
/// The list of inputs in force: "name priority timeout_s, ..."
struct MuxInputs {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"velocity_mux/inputs", "state", Scope::host};
};
/// A list in the same words replaces the one in force.
struct MuxSetInputs {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"velocity_mux/set_inputs", "command", Scope::host};
};
/// True switches the collision brake off for its `bypass_s`, false on again.
struct CollisionBrakeBypass {
  using Message = std_msgs::msg::Bool;
  static constexpr TopicInfo info{"collision_brake/bypass", "command", Scope::host};
};
/// False switches the reactions to bumper, cliff and wheel drop off.
struct SafetyEnable {
  using Message = std_msgs::msg::Bool;
  static constexpr TopicInfo info{"safety_controller/enable", "command", Scope::host};
};

// From the vehicle to the ground station.

/// Where the vehicle is, frame map.
struct Location {
  using Message = geometry_msgs::msg::PoseWithCovarianceStamped;
  static constexpr TopicInfo info{"location", "telemetry", Scope::link};
};
struct NetworkQuality {
  using Message = tocsin_msgs::msg::NetworkQuality;
  static constexpr TopicInfo info{"network_quality", "telemetry", Scope::link};
};
struct NavigationStatus {
  using Message = tocsin_msgs::msg::NavigationStatus;
  static constexpr TopicInfo info{"navigation_status", "state", Scope::link};
};
struct BatteryState {
  using Message = sensor_msgs::msg::BatteryState;
  static constexpr TopicInfo info{"battery_state", "telemetry", Scope::link};
};
struct MemoryUsage {
  using Message = tocsin_msgs::msg::MemoryUsage;
  static constexpr TopicInfo info{"memory_usage", "telemetry", Scope::link};
};
struct CpuLoad {
  using Message = tocsin_msgs::msg::CpuLoad;
  static constexpr TopicInfo info{"cpu_load", "telemetry", Scope::link};
};
struct CpuTemperature {
  using Message = sensor_msgs::msg::Temperature;
  static constexpr TopicInfo info{"cpu_temperature", "telemetry", Scope::link};
};
struct CameraImage {
  using Message = sensor_msgs::msg::CompressedImage;
  static constexpr TopicInfo info{"camera/image_raw/compressed", "stream", Scope::link};
};

struct SafetyStatus {
  using Message = tocsin_msgs::msg::SafetyStatus;
  static constexpr TopicInfo info{"safety_status", "state", Scope::link};
};
struct DockingStatus {
  using Message = tocsin_msgs::msg::DockingStatus;
  static constexpr TopicInfo info{"docking/status", "state", Scope::link};
};

// From the ground station to the vehicle.

struct Goal {
  using Message = tocsin_msgs::msg::Goal;
  static constexpr TopicInfo info{"goal", "command", Scope::link};
};
struct MissionStatus {
  using Message = tocsin_msgs::msg::MissionStatus;
  static constexpr TopicInfo info{"mission_status", "state", Scope::link};
};
/// All waypoints of the present mission of mission_control, in the order of the drive; empty: none.
struct MissionPath {
  using Message = nav_msgs::msg::Path;
  static constexpr TopicInfo info{"mission/path", "state", Scope::host};
};
/// What people ask of mission_control: "pause", "resume", or "skip N", N the present waypoint
/// from 1.
struct MissionCommand {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"mission/command", "command", Scope::host};
};
/// The floor, frame map, as ROS's map_server publishes it.
struct Map {
  using Message = nav_msgs::msg::OccupancyGrid;
  static constexpr TopicInfo info{"map", "state", Scope::host};
};
/// Where the map has changed since it was published whole.
struct MapUpdates {
  using Message = map_msgs::msg::OccupancyGridUpdate;
  static constexpr TopicInfo info{"map_updates", "event", Scope::host};
};
/// The map that the vehicle makes, tile by tile: each that has changed, and all from time to time.
struct MapTiles {
  using Message = tocsin_msgs::msg::MapTile;
  static constexpr TopicInfo info{"map_tiles", "event", Scope::link};
};
/// The map of the link's signal, frame map: 0 is -30 dBm and better, 100 is -90 dBm and worse; -1
/// where it is not known to 8 dB.
struct LinkMap {
  using Message = nav_msgs::msg::OccupancyGrid;
  static constexpr TopicInfo info{"link_map", "state", Scope::link};
};
/// The chance that the link is lost [%], by place, frame map.
struct LinkRisk {
  using Message = nav_msgs::msg::OccupancyGrid;
  static constexpr TopicInfo info{"link_risk", "state", Scope::host};
};
/// What the explorer does: "idle", "exploring: ...", "waiting: ..." or "done: ..."
struct ExploreStatus {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"explore/status", "state", Scope::host};
};
/// Where the localiser says the vehicle is, frame map; under the name that nav2's localiser has.
struct AmclPose {
  using Message = geometry_msgs::msg::PoseWithCovarianceStamped;
  static constexpr TopicInfo info{"amcl_pose", "state", Scope::host};
};
/// Poses that the localiser holds for possible, frame map.
struct ParticleCloud {
  using Message = nav2_msgs::msg::ParticleCloud;
  static constexpr TopicInfo info{"particle_cloud", "sensor", Scope::host};
};
/// The way that the navigator follows, frame map.
struct Plan {
  using Message = nav_msgs::msg::Path;
  static constexpr TopicInfo info{"plan", "state", Scope::host};
};
/// What the way of `plan` costs beside the shortest one.
struct PlanChoice {
  using Message = tocsin_msgs::msg::PlanChoice;
  static constexpr TopicInfo info{"plan/choice", "state", Scope::host};
};
/// What the navigator plans with, frame map, as Nav2's costmaps: 0 free, 1 to 98 near something, 99
/// where the robot would touch it, 100 an obstacle, -1 unknown. The whole floor, and 3 m about it.
struct GlobalCostmap {
  using Message = nav_msgs::msg::OccupancyGrid;
  static constexpr TopicInfo info{"global_costmap/costmap", "state", Scope::host};
};
struct LocalCostmap {
  using Message = nav_msgs::msg::OccupancyGrid;
  static constexpr TopicInfo info{"local_costmap/costmap", "state", Scope::host};
};
/// What the collision brake does with the velocity, whenever it changes.
struct CollisionMonitorState {
  using Message = nav2_msgs::msg::CollisionMonitorState;
  static constexpr TopicInfo info{"collision_monitor_state", "state", Scope::host};
};
/// Where a person says the vehicle is, frame map.
struct InitialPose {
  using Message = geometry_msgs::msg::PoseWithCovarianceStamped;
  static constexpr TopicInfo info{"initialpose", "command", Scope::link, Requests::anything};
};
/// True stops the vehicle; it stands until everybody who said true has said false, see
/// EmergencyStopLatch. Anybody on the vehicle's or a station's host may stop it, so every writer
/// counts. Who says true goes on saying it: readers that come late get no older sample. It stays on
/// its host; the routers carry what stands in each of their packets (LinkStop).
struct EmergencyStop {
  using Message = std_msgs::msg::Bool;
  static constexpr TopicInfo info{"emergency_stop", "state", Scope::host, Requests::anything};
  /// User data of the writers that speak for the ground station's people, and their name in
  /// SafetyStatus.
  static constexpr const char* station = "tocsinstop=station;";
  static constexpr const char* station_name = "station";
};

/// Of the host's router: what the other side's packets say of the emergency stop. A listener that
/// has received it once and then not for a second takes that for a stop.
struct LinkStop {
  using Message = tocsin_msgs::msg::LinkStop;
  static constexpr TopicInfo info{"link_stop", "sensor", Scope::host};
};
/// What the ground station's people ask for; its component emergency_stop keeps it and sends it.
struct EmergencyStopRequest {
  using Message = std_msgs::msg::Bool;
  static constexpr TopicInfo info{"emergency_stop/request", "event", Scope::host,
                                  Requests::anything};
};
/// Its outcome.
struct EmergencyStopState {
  using Message = tocsin_msgs::msg::EmergencyStopState;
  static constexpr TopicInfo info{"emergency_stop/state", "state", Scope::host};
};
/// Manual driving, from any computer. The stamp is the operator's, frame_id the operator's name:
/// the vehicle follows one of several.
struct TeleopCmdVel {
  using Message = geometry_msgs::msg::TwistStamped;
  static constexpr TopicInfo info{"teleop/cmd_vel", "command", Scope::link};
};
/// Control authority: who drives by hand, and who asks for control.
struct DriverState {
  using Message = tocsin_msgs::msg::DriverState;
  static constexpr TopicInfo info{"teleop/driver", "state", Scope::link};
};
struct DriverRequest {
  using Message = tocsin_msgs::msg::DriverRequest;
  static constexpr TopicInfo info{"teleop/request", "command", Scope::link};
};
/// "start" or "cancel".
struct DockingCommand {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"docking/command", "command", Scope::link};
};

// From both sides; the field `role` says which.

struct Heartbeat {
  using Message = tocsin_msgs::msg::Heartbeat;
  static constexpr TopicInfo info{"heartbeat", "telemetry", Scope::link};
};
struct TransmissionState {
  using Message = tocsin_msgs::msg::TransmissionState;
  static constexpr TopicInfo info{"transmission_state", "state", Scope::link};
};
struct TrafficReport {
  using Message = tocsin_msgs::msg::TrafficReport;
  static constexpr TopicInfo info{"traffic_report", "telemetry", Scope::link};
};

/// Of the host's router: samples sent, late, lost, repaired and dropped, by class and reason.
struct LinkState {
  using Message = tocsin_msgs::msg::LinkState;
  static constexpr TopicInfo info{"link_state", "telemetry", Scope::link};
};
/// With which of several sites the vehicle speaks: once a second of its own router, and of a site's
/// while it is another one.
struct LinkSite {
  using Message = std_msgs::msg::String;
  static constexpr TopicInfo info{"link_site", "telemetry", Scope::host};
};
/// The site's to a vehicle's router.
struct AirtimeShare {
  using Message = tocsin_msgs::msg::AirtimeShare;
  static constexpr TopicInfo info{"airtime_share", "telemetry", Scope::link};
};
/// Of a vehicle's router to the site.
struct AirtimeUse {
  using Message = tocsin_msgs::msg::AirtimeUse;
  static constexpr TopicInfo info{"airtime_use", "telemetry", Scope::link};
};
/// Of the host's router: what writers of adaptive topics may send.
struct LinkBudget {
  using Message = tocsin_msgs::msg::LinkBudget;
  static constexpr TopicInfo info{"link_budget", "state", Scope::host};
};
/// To the host's router: what somebody on this host wants of logs, on whatever host they are.
struct LogRequest {
  using Message = tocsin_msgs::msg::LogRequest;
  static constexpr TopicInfo info{"log_request", "event", Scope::host};
};

// Of every container process.

struct ContainerState {
  using Message = tocsin_msgs::msg::ContainerState;
  static constexpr TopicInfo info{"container_state", "state", Scope::host};
};

using AllLinkTopics =
    List<Location, InitialPose, NetworkQuality, NavigationStatus, BatteryState, MemoryUsage,
         CpuLoad, CpuTemperature, CameraImage, MapTiles, LinkMap, Goal, MissionStatus, SafetyStatus,
         DockingStatus, TeleopCmdVel, DriverState, DriverRequest, DockingCommand, Heartbeat,
         TransmissionState, TrafficReport, LinkState, AirtimeShare, AirtimeUse>;

using AllHostTopics =
    List<CmdVel, Odom, JointStates, Imu, Tf, TfStatic, Scan, Diagnostics, CmdVelNavigation,
         CmdVelDocking, CmdVelTeleop, CmdVelSelected, CmdVelChecked, CmdVelSmoothed, MuxActive,
         MuxInputs, MuxSetInputs, CollisionBrakeBypass, SafetyEnable, EmergencyStop, LinkStop,
         EmergencyStopRequest, EmergencyStopState, MissionPath, MissionCommand, Map, MapUpdates,
         LinkRisk, ExploreStatus, AmclPose, ParticleCloud, Plan, PlanChoice, GlobalCostmap,
         LocalCostmap, CollisionMonitorState, LinkBudget, LinkSite, LogRequest, ContainerState>;

}  // namespace tocsin::topic
