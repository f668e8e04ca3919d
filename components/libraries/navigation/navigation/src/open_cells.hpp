// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <vector>

#include "navigation/cost_map.hpp"

namespace tocsin::navigation {

inline constexpr double start_reach_m = 0.5;   // a blocked start is left for a cell within it
inline constexpr std::uint32_t straight = 10;  // lengths of steps, in tenths of a cell
inline constexpr std::uint32_t diagonal = 14;
inline constexpr std::uint32_t unreached = std::numeric_limits<std::uint32_t>::max();

/// The four straight ones first.
inline constexpr std::array<CellIndex, 8> steps{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

inline CellIndex add(CellIndex a, CellIndex b) { return {a.column + b.column, a.row + b.row}; }

/// Whether a diagonal step passes a blocked cell.
inline bool cuts_corner(const CostMap& map, CellIndex from, CellIndex to) {
  return map.cost(map.grid().offset({to.column, from.row})) == 0 ||
         map.cost(map.grid().offset({from.column, to.row})) == 0;
}

/// The open cells, cheapest estimate first, among equals the last one put in. A ring of buckets,
/// one per estimate: with a consistent heuristic an estimate never lies below the one taken last,
/// nor above it by more than one step, so neither a heap nor a comparison is needed.
class OpenCells {
 public:
  OpenCells() : buckets_(ring_size) {}

  /// Leaves none; no estimate will be below `first`.
  void restart(std::uint32_t first) {
    for (; !empty(); ++current_) {
      auto& bucket = buckets_[current_ % ring_size];
      count_ -= bucket.size();
      bucket.clear();
    }
    current_ = first;
  }

  void put(std::uint32_t estimate, CellIndex cell) {
    assert(estimate - current_ < ring_size);
    buckets_[estimate % ring_size].push_back(cell);
    ++count_;
  }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::uint32_t estimate() const { return current_; }

  /// Asserts that it is not empty.
  CellIndex take() {
    assert(!empty());
    while (buckets_[current_ % ring_size].empty()) ++current_;
    auto& bucket = buckets_[current_ % ring_size];
    const CellIndex cell = bucket.back();
    bucket.pop_back();
    --count_;
    return cell;
  }

 private:
  static constexpr std::uint32_t ring_size = 8192;
  static_assert(diagonal * (CostMap::dearest + CostMap::plain) < ring_size);
  std::vector<std::vector<CellIndex>> buckets_;
  std::uint32_t current_ = 0;
  std::size_t count_ = 0;
};

}  // namespace tocsin::navigation
