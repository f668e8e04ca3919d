// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "coverage/mask.hpp"
#include "coverage/swaths.hpp"
#include "geometry/pose.hpp"

namespace tocsin::coverage {

/// What of a floor a round tool has passed over.
class CoveredFloor {
 public:
  CoveredFloor(const Mask& floor, double width_m);

  void drive(const geometry::Point& from, const geometry::Point& to);
  void drive(const geometry::Path& path);
  /// The swaths of a cell one after the other.
  void drive(const SwathCell& cell);

  /// Cells that a drive would cover and that are not covered yet.
  [[nodiscard]] std::size_t gain(const Swath& swath);
  /// Of the floor [range 0,1].
  [[nodiscard]] double share() const;
  [[nodiscard]] double uncovered_m2() const;
  [[nodiscard]] const Mask& uncovered() const { return uncovered_; }

 private:
  template <class Mark>
  void pass(const geometry::Point& from, const geometry::Point& to, const Mark& mark) const;
  Mask uncovered_;
  Stamp tool_;
  std::size_t all_;
  std::size_t left_;
  std::vector<std::size_t> counted_;
};

}  // namespace tocsin::coverage
