// SPDX-License-Identifier: Apache-2.0
#include "rtps_filter/drop_account.hpp"

#include <numeric>

namespace tocsin::rtps_filter {

std::string to_text(std::uint32_t address) {
  return std::to_string(address >> 24U) + "." + std::to_string(address >> 16U & 0xFFU) + "." +
         std::to_string(address >> 8U & 0xFFU) + "." + std::to_string(address & 0xFFU);
}

void DropAccount::add(DropReason reason, std::uint32_t address) {
  const bool has_line = by_source_.size() < most_sources || by_source_.count(address) > 0;
  ++by_source_[has_line ? address : 0][static_cast<std::size_t>(reason)];
}

void DropAccount::add(const DropAccount& other) {
  for (const auto& [address, counts] : other.by_source_) {
    const bool has_line = by_source_.size() < most_sources || by_source_.count(address) > 0;
    ByReason& own = by_source_[has_line ? address : 0];
    for (std::size_t i = 0; i < counts.size(); ++i) own[i] += counts[i];
  }
}

DropAccount DropAccount::since(const DropAccount& before) const {
  DropAccount grown;
  for (const auto& [address, counts] : by_source_) {
    const auto earlier = before.by_source_.find(address);
    ByReason difference = counts;
    if (earlier != before.by_source_.end()) {
      for (std::size_t i = 0; i < counts.size(); ++i) difference[i] -= earlier->second[i];
    }
    if (difference != ByReason{}) grown.by_source_[address] = difference;
  }
  return grown;
}

std::uint64_t DropAccount::total() const {
  std::uint64_t sum = 0;
  for (const auto& [address, counts] : by_source_) {
    sum = std::accumulate(counts.begin(), counts.end(), sum);
  }
  return sum;
}

std::uint64_t DropAccount::count(DropReason reason) const {
  std::uint64_t sum = 0;
  for (const auto& [address, counts] : by_source_) sum += counts[static_cast<std::size_t>(reason)];
  return sum;
}

}  // namespace tocsin::rtps_filter
