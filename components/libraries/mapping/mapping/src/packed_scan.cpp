// SPDX-License-Identifier: Apache-2.0
#include "mapping/packed_scan.hpp"

namespace tocsin::mapping {

PackedScan::PackedScan(const laser::Scan& scan)
    : laser_(packed({scan.laser})), hits_(packed(scan.hits)), open_(packed(scan.open)) {}

PackedScan::Values PackedScan::packed(const laser::Points& points) {
  Values values;
  values.reserve(2 * points.size());
  for (const geometry::Point& p : points) {
    values.push_back(static_cast<float>(p.x_m));
    values.push_back(static_cast<float>(p.y_m));
  }
  return values;
}

laser::Points PackedScan::points(const Values& values) {
  laser::Points points;
  points.reserve(values.size() / 2);
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
    points.push_back({values[i], values[i + 1]});
  }
  return points;
}

laser::Scan PackedScan::unpacked() const {
  const laser::Points open = points(open_);
  return {points(laser_).front(), points(hits_), open, open};
}

}  // namespace tocsin::mapping
