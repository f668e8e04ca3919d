// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>

#include "rtps_filter/limits.hpp"
#include "rtps_filter/source.hpp"
#include "submessages.hpp"
#include "token_bucket.hpp"

namespace tocsin::rtps_filter {

/// How much each source has sent of late.
class Sources {
 public:
  /// `limits` must outlive it.
  explicit Sources(const Limits& limits) : limits_(limits) {}

  [[nodiscard]] Wrong packet(Source from, std::size_t bytes, Time now);
  [[nodiscard]] Wrong announcement(Source from, Time now);

 private:
  struct Account {
    Time heard{};
    TokenBucket bytes;
    TokenBucket announcements;
  };
  /// The account of a source; a new one takes the place of the one that was silent longest.
  Account& account_of(Source from, Time now);

  const Limits& limits_;
  std::unordered_map<std::uint64_t, Account> accounts_;
};

}  // namespace tocsin::rtps_filter
