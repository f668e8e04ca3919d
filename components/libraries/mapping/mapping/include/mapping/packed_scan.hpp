// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "laser_geometry/scan.hpp"

namespace tocsin::mapping {

/// A scan in half of its memory: coordinates are kept to about a micrometre, and of the beams
/// without return those that are in a row.
class PackedScan {
 public:
  PackedScan() = default;
  explicit PackedScan(const laser::Scan& scan);

  [[nodiscard]] laser::Scan unpacked() const;
  [[nodiscard]] laser::Points hits() const { return points(hits_); }

  /// Visits laser, hits and open ends as vectors of x and y in turn [m], frame of the vehicle.
  template <class Visitor>
  void visit(Visitor& v) {
    v(laser_);
    v(hits_);
    v(open_);
  }
  template <class Visitor>
  void visit(Visitor& v) const {
    v(laser_);
    v(hits_);
    v(open_);
  }
  /// False after a visit that has left no place of the laser, or half a point.
  [[nodiscard]] bool is_whole() const {
    return laser_.size() == 2 && hits_.size() % 2 == 0 && open_.size() % 2 == 0;
  }

 private:
  using Values = std::vector<float>;
  [[nodiscard]] static Values packed(const laser::Points& points);
  [[nodiscard]] static laser::Points points(const Values& values);
  Values laser_{0, 0};
  Values hits_;
  Values open_;
};

}  // namespace tocsin::mapping
