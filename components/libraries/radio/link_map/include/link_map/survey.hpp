// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "link_map/link_map.hpp"

namespace tocsin::link_map {

/// Readings by place as they come, of each place the newest 64: its memory grows with the floor
/// that was seen, not with time. Pure.
class Survey {
 public:
  /// False, and left out: values that are not finite, or outside of [-120, 0] dBm.
  bool add(const Reading& reading);

  /// In the order in which they were first met, each near no other.
  [[nodiscard]] std::vector<Place> places() const;
  /// What is kept, by place, the oldest first: added to another survey, they make the same one.
  [[nodiscard]] std::vector<Reading> readings() const;
  [[nodiscard]] std::size_t size() const { return squares_.size(); }

 private:
  struct Square {
    std::vector<Reading> kept;  ///< a ring
    int count = 0;
    geometry::Point mean;  ///< of all
  };
  std::map<std::pair<long, long>, std::size_t> known_;
  std::vector<Square> squares_;
};

}  // namespace tocsin::link_map
