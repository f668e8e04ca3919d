// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "geometry/pose.hpp"
#include "geometry/pose_message.hpp"

namespace tocsin::laser {

/// Where sensors sit on the vehicle, as tf_static tells it: by the name of their frame, seen from
/// above.
class Mounts {
 public:
  /// A tf2_msgs/TFMessage. Transforms that are not finite are passed over.
  template <class TFMessage>
  void take(const TFMessage& message) {
    for (const auto& transform : message.transforms()) {
      const auto& to = transform.transform();
      const geometry::Pose mount{to.translation().x(), to.translation().y(),
                                 geometry::heading_in(to.rotation())};
      if (is_finite(mount)) mounts_[transform.child_frame_id()] = mount;
    }
  }
  /// Empty while nobody has told.
  [[nodiscard]] std::optional<geometry::Pose> of(const std::string& frame) const {
    const auto found = mounts_.find(frame);
    return found == mounts_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::map<std::string, geometry::Pose> mounts_;
};

}  // namespace tocsin::laser
