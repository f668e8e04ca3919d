// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "emergency_stop_input/emergency_stop_input.hpp"
#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "map_ports/map_input.hpp"
#include "navigator/costmap_ports.hpp"
#include "navigator/goal_file.hpp"
#include "navigator/link_ports.hpp"
#include "navigator/localiser_file.hpp"
#include "navigator/localiser_pose.hpp"
#include "navigator/navigate_action.hpp"
#include "navigator/navigator.hpp"
#include "navigator/obstacle_inputs.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// By what the navigator knows where the vehicle is.
enum class PoseSource { odometry, localiser };
constexpr std::array<const char*, 2> words_of(PoseSource) { return {"odometry", "localiser"}; }

/// Drives to goals; tells the ground station where the vehicle is and what becomes of the goal.
class NavigatorComponent final : public Component {
 public:
  struct Params {
    std::string map_file;
    double start_x_m = 0;
    double start_y_m = 0;
    double start_yaw_rad = 0;
    PoseSource localisation = PoseSource::odometry;
    double localiser_timeout_s = 2;
    double rate_hz = 20;
    double location_hz = 5;
    double status_period_s = 1;
    double pose_goal_timeout_s = 600;
    Navigator::Params navigator;
    template <class Visitor>
    void visit(Visitor& v) {
      v("map_file", map_file,
        "map in the format of ROS's map_server (YAML); empty: `map`, which somebody publishes");
      v("start_x_m", start_x_m, {-1e5, 1e5}, "[m] where odometry begins, map frame");
      v("start_y_m", start_y_m, {-1e5, 1e5}, "[m]");
      v("start_yaw_rad", start_yaw_rad, {-7, 7}, "[rad]");
      visit_enum(v, "localisation", localisation, Choices{"odometry", "localiser"},
                 "where the pose comes from: odometry since the start, or `amcl_pose`");
      v("localiser_timeout_s", localiser_timeout_s, {0.2, 60},
        "[s] a localiser that is not sure for longer stops the vehicle");
      v("rate_hz", rate_hz, {5, 50}, "[Hz] of velocity commands");
      live(v)("location_hz", location_hz, {0.2, 20}, "[Hz] of the location, over the radio");
      v("status_period_s", status_period_s, {0.1, 60}, "[s] between reports without a change");
      v("pose_goal_timeout_s", pose_goal_timeout_s, {1, 86400},
        "[s] a goal of navigate_to_pose is driven to at most");
      navigator.visit(v);
    }
  };

  /// Throws ConfigError when the map cannot be read.
  NavigatorComponent(Context& context, const Params& params);
  void set_parameters(const Params& params);
  void tick(Time now) override;

 private:
  void take_odometry(Time now);
  void take_map(Time now);
  void take_localiser(Time now);
  [[nodiscard]] std::optional<geometry::Pose> pose_by(const geometry::Pose& odom,
                                                      std::int64_t stamp_ns, Time now);
  void take_store(Time now);
  bool take_orders(Time now);
  bool is_turn(Time now);
  void take_goal(const topic::Goal::Message& message, Time now);
  void drive(const geometry::Twist& velocity);
  void report_location(Time now);
  void report_status(const Navigator::Status& status, Time now);
  void log_change(const Navigator::Status& status);
  void report_plan(Time now);
  void go_on_with_earlier_goal(Time now);
  void remember(Time now);
  void remember_goal();

  Input<topic::Odom> odom_{*this, WakeMode::time_triggered};
  OptionalInput<topic::Goal> goal_{*this};
  EmergencyStopInput emergency_stop_{*this};
  Input<topic::Heartbeat> heartbeat_{*this};
  OptionalInput<topic::LinkState> link_state_{*this, WakeMode::time_triggered};
  Output<topic::CmdVelNavigation> cmd_vel_{*this};
  Output<topic::Location> location_{*this};
  Output<topic::NavigationStatus> status_{*this};
  Output<topic::Plan> plan_{*this};

  std::optional<MapInput> map_;                              ///< without a file
  std::optional<OptionalInput<topic::AmclPose>> amcl_pose_;  ///< where a localiser tells the pose
  std::optional<ObstacleInputs> obstacles_;                  ///< where they are avoided
  std::optional<CostmapPorts> costmaps_;                     ///< there, too
  std::optional<LinkPorts> link_;                            ///< where it is heeded

  Params params_;
  Navigator navigator_;
  NavigateAction action_;
  LocaliserFile file_;
  GoalFile goal_file_;
  std::optional<std::uint64_t> mission_;  ///< of the ground station's last goal
  OdometryLocaliser localiser_;
  LocaliserPose localiser_pose_;
  std::optional<geometry::Pose> pose_;
  std::array<double, 36> covariance_{};  ///< of the localiser
  bool has_new_map_ = false;
  Time next_map_{};
  Time next_turn_{};
  Time next_location_{};
  Time next_status_{};
  Time next_save_{};
  bool is_saved_ = true;
  bool is_goal_saved_ = true;
  std::uint64_t plans_ = 0;  // that were published
  Navigator::Status latest_;
  Navigator::Status reported_;
  bool is_standing_ = false;  // the last command was to stand, and has been sent
};

}  // namespace tocsin
