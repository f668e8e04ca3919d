// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "foundation/time.hpp"

namespace tocsin {

/// Sums over the ticks of one component since its start.
struct TickFigures {
  /// Ticks by duration: the last index i with 2^i ns not above it.
  using Buckets = std::array<std::uint64_t, 40>;

  std::uint64_t ticks = 0;
  Duration total{0};
  Duration longest{0};  ///< since the last reading
  Buckets buckets{};
  std::optional<Time> running_since;  ///< a tick that has not ended
  std::optional<std::string> error;   ///< what the component threw

  /// An upper bound, at most twice too large, of the duration that the share `p` of the ticks since
  /// `earlier` stayed below. Zero when there were none.
  [[nodiscard]] Duration quantile(double p, const TickFigures& earlier) const;
};

/// What the ticks of one component cost. One thread writes, one other may read; a tick costs
/// no locked instruction.
class TickAccount {
 public:
  void begin(Time now) { began_.store(now.time_since_epoch().count(), relaxed); }
  void end(Time began, Time ended);
  /// The component threw; it is ticked no more.
  void fail(const std::string& error);
  [[nodiscard]] bool failed() const { return failed_.load(std::memory_order_acquire); }
  [[nodiscard]] TickFigures read();

 private:
  static constexpr auto relaxed = std::memory_order_relaxed;
  using Counter = std::atomic<std::uint64_t>;
  std::atomic<std::int64_t> began_{0};  // 0: between ticks
  Counter ticks_{0};
  std::atomic<std::int64_t> total_{0};
  std::atomic<std::int64_t> longest_{0};
  std::array<Counter, std::tuple_size_v<TickFigures::Buckets>> buckets_{};
  std::atomic<bool> failed_{false};
  std::mutex error_mutex_;
  std::string error_;
};

}  // namespace tocsin
