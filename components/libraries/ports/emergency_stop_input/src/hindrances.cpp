// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/hindrances.hpp"

#include "foundation/joined.hpp"

namespace tocsin {

std::vector<std::string> hindrances(const tocsin_msgs::msg::SafetyStatus& status) {
  std::vector<std::string> all;
  if (status.emergency_stop()) {
    const auto& by = status.stopped_by();
    all.push_back("EMERGENCY STOP" + (by.empty() ? "" : " of " + joined(by, " and ")));
  }
  if (status.bumper() != 0) all.emplace_back("bumper");
  if (status.cliff() != 0) all.emplace_back("cliff");
  if (status.wheel_drop() != 0) all.emplace_back("wheel drop");
  if (!status.enabled()) all.emplace_back("bumper, cliff and wheel drop are not looked at");
  return all;
}

}  // namespace tocsin
