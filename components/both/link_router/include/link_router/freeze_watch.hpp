// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>

#include "foundation/time.hpp"

namespace tocsin::router {

/// Notices that the process of who asks it at each tick was frozen. Pure; `now` never decreases.
class FreezeWatch {
 public:
  /// A router that was not asked to do anything for so long was frozen.
  static constexpr Duration frozen_after = std::chrono::milliseconds(500);
  /// Whether it was, until `now`, or has only begun.
  [[nodiscard]] bool begins(Time now) {
    const bool is_new = !asked_ || now - *asked_ > frozen_after;
    asked_ = now;
    return is_new;
  }

 private:
  std::optional<Time> asked_;
};

}  // namespace tocsin::router
