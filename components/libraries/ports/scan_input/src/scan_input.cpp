// SPDX-License-Identifier: Apache-2.0
#include "scan_input/scan_input.hpp"

#include "foundation/printable.hpp"
#include "laser_geometry/scan_message.hpp"

namespace tocsin {

ScanInput::ScanInput(Component& owner, WakeMode wake)
    : scan_(owner, wake), tf_static_(owner, wake), log_(owner.name(), owner.node()) {}

std::optional<ScanInput::Turn> ScanInput::take(const geometry::Twist& velocity) {
  return take_at([&](std::int64_t, std::int64_t) { return velocity; });
}

std::optional<ScanInput::Turn> ScanInput::take(const PoseHistory& odometry,
                                               const geometry::Twist& otherwise) {
  return take_at([&](std::int64_t from_ns, std::int64_t to_ns) {
    return odometry.velocity(from_ns, to_ns).value_or(otherwise);
  });
}

std::optional<ScanInput::Turn> ScanInput::take_at(const Velocity& velocity) {
  while (const auto transforms = tf_static_.take()) mounts_.take(*transforms);
  const auto message = scan_.take_latest();
  if (!message) return std::nullopt;
  const std::string& frame = message->header().frame_id();
  const auto mount = mounts_.of(frame);
  if (!mount) {
    say_once("scans are not used: tf_static does not tell where their frame '" + printable(frame) +
             "' sits");
    return std::nullopt;
  }
  const std::int64_t stamp_ns = stamp_ns_of(message->header());
  const double turn_s = static_cast<double>(message->time_increment()) *
                        static_cast<double>(message->ranges().size());
  const bool is_time = turn_s > 0 && turn_s < 1;  // else it is told at once, or no scan
  const auto turn_ns = is_time ? static_cast<std::int64_t>(turn_s * 1e9) : 0;
  auto scan = laser::scan_of(*message, *mount, velocity(stamp_ns, stamp_ns + turn_ns));
  if (!scan) {
    say_once("a scan without readings, or whose angles, times or ranges contradict each other");
    return std::nullopt;
  }
  return Turn{std::move(*scan), stamp_ns};
}

void ScanInput::say_once(const std::string& what) {
  if (what == said_) return;
  said_ = what;
  log_.warn("{}", what);
}

}  // namespace tocsin
