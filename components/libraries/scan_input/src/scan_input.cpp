// SPDX-License-Identifier: Apache-2.0
#include "scan_input/scan_input.hpp"

#include "foundation/printable.hpp"
#include "laser_geometry/scan_message.hpp"

namespace tocsin {

ScanInput::ScanInput(Component& owner, WakeMode wake)
    : scan_(owner, wake), tf_static_(owner, wake), log_(owner.name(), owner.node()) {}

std::optional<ScanInput::Turn> ScanInput::take(const geometry::Twist& velocity) {
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
  auto scan = laser::scan_of(*message, *mount, velocity);
  if (!scan) {
    say_once("a scan without readings, or whose angles, times or ranges contradict each other");
    return std::nullopt;
  }
  return Turn{std::move(*scan), stamp_ns_of(message->header())};
}

void ScanInput::say_once(const std::string& what) {
  if (what == said_) return;
  said_ = what;
  log_.warn("{}", what);
}

}  // namespace tocsin
