// SPDX-License-Identifier: Apache-2.0
#include "link_router/path_choice.hpp"

#include <algorithm>
#include <chrono>

namespace tocsin::router {
namespace {

/// What a lost transmission costs: the wait until its repair is there.
constexpr double loss_costs_s = 0.25;
/// The other path is better when it is by a third and by so much.
constexpr double better_ratio = 1.5;
constexpr double better_s = 0.02;
constexpr Duration worse_for = std::chrono::seconds(3);

/// [s] expected until a small sample is there.
double cost_s(const PathHealth& path) { return to_seconds(path.delay) + path.loss * loss_costs_s; }

bool is_better(const PathHealth& one, const PathHealth& other) {
  return cost_s(other) > std::max(better_ratio * cost_s(one), cost_s(one) + better_s);
}

}  // namespace

void PathChoice::update(const std::array<PathHealth, most_paths>& paths, Time now) {
  const PathHealth& chosen = paths[chosen_];
  const PathHealth& other = paths[other_path(chosen_)];
  const bool leave = chosen.is_silent && !other.is_silent;
  const bool is_worse = !other.is_silent && other.is_known && is_better(other, chosen);
  worse_since_ = is_worse ? std::min(worse_since_, now) : never;
  if (!leave && (!is_worse || now - worse_since_ < worse_for)) return;
  chosen_ = other_path(chosen_);
  worse_since_ = never;
}

}  // namespace tocsin::router
