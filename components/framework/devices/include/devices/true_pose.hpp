// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "devices/device.hpp"
#include "geometry/pose.hpp"

namespace tocsin {

/// Where a vehicle is in truth, frame map: a device that only the computer of a simulated vehicle
/// has.
class TruePose : public Device {
 public:
  static constexpr const char* kind = "true pose";
  [[nodiscard]] static std::string text(const std::string&) { return "of a simulated vehicle"; }
  /// Now.
  [[nodiscard]] virtual geometry::Pose read() { return {}; }
};

}  // namespace tocsin
