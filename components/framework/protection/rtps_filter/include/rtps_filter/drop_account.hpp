// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "rtps_filter/drop_reason.hpp"
#include "rtps_filter/source.hpp"

namespace tocsin::rtps_filter {

/// What was dropped, by reason and by the sender's address. Sums since the start.
class DropAccount {
 public:
  using ByReason = std::array<std::uint64_t, drop_reasons>;
  /// Addresses that have a line of their own; what others sent is counted under address 0.
  static constexpr std::size_t most_sources = 32;

  void add(DropReason reason, std::uint32_t address);
  void add(const DropAccount& other);
  /// What was added since `before`, an earlier state of this account.
  [[nodiscard]] DropAccount since(const DropAccount& before) const;
  [[nodiscard]] std::uint64_t total() const;
  [[nodiscard]] std::uint64_t count(DropReason reason) const;
  [[nodiscard]] const std::map<std::uint32_t, ByReason>& by_source() const { return by_source_; }

 private:
  std::map<std::uint32_t, ByReason> by_source_;
};

}  // namespace tocsin::rtps_filter
