// SPDX-License-Identifier: Apache-2.0
#include "navigation/waypoint_order.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "geometry/pose.hpp"

namespace tocsin::navigation {
namespace {

using ::testing::ElementsAre;

/// Straight ways; the link is lost where both ends are above y = 5.
Legs legs_of(const std::vector<geometry::Point>& places) {
  Legs legs(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (const geometry::Point& to : places) {
      const double length_m = distance(places[i], to);
      legs[i].push_back({length_m, places[i].y_m > 5 && to.y_m > 5 ? length_m : 0});
    }
  }
  return legs;
}

/// The shortest of all orders that keep the ends.
double shortest_m(const Legs& legs) {
  std::vector<std::size_t> order(legs.size());
  std::iota(order.begin(), order.end(), 0U);
  double best_m = infinity;
  do {
    best_m = std::min(best_m, along(legs, order).way.length_m);
  } while (std::next_permutation(order.begin() + 1, order.end() - 1));
  return best_m;
}

TEST(WaypointOrder, KeepsTheEndsAndVisitsTheOthersOnTheShortestWay) {
  const auto found = ordered(legs_of({{0, 0}, {3, 0}, {1, 0}, {2, 0}, {4, 0}}), 0);
  EXPECT_THAT(found.places, ElementsAre(0, 2, 3, 1, 4));
  EXPECT_DOUBLE_EQ(found.way.length_m, 4);
}

TEST(WaypointOrder, FindsTheShortestOfAllOrdersNearlyAlways) {
  std::mt19937 random(1);
  int best = 0;
  for (int i = 0; i < 50; ++i) {
    std::vector<geometry::Point> places;
    for (int k = 0; k < 8; ++k) places.push_back({double(random() % 100), double(random() % 100)});
    const Legs legs = legs_of(places);
    const double found_m = ordered(legs, 0).way.length_m;
    EXPECT_LE(found_m, 1.1 * shortest_m(legs));
    if (found_m <= shortest_m(legs) + 1e-9) ++best;
  }
  EXPECT_GE(best, 45);
}

TEST(WaypointOrder, DrivesLongerToKeepTheLinkAsFarAsItMay) {
  // Along y = 6 it is shortest, and without link.
  const Legs legs = legs_of({{0, 0}, {0, 6}, {4, 6}, {4, 0}, {8, 0}});
  const auto shortest = ordered(legs, 0);
  EXPECT_GT(shortest.way.silent_m, 0);
  const auto heard = ordered(legs, 0.5);
  EXPECT_EQ(heard.way.silent_m, 0);
  EXPECT_LE(heard.way.length_m, 1.5 * shortest.way.length_m);
}

TEST(WaypointOrder, FewPlacesStayAsTheyAre) {
  EXPECT_THAT(ordered(legs_of({{0, 0}}), 0).places, ElementsAre(0));
  EXPECT_THAT(ordered(legs_of({{0, 0}, {1, 0}}), 0).places, ElementsAre(0, 1));
  EXPECT_THAT(ordered(legs_of({{0, 0}, {1, 0}, {0, 0}}), 0).places, ElementsAre(0, 1, 2));
}

}  // namespace
}  // namespace tocsin::navigation
