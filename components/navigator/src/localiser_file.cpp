// SPDX-License-Identifier: Apache-2.0
#include "navigator/localiser_file.hpp"

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <limits>

namespace tocsin {

std::optional<OdometryLocaliser::Memory> LocaliserFile::load() const {
  std::ifstream file(path_);
  OdometryLocaliser::Memory memory;
  navigation::Pose2& start = memory.map_from_odom;
  navigation::Pose2& odom = memory.odom;
  pid_t parent = 0;
  file >> parent >> start.x >> start.y >> start.yaw >> odom.x >> odom.y >> odom.yaw;
  const bool is_ours = file && parent == ::getppid() && is_finite(start) && is_finite(odom);
  return is_ours ? std::optional(memory) : std::nullopt;
}

bool LocaliserFile::save(const OdometryLocaliser::Memory& memory) const {
  if (path_.empty()) return true;
  const std::string fresh = path_ + ".new";
  {
    std::ofstream file(fresh);
    file.precision(std::numeric_limits<double>::max_digits10);
    file << ::getppid();
    for (const navigation::Pose2& pose : {memory.map_from_odom, memory.odom}) {
      file << ' ' << pose.x << ' ' << pose.y << ' ' << pose.yaw;
    }
    file << '\n';
    if (!file.flush()) return false;
  }
  return std::rename(fresh.c_str(), path_.c_str()) == 0;
}

}  // namespace tocsin
