// SPDX-License-Identifier: Apache-2.0
#include "navigator/localiser_file.hpp"

#include <unistd.h>

#include <limits>
#include <sstream>

namespace tocsin {

std::optional<OdometryLocaliser::Memory> LocaliserFile::load() const {
  std::istringstream text(file_.load().value_or(""));
  OdometryLocaliser::Memory memory;
  geometry::Pose& start = memory.map_from_odom;
  geometry::Pose& odom = memory.odom;
  pid_t parent = 0;
  text >> parent >> start.x_m >> start.y_m >> start.heading_rad >> odom.x_m >> odom.y_m >>
      odom.heading_rad;
  const bool is_ours = text && parent == ::getppid() && is_finite(start) && is_finite(odom);
  return is_ours ? std::optional(memory) : std::nullopt;
}

bool LocaliserFile::save(const OdometryLocaliser::Memory& memory) {
  if (!file_.keeps()) return true;
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << ::getppid();
  for (const geometry::Pose& pose : {memory.map_from_odom, memory.odom}) {
    text << ' ' << pose.x_m << ' ' << pose.y_m << ' ' << pose.heading_rad;
  }
  return file_.save(text.str());
}

}  // namespace tocsin
