// SPDX-License-Identifier: Apache-2.0
#include "transmission_controller/foresight_inputs.hpp"

#include <utility>

#include "geometry/pose_message.hpp"

namespace tocsin {

ForesightInputs::ForesightInputs(Component& owner, double speed_mps)
    : plan_(owner, WakeMode::time_triggered),
      location_(owner, WakeMode::time_triggered),
      risk_(owner),
      way_(speed_mps) {}

decision::Outlook ForesightInputs::outlook(Time now) {
  if (const auto plan = plan_.take_latest()) {
    geometry::Path path;
    for (const auto& pose : plan->poses()) path.push_back(position(geometry::pose_in(pose.pose())));
    way_.set_plan(std::move(path));
  }
  if (auto risk = risk_.take()) way_.set_risk(std::move(*risk));
  if (const auto location = location_.take_latest()) {
    way_.set_place(position(geometry::pose_in(location->pose().pose())), now);
  }
  return way_.outlook(now);
}

}  // namespace tocsin
