// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "foundation/parameters.hpp"
#include "foundation/state_file.hpp"
#include "geometry/pose.hpp"
#include "localisation/localiser.hpp"
#include "map_ports/pose_output.hpp"
#include "ros_idl/nav2_msgs.hpp"
#include "ros_idl/std_srvs.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "runtime/service_port.hpp"
#include "scan_input/pose_history.hpp"
#include "scan_input/scan_input.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Under the name that nav2's localiser has: look for the vehicle everywhere.
struct ReinitializeGlobalLocalization {
  using Request = std_srvs::srv::Empty_Request;
  using Response = std_srvs::srv::Empty_Response;
  static constexpr const char* name = "reinitialize_global_localization";
};

/// Likewise: it is where the request says.
struct SetInitialPose {
  using Request = nav2_msgs::srv::SetInitialPose_Request;
  using Response = nav2_msgs::srv::SetInitialPose_Response;
  static constexpr const char* name = "set_initial_pose";
};
/// Likewise: the next scan counts as evidence though the vehicle stands.
struct RequestNomotionUpdate {
  using Request = std_srvs::srv::Empty_Request;
  using Response = std_srvs::srv::Empty_Response;
  static constexpr const char* name = "request_nomotion_update";
};

/// Tells where the vehicle is on a known map, with each scan; names and types are those of nav2's
/// localiser. Its pose outlives this process within a launch.
class LocaliserComponent final : public Component {
 public:
  struct Params {
    std::string map_file;
    double start_x_m = 0;
    double start_y_m = 0;
    double start_yaw_rad = 0;
    bool start_anywhere = false;
    localisation::LocaliserParams localiser;
    template <class Visitor>
    void visit(Visitor& v) {
      v("map_file", map_file, "map in the format of ROS's map_server (YAML); required");
      v("start_x_m", start_x_m, {-1e5, 1e5}, "[m] where odometry begins, map frame");
      v("start_y_m", start_y_m, {-1e5, 1e5}, "[m]");
      v("start_yaw_rad", start_yaw_rad, {-7, 7}, "[rad]");
      v("start_anywhere", start_anywhere, "looks everywhere instead");
      localiser.visit(v);
    }
  };

  /// Throws ConfigError when the map cannot be read.
  LocaliserComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void take_orders();
  void take_odometry();
  void take_initial_pose(const topic::InitialPose::Message& message);
  void take_scan(Time now);
  void begin(const geometry::Pose& odom);
  void publish(const localisation::Localiser::Estimate& estimate,
               const builtin_interfaces::msg::Time& stamp);
  void publish_cloud(const builtin_interfaces::msg::Time& stamp, Time now);
  void publish_diagnostics(Time now);
  void remember(Time now);

  Input<topic::Odom> odom_{*this, WakeMode::time_triggered};
  ScanInput scan_{*this};
  OptionalInput<topic::InitialPose> initial_pose_{*this};
  Server<ReinitializeGlobalLocalization> reinitialize_{*this};
  Server<SetInitialPose> set_initial_pose_{*this};
  Server<RequestNomotionUpdate> nomotion_{*this};
  PoseOutput pose_{*this};
  Output<topic::ParticleCloud> cloud_{*this};
  Output<topic::Diagnostics> diagnostics_{*this};

  Params params_;
  localisation::Localiser localiser_;
  StateFile file_;
  PoseHistory odometry_;
  std::optional<geometry::Pose> last_odom_;
  geometry::Twist velocity_;
  geometry::Pose map_from_odom_;
  bool has_begun_ = false;
  bool is_restarted_ = false;
  std::optional<localisation::Health> told_;
  localisation::Localiser::Estimate estimate_;
  Time next_cloud_{};
  Time next_diagnostics_{};
  Time next_save_{};
};

}  // namespace tocsin
