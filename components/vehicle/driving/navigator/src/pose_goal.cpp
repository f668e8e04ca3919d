// SPDX-License-Identifier: Apache-2.0
#include "navigator/pose_goal.hpp"

namespace tocsin {

const char* to_string(PoseGoalEnd end) {
  switch (end) {
    case PoseGoalEnd::reached:
      return "reached";
    case PoseGoalEnd::canceled:
      return "canceled";
    case PoseGoalEnd::timed_out:
      return "not reached in its time";
    case PoseGoalEnd::superseded:
      return "superseded by another goal";
  }
  return "";
}

std::optional<PoseGoalEnd> PoseGoal::end(const Navigator::Output& output, Time now) const {
  if (output.status.mission != mission_) return PoseGoalEnd::superseded;
  if (output.status.state == Navigator::State::reached) return PoseGoalEnd::reached;
  const bool stands = output.velocity.linear_mps == 0 && output.velocity.angular_rad_s == 0;
  if (canceling_ && stands) return PoseGoalEnd::canceled;
  if (now >= expires_ && stands) return PoseGoalEnd::timed_out;
  return std::nullopt;
}

}  // namespace tocsin
