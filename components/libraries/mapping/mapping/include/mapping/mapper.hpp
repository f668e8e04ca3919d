// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mapping/global_mapper.hpp"

namespace tocsin::mapping {

/// Simultaneous localisation and mapping with a laser in the plane: odometry and scans in, the
/// poses of the scans that were used and a map out. A LocalMapper and a GlobalMapper, one after the
/// other, for a log; a vehicle keeps them apart. Deterministic: the same input gives the same
/// output, bit for bit, on the same machine.
///
/// Pure: no clock, thread or file. Not thread-safe.
class Mapper {
 public:
  explicit Mapper(const MapperParams& params = {}) : local_(params.local), global_(params) {}

  /// Takes a scan of the vehicle at `odometry` (the frame in which the wheels count). Both must be
  /// finite. Returns whether it was used: the vehicle must have moved since the last one.
  bool on_scan(const geometry::Pose& odometry, Scan scan);
  /// The log has ended: places that were seen twice are matched once more, all with all.
  void finish() { global_.finish(local_.finish()); }

  /// Where the vehicle is on the map; `odometry` must be near that of the last scan.
  [[nodiscard]] geometry::Pose pose_at(const geometry::Pose& odometry) const;
  /// The scans that were used, and where they are by the local matching.
  [[nodiscard]] const std::vector<GlobalMapper::Node>& nodes() const { return global_.nodes(); }
  /// Where they are on the map.
  [[nodiscard]] const std::vector<geometry::Pose>& poses() const { return global_.poses(); }
  [[nodiscard]] const GlobalMapper& global() const { return global_; }
  /// All scans on one grid, at where they are now.
  [[nodiscard]] navigation::OccupancyMap map(double resolution_m) const;

 private:
  LocalMapper local_;
  GlobalMapper global_;
};

}  // namespace tocsin::mapping
