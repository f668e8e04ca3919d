// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "foundation/time.hpp"

namespace tocsin {

/// Tells whether a command from another computer is still fresh, though the clocks differ.
///
/// The delay of a command is its receiver's clock minus its sender's. How much of that is the
/// clocks' difference is not known, but the quickest command of the last half to one minute had
/// almost nothing else: what took `lifespan` longer than that one is late. The first command of a
/// session passes. Pure; wall times in nanoseconds.
class CommandLateness {
 public:
  explicit CommandLateness(Duration lifespan) : lifespan_ns_(lifespan.count()) {}
  /// Takes a command and says whether it may still be followed.
  [[nodiscard]] bool is_fresh(std::int64_t sent_ns, std::int64_t received_ns);

 private:
  static constexpr std::int64_t window_ns = 30'000'000'000;
  static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  std::int64_t lifespan_ns_;
  std::int64_t quickest_ns_ = none;         ///< of the window that runs
  std::int64_t quickest_before_ns_ = none;  ///< of the one before
  std::int64_t window_end_ns_ = std::numeric_limits<std::int64_t>::min();
};

}  // namespace tocsin
