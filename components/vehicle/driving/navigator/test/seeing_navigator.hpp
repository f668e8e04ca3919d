// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/numbers.hpp"
#include "navigator_rig.hpp"

namespace tocsin {

/// A navigator with a laser, before a wall that no map has.
class SeeingNavigatorTest : public NavigatorComponentTest {
 protected:
  SeeingNavigatorTest() {
    params_.navigator.surroundings.avoid_obstacles = true;
    start();
    topic::TfStatic::Message message;
    geometry_msgs::msg::TransformStamped transform;
    transform.child_frame_id("laser");
    transform.transform().rotation().w(1);
    message.transforms().push_back(transform);
    bus_.publish<topic::TfStatic>(message);
  }
  [[nodiscard]] builtin_interfaces::msg::Time stamp() const {
    const std::int64_t ns = bus_.wall_ns(bus_.now());
    builtin_interfaces::msg::Time stamp;
    stamp.sec(static_cast<std::int32_t>(ns / 1'000'000'000));
    stamp.nanosec(static_cast<std::uint32_t>(ns % 1'000'000'000));
    return stamp;
  }
  /// A turn that sees a wall across the way at x = `wall_m_` on the map.
  void scan() {
    topic::Scan::Message message;
    message.header().stamp(stamp());
    message.header().frame_id("laser");
    message.angle_increment(static_cast<float>(degree));
    message.range_max(12);
    const geometry::Pose pose{odom_.x_m - 1, odom_.y_m, odom_.heading_rad};
    for (int i = 0; i < 360; ++i) {
      const double ahead = std::cos(i * degree + pose.heading_rad);
      const double range_m = ahead > 0.1 ? (wall_m_ - pose.x_m) / ahead : infinity;
      message.ranges().push_back(static_cast<float>(range_m));
    }
    bus_.publish<topic::Scan>(message);
  }
  void drive(double s) {
    for (int i = 0; i < std::lround(s * 20); ++i) {
      auto message = odometry();
      message.header().stamp(stamp());
      bus_.publish<topic::Odom>(message);
      if (has_laser_ && i % 2 == 0) scan();
      sut_->tick(bus_.now());
      bus_.run_for(seconds(0.05));
      for (const auto& command : commands_.take()) command_ = command;
      odom_ = compose(odom_, {command_.linear().x() * 0.05, 0, command_.angular().z() * 0.05});
      for (const auto& status : statuses_.take()) status_ = status;
    }
  }
  bool has_laser_ = true;
  double wall_m_ = 1.5;
};

}  // namespace tocsin
