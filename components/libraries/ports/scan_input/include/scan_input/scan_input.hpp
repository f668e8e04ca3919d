// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "geometry/twist.hpp"
#include "laser_geometry/laser_mounts.hpp"
#include "laser_geometry/scan.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "scan_input/pose_history.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Member of a component that looks at the laser: its ports `scan` and `tf_static`.
///
/// A scan counts only when tf_static has told where its frame sits on the vehicle: a laser that is
/// mounted backwards must not show what is behind as ahead. What is no scan is passed over. Both
/// are said in the log, once. Used by the component's thread.
class ScanInput {
 public:
  struct Turn {
    laser::Scan scan;           ///< frame of the vehicle at the stamp
    std::int64_t stamp_ns = 0;  ///< of the first beam, since the Unix epoch
  };
  explicit ScanInput(Component& owner, WakeMode wake = WakeMode::event_triggered);

  /// The newest turn that was not taken yet, seen by a vehicle that moves like this.
  [[nodiscard]] std::optional<Turn> take(const geometry::Twist& velocity);
  /// The same for one that moved as its odometry says, and like this where that does not tell.
  [[nodiscard]] std::optional<Turn> take(const PoseHistory& odometry,
                                         const geometry::Twist& otherwise);

 private:
  /// Of the vehicle from a first beam to the last one.
  using Velocity = std::function<geometry::Twist(std::int64_t from_ns, std::int64_t to_ns)>;
  [[nodiscard]] std::optional<Turn> take_at(const Velocity& velocity);
  void say_once(const std::string& what);
  OptionalInput<topic::Scan> scan_;
  OptionalInput<topic::TfStatic> tf_static_;
  laser::Mounts mounts_;
  Logger log_;
  std::string said_;
};

/// The stamp of a message [ns] since the Unix epoch.
template <class Header>
[[nodiscard]] std::int64_t stamp_ns_of(const Header& header) {
  constexpr std::int64_t ns_per_s = 1'000'000'000;
  return std::int64_t{header.stamp().sec()} * ns_per_s + std::int64_t{header.stamp().nanosec()};
}

}  // namespace tocsin
