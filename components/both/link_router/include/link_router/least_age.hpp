// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "link_router/link_estimator.hpp"

namespace tocsin::router {

/// How old what a peer's host sent is on arrival, over the least age seen lately, since clocks
/// differ.
///
/// The least age is a hint until traffic confirms it. It is forgotten when all that is received
/// seems old: eight arrivals of more than 2 s, or 1.2 s of arrivals of more than 0.25 s whose ages
/// are not halved, as those of a queue that drains would be. Arrivals within 50 ms count once: that
/// is what waited in the radio's queue while nothing was received. Pure; `now` never decreases.
class LeastAge {
 public:
  explicit LeastAge(Duration window) : least_(window) {}
  /// Age over the least one of a sample that was sent at `sent`, by its host's clock; at least
  /// zero.
  [[nodiscard]] Duration age(Time sent, Time now);
  /// Whether the least age was learned a while ago, so that the last age() says that much.
  [[nodiscard]] bool is_settled(Time now) const;

 private:
  /// Arrivals in a row that seem old.
  struct Aged {
    int late = 0;       ///< bursts
    int very_late = 0;  ///< of these in a row of more than 2 s
    Time since{};       ///< first arrival
    Time counted{};     ///< the last that counts
    Duration first{};   ///< age of the first
  };
  [[nodiscard]] bool is_refuted(Duration age, Time now);

  WindowedMinimum least_;
  Time begun_{};  ///< first arrival that counts
  Time heard_{};
  Aged aged_;
};

}  // namespace tocsin::router
