// SPDX-License-Identifier: Apache-2.0
#include "navigator/localiser_file.hpp"

#include <unistd.h>

#include <limits>
#include <sstream>

namespace tocsin {

std::optional<OdometryLocaliser::Memory> LocaliserFile::load() const {
  std::istringstream text(file_.load().value_or(""));
  OdometryLocaliser::Memory memory;
  navigation::Pose2& start = memory.map_from_odom;
  navigation::Pose2& odom = memory.odom;
  pid_t parent = 0;
  text >> parent >> start.x >> start.y >> start.yaw >> odom.x >> odom.y >> odom.yaw;
  const bool is_ours = text && parent == ::getppid() && is_finite(start) && is_finite(odom);
  return is_ours ? std::optional(memory) : std::nullopt;
}

bool LocaliserFile::save(const OdometryLocaliser::Memory& memory) {
  if (!file_.keeps()) return true;
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << ::getppid();
  for (const navigation::Pose2& pose : {memory.map_from_odom, memory.odom}) {
    text << ' ' << pose.x << ' ' << pose.y << ' ' << pose.yaw;
  }
  return file_.save(text.str());
}

}  // namespace tocsin
