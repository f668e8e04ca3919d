// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/odometry_file.hpp"

#include <unistd.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace tocsin::kobuki {

std::optional<OdometryMemory> OdometryFile::load() const {
  std::istringstream in(file_.load().value_or(""));
  OdometrySnapshot s;
  Duration::rep taken_ns = 0;
  pid_t parent = 0;
  Inertia inertia;
  in >> parent >> s.pose.x_m >> s.pose.y_m >> s.pose.heading_rad >> s.left.angle_rad >>
      s.right.angle_rad >> s.core.timestamp_ms >> s.core.left_encoder >> s.core.right_encoder >>
      inertia.angle_cdeg >> s.gyro_heading_rad >> taken_ns;
  if (!in || parent != ::getppid()) return std::nullopt;
  if (!std::isfinite(s.pose.x_m + s.pose.y_m + s.pose.heading_rad + s.gyro_heading_rad))
    return std::nullopt;
  s.inertia = inertia;
  return OdometryMemory{s, Time(Duration(taken_ns))};
}

bool OdometryFile::save(const OdometryMemory& memory) {
  const OdometrySnapshot& s = memory.odometry;
  if (!s.inertia || !file_.keeps()) return true;
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << ::getppid() << ' ' << s.pose.x_m << ' ' << s.pose.y_m << ' ' << s.pose.heading_rad << ' '
      << s.left.angle_rad << ' ' << s.right.angle_rad << ' ' << s.core.timestamp_ms << ' '
      << s.core.left_encoder << ' ' << s.core.right_encoder << ' ' << s.inertia->angle_cdeg << ' '
      << s.gyro_heading_rad << ' ' << memory.taken.time_since_epoch().count();
  return file_.save(out.str());
}

}  // namespace tocsin::kobuki
