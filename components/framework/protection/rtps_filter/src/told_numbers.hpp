// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "submessages.hpp"

namespace tocsin::rtps_filter {

/// Whom a HEARTBEAT is for.
struct Addressee {
  Prefix participant{};      ///< of the last INFO_DST before it; zeros: any
  std::uint32_t reader = 0;  ///< zero: all readers of the participant
  bool operator==(const Addressee& other) const {
    return reader == other.reader && participant == other.participant;
  }
};

/// Which numbers the readers of one writer have surely reached. All HEARTBEATs to one addressee are
/// heeded alike, or ignored alike, but for those whose count is not above all counts before.
class ToldNumbers {
 public:
  /// The first number that the addressee surely knows of; at least 1.
  [[nodiscard]] std::int64_t first(const Addressee& to) const {
    const auto found = std::find_if(reached_.begin(), reached_.end(),
                                    [&](const Reached& reached) { return reached.by == to; });
    return found == reached_.end() ? 1 : found->first;
  }
  void tell(const Addressee& to, std::int64_t first, std::uint32_t count) {
    constexpr std::size_t most_addressees = 16;  // the readers of a topic in one participant
    if (count <= count_) return;
    count_ = count;
    for (Reached& reached : reached_) {
      if (reached.by == to) return void(reached.first = std::max(reached.first, first));
    }
    if (reached_.size() < most_addressees) reached_.push_back({to, first});
  }

 private:
  struct Reached {
    Addressee by;
    std::int64_t first;
  };
  std::uint32_t count_ = 0;
  std::vector<Reached> reached_;
};

}  // namespace tocsin::rtps_filter
