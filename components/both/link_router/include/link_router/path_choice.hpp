// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "foundation/link_path.hpp"
#include "foundation/time.hpp"

namespace tocsin::router {

/// What is known of a path.
struct PathHealth {
  bool is_silent = false;  ///< nothing is acknowledged that was sent by it
  bool is_known = false;   ///< something was acknowledged, so that its delay is known
  double loss = 0;         ///< [0, 1] recent share of transmissions that were lost
  Duration delay{0};       ///< recent delay of small samples, over the least of both paths
};

/// A path whose loss is above this is poor: what uses both goes by both.
inline constexpr double poor_loss = 0.1;

/// Which of two paths is the better one. What is sent by a path takes its delay, and after a loss
/// the wait for a repair, too. A silent path is left at once, one that is only worse after it has
/// been so for 3 s, so that bulk does not go back and forth. Pure; `now` never decreases.
class PathChoice {
 public:
  void update(const std::array<PathHealth, most_paths>& paths, Time now);
  [[nodiscard]] PathIndex chosen() const { return chosen_; }

 private:
  PathIndex chosen_ = 0;
  Time worse_since_ = never;  ///< the chosen one is; `never`: it is not
};

}  // namespace tocsin::router
