// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "geometry/pose.hpp"
#include "geometry/twist.hpp"

namespace tocsin {

/// Where a vehicle was in the last two seconds, by the stamps of messages. Pure.
class PoseHistory {
 public:
  /// `stamp_ns`: since the Unix epoch. A clock that was put back begins anew.
  void add(std::int64_t stamp_ns, const geometry::Pose& pose);
  /// Between the poses around that time on a straight way; the newest one for a time up to 0.2 s
  /// after it. Empty when it is older than what is kept, or newer than that.
  [[nodiscard]] std::optional<geometry::Pose> at(std::int64_t stamp_ns) const;
  /// Mean velocity between two times. Empty when it does not know both, or they lie closer than
  /// 20 ms.
  [[nodiscard]] std::optional<geometry::Twist> velocity(std::int64_t from_ns,
                                                        std::int64_t to_ns) const;
  void clear() { poses_.clear(); }

 private:
  struct Stamped {
    std::int64_t stamp_ns;
    geometry::Pose pose;
  };
  std::deque<Stamped> poses_;
};

}  // namespace tocsin
