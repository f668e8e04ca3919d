// SPDX-License-Identifier: Apache-2.0
#include "rplidar_driver/turn_builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::rplidar {
namespace {

constexpr Time start = Time() + std::chrono::hours(1);

/// Readings every degree, a millisecond apart, from clockwise `first_deg` on; their range by angle.
template <class Range>
std::vector<Turn> turns_of(TurnBuilder& sut, double first_deg, int count, const Range& range) {
  std::vector<Turn> turns;
  for (int i = 0; i < count; ++i) {
    const double deg = std::fmod(first_deg + i, 360);
    const auto turn = sut.on_reading({deg * degree, range(deg), 47, deg == 0},
                                     start + i * std::chrono::milliseconds(1));
    if (turn) turns.push_back(*turn);
  }
  return turns;
}

double angle_m(double deg) { return 1 + deg / 100; }

TEST(TurnBuilder, TurnsClockwiseReadingsRound) {
  TurnBuilder sut({});
  const auto turns = turns_of(sut, 0, 900, angle_m);
  ASSERT_EQ(turns.size(), 1U) << "cut behind: from 180 to 540 degrees";
  ASSERT_EQ(turns[0].ranges_m.size(), 360U);
  // Beam i lies at -180 + i degrees to the left; clockwise that is 180 - i.
  for (const auto& [beam, deg] : {std::pair{180, 0}, {181, 359}, {90, 90}, {270, 270}, {0, 180}}) {
    EXPECT_NEAR(turns[0].ranges_m[static_cast<std::size_t>(beam)], angle_m(deg), 1e-6) << beam;
  }
}

TEST(TurnBuilder, TellsWhenEachBeamWasMeasured) {
  TurnBuilder sut({});
  const auto turn = turns_of(sut, 0, 900, angle_m).at(0);
  EXPECT_NEAR(turn.period_s, 0.36, 1e-9);
  EXPECT_NEAR(turn.interval_s, -0.001, 1e-9);
  // Ahead, 0 degrees, was measured 180 ms after the cut at reading 180.
  const Time ahead = turn.first + seconds(180 * turn.interval_s);
  EXPECT_NEAR(to_seconds(ahead - start), 0.36, 1e-6);
}

TEST(TurnBuilder, UpsideDownItTurnsTheOtherWay) {
  TurnParams params;
  params.inverted = true;
  TurnBuilder sut(params);
  const auto turn = turns_of(sut, 0, 900, angle_m).at(0);
  EXPECT_NEAR(turn.ranges_m[181], angle_m(1), 1e-6);
  EXPECT_GT(turn.interval_s, 0);
  const Time ahead = turn.first + seconds(180 * turn.interval_s);
  EXPECT_NEAR(to_seconds(ahead - start), 0.36, 1e-6);
}

TEST(TurnBuilder, FollowsRep117) {
  TurnBuilder sut({});
  const auto turn = turns_of(sut, 0, 900, [](double deg) {
                      return deg == 10 ? 0.0 : deg == 20 ? 0.1 : deg == 30 ? 12.5 : 3.0;
                    }).at(0);
  EXPECT_EQ(turn.ranges_m[170], infinity) << "no return";
  EXPECT_EQ(turn.ranges_m[160], -infinity) << "too near";
  EXPECT_EQ(turn.ranges_m[150], infinity) << "too far";
  EXPECT_EQ(turn.ranges_m[140], 3.0F);
}

TEST(TurnBuilder, OfTwoReadingsTheNearerCountsAndABeamWithoutOneIsNan) {
  TurnParams params;
  params.beams = 720;
  TurnBuilder fine(params);
  const auto turn = turns_of(fine, 0, 900, angle_m).at(0);
  int unseen = 0;
  for (const float range : turn.ranges_m) unseen += std::isnan(range) ? 1 : 0;
  EXPECT_EQ(unseen, 360);
  params.beams = 180;
  TurnBuilder coarse(params);
  const auto pairs = turns_of(coarse, 0.25, 900, angle_m).at(0);
  EXPECT_NEAR(pairs.ranges_m[45], angle_m(89.25), 1e-6) << "of 89.25 and 90.25 degrees";
}

TEST(TurnBuilder, CutsToAFieldOfView) {
  TurnParams params;
  params.angle_min_deg = -28.5;
  params.angle_max_deg = 28.5;
  TurnBuilder sut(params);
  EXPECT_EQ(sut.beams(), 58U);
  const auto turn = turns_of(sut, 0.25, 900, angle_m).at(0);
  ASSERT_EQ(turn.ranges_m.size(), 58U);
  for (const float range : turn.ranges_m) EXPECT_FALSE(std::isnan(range));
}

TEST(TurnBuilder, ATurnThatTookTooLongIsNone) {
  TurnBuilder sut({});
  Time at = start;
  int turns = 0;
  for (int i = 0; i < 1200; ++i, at += std::chrono::milliseconds(i == 300 ? 3000 : 1)) {
    turns += sut.on_reading({std::fmod(i, 360) * degree, 1, 47, false}, at) ? 1 : 0;
  }
  EXPECT_EQ(turns, 1) << "of two";
}

TEST(TurnBuilder, RefusesAViewOrARangeOfNothing) {
  TurnParams view;
  view.angle_min_deg = 10;
  view.angle_max_deg = 10;
  EXPECT_THROW(TurnBuilder{view}, ConfigError);
  TurnParams range;
  range.range_min_m = 5;
  range.range_max_m = 5;
  EXPECT_THROW(TurnBuilder{range}, ConfigError);
}

}  // namespace
}  // namespace tocsin::rplidar
