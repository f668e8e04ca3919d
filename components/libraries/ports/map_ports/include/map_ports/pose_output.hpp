// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/pose.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Member of a component that knows where the vehicle is on the map: its ports `amcl_pose` and
/// `tf`. Used by the component's thread.
class PoseOutput {
 public:
  /// Of x, y [m] and heading [rad], row by row.
  using Covariance = std::array<double, 9>;

  explicit PoseOutput(Component& owner);
  void publish_pose(const geometry::Pose& pose, const Covariance& covariance,
                    const builtin_interfaces::msg::Time& stamp);
  /// The frame odom in the frame map.
  void publish_transform(const geometry::Pose& map_from_odom,
                         const builtin_interfaces::msg::Time& stamp);

 private:
  Output<topic::AmclPose> pose_;
  Output<topic::Tf> tf_;
  Logger log_;
};

/// Of a stamp since the Unix epoch.
[[nodiscard]] builtin_interfaces::msg::Time stamp_of(std::int64_t ns);

}  // namespace tocsin
