// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>

namespace tocsin {

/// Tells the samples that came before from new ones, by their writer and number. A router that was
/// restarted gives its host the last sample of a state again; its readers have that already.
///
/// It remembers 64 numbers of each writer, as the anti-replay window of IPsec does (RFC 4303,
/// section 3.4.3); what is older than these counts as seen. One thread.
class ReplayFilter {
 public:
  /// Whether this one comes for the first time, which is remembered.
  [[nodiscard]] bool is_first(std::uint64_t source, std::uint64_t sequence) {
    const auto [place, is_new] = seen_.try_emplace(source, Seen{sequence, 1});
    if (is_new) return true;
    Seen& seen = place->second;
    if (sequence > seen.highest) {
      const std::uint64_t step = sequence - seen.highest;
      seen.window = (step < window ? seen.window << step : 0) | 1U;
      seen.highest = sequence;
      return true;
    }
    const std::uint64_t back = seen.highest - sequence;
    if (back >= window || (seen.window >> back & 1U) != 0) return false;
    seen.window |= std::uint64_t{1} << back;
    return true;
  }
  void forget(std::uint64_t source) { seen_.erase(source); }

 private:
  static constexpr std::uint64_t window = 64;
  struct Seen {
    std::uint64_t highest;
    std::uint64_t window;  ///< bit i: highest - i was seen
  };
  std::map<std::uint64_t, Seen> seen_;
};

}  // namespace tocsin
