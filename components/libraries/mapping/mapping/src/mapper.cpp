// SPDX-License-Identifier: Apache-2.0
#include "mapping/mapper.hpp"

#include <utility>

namespace tocsin::mapping {

using geometry::Pose;

Pose Mapper::pose_at(const Pose& odometry) const {
  const Pose local = local_.pose_at(odometry);
  if (poses().empty()) return local;
  return compose(poses().back(), relative(nodes().back().pose, local));
}

bool Mapper::on_scan(const Pose& odometry, Scan scan) {
  auto step = local_.on_scan(odometry, std::move(scan));
  if (!step) return false;
  global_.add(std::move(*step));
  return true;
}

navigation::OccupancyMap Mapper::map(double resolution_m) const {
  OccupancyGrid grid(resolution_m);
  for (std::size_t i = 0; i < nodes().size(); ++i) {
    grid.insert(nodes()[i].scan.unpacked(), poses()[i]);
  }
  return grid.map();
}

}  // namespace tocsin::mapping
