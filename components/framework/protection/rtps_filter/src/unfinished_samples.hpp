// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "submessages.hpp"
#include "token_bucket.hpp"

namespace tocsin::rtps_filter {

/// How much memory samples take that have begun in fragments: each costs its bytes when it begins,
/// and gets them back as its fragments come.
class UnfinishedSamples {
 public:
  [[nodiscard]] Wrong add(const Prefix& prefix, const Data& data, const Rate& bytes, Time now) {
    const Sample sample{prefix, data.writer, data.number};
    if (std::find(begun_.begin(), begun_.end(), sample) == begun_.end()) {
      if (owed_.is_empty(bytes, now)) return DropReason::sample_size;
      owed_.spend(data.fragments.sample, bytes, now);
      begun_[next_++ % begun_.size()] = sample;
    }
    owed_.spend(-static_cast<double>(data.payload.left()), bytes, now);
    return std::nullopt;
  }

 private:
  struct Sample {
    Prefix prefix{};
    std::uint32_t writer = 0;
    std::int64_t number = 0;
    bool operator==(const Sample& other) const {
      return number == other.number && writer == other.writer && prefix == other.prefix;
    }
  };
  std::array<Sample, 64> begun_;  ///< the last ones
  std::size_t next_ = 0;
  TokenBucket owed_;
};

}  // namespace tocsin::rtps_filter
