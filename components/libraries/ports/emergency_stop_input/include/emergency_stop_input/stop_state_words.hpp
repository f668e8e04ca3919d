// SPDX-License-Identifier: Apache-2.0
// The words of tocsin_msgs/EmergencyStopState.
#pragma once

#include <array>

namespace tocsin {

/// What was last asked for at the station.
enum class StopAsked { never, on, off };
constexpr std::array<const char*, 3> words_of(StopAsked) { return {"never", "on", "off"}; }

/// What the vehicle reported last.
enum class VehicleStop { unheard, stands, may_drive };
constexpr std::array<const char*, 3> words_of(VehicleStop) {
  return {"unheard", "stands", "may_drive"};
}

}  // namespace tocsin
