// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "link_router/link_estimator.hpp"

namespace tocsin::router {

/// How old what a peer's host sent is on arrival, over the least age seen lately, since clocks
/// differ.
///
/// An age that is lesser by 100 ms or more is a hint until traffic confirms it: it counts when
/// three or more arrivals, at most 2 s apart, say so for a second and none agrees with the present
/// one. So a forged stamp of the future makes nothing old. Only in its first 2 s, when the least
/// age may have been learned in a queue, ages are over the hint. The least age ends when all that
/// is received contradicts it for as long as it was agreed with (for up to 2 s, if that was less
/// than 5 s), or in eight arrivals by more than 2 s: a clock was set. So what a forger has said for
/// some seconds lasts two, and a queue that stands stays old. Arrivals within 50 ms count once:
/// that is what waited in the radio's queue while nothing was received. Pure; `now` never
/// decreases.
class LeastAge {
 public:
  explicit LeastAge(Duration window) : least_(window) {}
  /// Age over the least one of a sample that was sent at `sent`, by its host's clock; at least
  /// zero.
  [[nodiscard]] Duration age(Time sent, Time now);
  /// Whether the least age was learned a while ago, so that the last age() says that much.
  [[nodiscard]] bool is_settled(Time now) const;

 private:
  /// Arrivals that agree with each other, or are all old.
  struct Row {
    int arrivals = 0;
    Time begun{};
    Time counted{};    ///< the last that counts
    Duration least{};  ///< of them
  };
  /// Whether so many have been received, 50 ms apart or more.
  [[nodiscard]] static bool count(Row& row, int wanted, Duration seen, Time now);
  void begin(Duration seen, Time since, Time now);
  void note(Duration seen, Time now);
  [[nodiscard]] Duration contradicted_after() const;

  WindowedMinimum least_;
  Time begun_{};       ///< first arrival that counts
  Duration hinted_{};  ///< the least since then, confirmed or not
  Time received_{};
  Time agreed_{};  ///< last arrival that agrees with it
  Row lesser_;     ///< than the least one
  Row contrary_;   ///< all older
  Row old_;        ///< more than 2 s
};

}  // namespace tocsin::router
