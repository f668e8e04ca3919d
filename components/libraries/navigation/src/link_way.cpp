// SPDX-License-Identifier: Apache-2.0
#include "navigation/link_way.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tocsin::navigation {
namespace {

constexpr double worth_m = 0.5;                    // less silence is not worth another way
constexpr std::array weights{8.0, 4.0, 2.0, 1.0};  // [m of driving / m without link]

LinkWay way_of(geometry::Path path, const LinkRisk& risk) {
  const double long_m = length_m(path);
  const double silent_m = risk.silent_m(path);
  return {std::move(path), long_m, silent_m};
}

}  // namespace

WayChoice LinkWayChooser::choose(geometry::Path shortest, const CostMap& costs,
                                 const LinkRisk& risk) {
  const geometry::Point from = shortest.front();
  const geometry::Point to = shortest.back();
  LinkWay plain = way_of(std::move(shortest), risk);
  left_m_ = left_m_ ? *left_m_ - distance(asked_at_, from) : plain.length_m * (1 + most_detour_);
  asked_at_ = from;
  for (const double weight : weights) {
    if (plain.silent_m < worth_m) break;
    const auto dear = std::make_shared<const CostMap>(costs, risk, weight);
    auto path = Planner(dear).plan(from, to);
    if (!path) break;
    LinkWay way = way_of(std::move(*path), risk);
    if (way.length_m > std::max(*left_m_, plain.length_m)) continue;
    if (way.silent_m > plain.silent_m - worth_m) break;
    return {std::move(way), std::move(plain)};
  }
  LinkWay told{{}, plain.length_m, plain.silent_m};
  return {std::move(plain), std::move(told)};
}

}  // namespace tocsin::navigation
