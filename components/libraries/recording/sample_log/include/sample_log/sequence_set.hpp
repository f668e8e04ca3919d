// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

namespace tocsin::sample_log {

/// Numbers of samples as ranges: what comes without gaps takes the room of one range.
class SequenceSet {
 public:
  using Ranges = std::map<std::uint64_t, std::uint64_t>;  ///< first to last, both in it

  /// Whether it was not in it yet.
  bool insert(std::uint64_t sequence);
  /// All from `first` to `last` (at least `first`).
  void insert(std::uint64_t first, std::uint64_t last);
  [[nodiscard]] bool contains(std::uint64_t sequence) const;
  [[nodiscard]] const Ranges& ranges() const { return ranges_; }
  /// Closes the lowest gaps until at most so many ranges (at least 1) are left.
  void close_gaps(std::size_t most_ranges);

 private:
  Ranges ranges_;
};

}  // namespace tocsin::sample_log
