// SPDX-License-Identifier: Apache-2.0
#include "navigation/link_way.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tocsin::navigation {
namespace {

constexpr double most_spare_m = 10;
constexpr double worth_m = 0.5;                    // less silence is not worth another way
constexpr std::array weights{8.0, 4.0, 2.0, 1.0};  // [m of driving / m without link]

LinkWay way_of(geometry::Path path, const LinkRisk& risk) {
  const double long_m = length_m(path);
  const double silent_m = risk.silent_m(path);
  return {std::move(path), long_m, silent_m};
}

}  // namespace

void LinkWayChooser::begin() {
  spare_m_ = saved_m_;
  left_m_.reset();
}

WayChoice LinkWayChooser::choose(geometry::Path shortest, const CostMap& costs,
                                 const LinkRisk& risk, const std::vector<float>& risks) {
  const geometry::Point from = shortest.front();
  LinkWay plain = way_of(std::move(shortest), risk);
  const bool is_first = !left_m_;
  const double allowed_m = plain.length_m * (1 + most_detour_) + spare_m_;
  left_m_ = is_first ? allowed_m : *left_m_ - distance(asked_at_, from);
  asked_at_ = from;
  auto way = better(plain, costs, risk, risks);
  const double length_m = way ? way->length_m : plain.length_m;
  if (is_first) saved_m_ = std::clamp(allowed_m - length_m, 0.0, most_spare_m);
  if (way) return {std::move(*way), std::move(plain)};
  LinkWay told{{}, plain.length_m, plain.silent_m};
  return {std::move(plain), std::move(told)};
}

std::optional<LinkWay> LinkWayChooser::better(const LinkWay& plain, const CostMap& costs,
                                              const LinkRisk& risk,
                                              const std::vector<float>& risks) const {
  for (const double weight : weights) {
    if (plain.silent_m < worth_m) break;
    const auto dear = std::make_shared<const CostMap>(costs, risks, weight);
    auto path = Planner(dear).plan(plain.path.front(), plain.path.back());
    if (!path) break;
    LinkWay way = way_of(std::move(*path), risk);
    if (way.length_m > std::max(*left_m_, plain.length_m)) continue;
    if (way.silent_m > plain.silent_m - worth_m) break;
    return way;
  }
  return std::nullopt;
}

}  // namespace tocsin::navigation
