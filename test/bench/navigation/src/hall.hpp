// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "geometry/wall.hpp"
#include "navigation/occupancy_map.hpp"
#include "radio_channel/propagation.hpp"

namespace tocsin::bench {

/// A hall of 30 m x 20 m with racks in rows, gaps in them, and an access point somewhere. Its power
/// is such that the link is lost on a quarter of the floor. Seeded: the same again.
class Hall {
 public:
  static constexpr double half_dbm = -82;  ///< half of the packets are lost

  explicit Hall(std::uint64_t seed);

  [[nodiscard]] const navigation::OccupancyMap& floor() const { return floor_; }
  /// Farther than 0.4 m from all racks and walls.
  [[nodiscard]] geometry::Point free_place(std::mt19937_64& random) const;
  /// Mean over fading.
  [[nodiscard]] double mean_dbm(const geometry::Point& at);
  [[nodiscard]] double lost_share(double dbm) const;

 private:
  [[nodiscard]] std::vector<geometry::Wall> racks(std::mt19937_64& random);
  [[nodiscard]] navigation::OccupancyMap rasterised() const;
  [[nodiscard]] radio::Propagation propagation(std::mt19937_64& random) const;

  std::vector<geometry::Wall> walls_;
  navigation::OccupancyMap floor_;
  radio::Propagation radio_;
  double power_db_ = 0;
};

}  // namespace tocsin::bench
