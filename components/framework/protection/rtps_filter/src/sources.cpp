// SPDX-License-Identifier: Apache-2.0
#include "sources.hpp"

#include <algorithm>

namespace tocsin::rtps_filter {

Sources::Account& Sources::account_of(Source from, Time now) {
  const std::uint64_t port = limits_.source_has_port ? from.port : 0;
  const std::uint64_t key = std::uint64_t{from.address} << 16U | port;
  const auto found = accounts_.find(key);
  if (found == accounts_.end() && accounts_.size() >= limits_.sources) {
    accounts_.erase(std::min_element(
        accounts_.begin(), accounts_.end(),
        [](const auto& one, const auto& other) { return one.second.heard < other.second.heard; }));
  }
  Account& account = found == accounts_.end() ? accounts_[key] : found->second;
  account.heard = now;
  return account;
}

Wrong Sources::packet(Source from, std::size_t bytes, Time now) {
  if (limits_.bytes.burst <= 0) return std::nullopt;
  if (!account_of(from, now).bytes.take(static_cast<double>(bytes), limits_.bytes, now)) {
    return DropReason::too_many_bytes;
  }
  return std::nullopt;
}

Wrong Sources::announcement(Source from, Time now) {
  if (!account_of(from, now).announcements.take(1, limits_.announcements, now)) {
    return DropReason::too_many_announcements;
  }
  return std::nullopt;
}

}  // namespace tocsin::rtps_filter
