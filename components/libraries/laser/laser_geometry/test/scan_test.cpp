// SPDX-License-Identifier: Apache-2.0
#include "laser_geometry/scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "foundation/numbers.hpp"

namespace tocsin::laser {
namespace {

TEST(MakeScan, TellsHitsFromMissesAndIgnoresTheRest) {
  ScanParams params;
  params.min_range_m = 0.1;
  params.used_range_m = 20;
  params.max_range_m = 40;
  params.cleared_m = 3;
  struct Row {
    double range_m;
    std::size_t hits;
    std::size_t misses;
  };
  for (const Row& row : {Row{0.1, 1, 0}, Row{0.099, 0, 0}, Row{20, 1, 0}, Row{20.001, 0, 0},
                         Row{39.999, 0, 0}, Row{40, 0, 1}, Row{infinity, 0, 1}, Row{nan, 0, 0}}) {
    const Scan scan = make_scan({row.range_m}, {}, params);
    EXPECT_EQ(scan.hits.size(), row.hits) << row.range_m;
    EXPECT_EQ(scan.misses.size(), row.misses) << row.range_m;
  }
}

TEST(MakeScan, TellsAnOpenDirectionFromABeamThatIsLost) {
  const Beams beams{{}, 0, 0.1};
  std::vector<double> ranges_m(20, 2);
  for (const std::size_t lost : {0, 5, 6, 7, 8, 19}) ranges_m[lost] = infinity;
  EXPECT_EQ(make_scan(ranges_m, beams).misses.size(), 6U);
  EXPECT_TRUE(make_scan(ranges_m, beams).open.empty());
  ranges_m[9] = infinity;
  const Scan scan = make_scan(ranges_m, beams);
  ASSERT_EQ(scan.open.size(), 5U);
  EXPECT_NEAR(geometry::bearing({}, scan.open.front()), 0.5, 1e-12);
  EXPECT_NEAR(geometry::bearing({}, scan.open.back()), 0.9, 1e-12);
  for (std::size_t i = 10; i < 20; ++i) ranges_m[i] = nan;
  EXPECT_EQ(make_scan(ranges_m, beams).open.size(), 5U) << "at the end of what is measured";
}

TEST(MakeScan, ClearsNothingWithoutReturnWhenItMayNot) {
  ScanParams params;
  params.cleared_m = 0;
  EXPECT_TRUE(make_scan({infinity}, {}, params).misses.empty());
}

TEST(MakeScan, PlacesBeamsFromWhereTheLaserSits) {
  const Scan scan = make_scan({2, 3}, {{0.5, 0, pi / 2}, -pi / 2, pi / 2});
  ASSERT_EQ(scan.hits.size(), 2U);
  EXPECT_DOUBLE_EQ(scan.laser.x_m, 0.5);
  EXPECT_NEAR(scan.hits[0].x_m, 2.5, 1e-12);
  EXPECT_NEAR(scan.hits[0].y_m, 0, 1e-12);
  EXPECT_NEAR(scan.hits[1].x_m, 0.5, 1e-12);
  EXPECT_NEAR(scan.hits[1].y_m, 3, 1e-12);
}

/// A vehicle that drives and turns sees a wall where it stands, not where the first beam would put
/// it.
TEST(MakeScan, UndoesTheMotionDuringTheTurn) {
  Beams beams;
  beams.increment_rad = pi / 2;
  beams.interval_s = 0.1;
  beams.velocity = {0.5, 0};
  const Scan ahead = make_scan({2, 2, 2}, beams);
  ASSERT_EQ(ahead.hits.size(), 3U);
  EXPECT_NEAR(ahead.hits[0].x_m, 2, 1e-12);
  EXPECT_NEAR(ahead.hits[1].x_m, 0.05, 1e-12);
  EXPECT_NEAR(ahead.hits[2].x_m, 0.1 - 2, 1e-12);
  beams.velocity = {0, pi};
  const Scan turning = make_scan({2, 2}, beams);
  ASSERT_EQ(turning.hits.size(), 2U);
  EXPECT_NEAR(geometry::bearing({}, turning.hits[1]), pi / 2 + 0.1 * pi, 1e-12);
}

TEST(Joined, FillsAStraightWallAndNothingElse) {
  const auto count = [](const Points& hits) { return joined(hits, 0.1).size(); };
  EXPECT_EQ(count({{0, 0}, {1, 0}, {2, 0}}), 21U);
  EXPECT_EQ(count({{0, 0}, {1, 0}, {2, 0.15}}), 22U);
  EXPECT_EQ(count({{0, 0}, {1, 0}, {1.5, 0.5}}), 3U);  // a corner
  EXPECT_EQ(count({{0, 0}, {1, 0}}), 2U);              // nothing says that it is a wall
  EXPECT_EQ(count({{0, 0}, {1.6, 0}, {3.2, 0}}), 3U);  // doors apart
  EXPECT_EQ(count({{0, 0}, {0.1, 0}, {0.2, 0}}), 3U);  // near enough
  EXPECT_EQ(count({}), 0U);
  const Points filled = joined({{0, 0}, {0.25, 0}, {0.5, 0}}, 0.1);
  ASSERT_EQ(filled.size(), 7U);
  EXPECT_NEAR(filled[1].x_m, 0.25 / 3, 1e-12);
}

TEST(Thinned, KeepsTheFirstPointOfEachSquareInTheirOrder) {
  const Points thin = thinned({{0.51, 0}, {-0.01, 0}, {0.55, 0.01}, {0.01, 0}, {0.09, 0.09}}, 0.1);
  ASSERT_EQ(thin.size(), 3U);
  EXPECT_DOUBLE_EQ(thin[0].x_m, 0.51);
  EXPECT_DOUBLE_EQ(thin[1].x_m, -0.01);
  EXPECT_DOUBLE_EQ(thin[2].x_m, 0.01);
}

Scan turn_of(double noise_m, unsigned seed, const geometry::Twist& velocity = {}) {
  std::mt19937 random(seed);
  std::normal_distribution<> noise(0, 1);
  std::vector<double> ranges_m;
  for (int i = 0; i < 180; ++i) ranges_m.push_back(2 + noise_m * noise(random));
  return make_scan(ranges_m, {{}, 0, degree, 0.001, velocity});
}

TEST(IsRepeated, TellsAScanThatIsSentAgainFromOneThatIsMeasuredAgain) {
  const Scan scan = turn_of(0.003, 1);
  EXPECT_TRUE(is_repeated(scan, scan));
  EXPECT_FALSE(is_repeated(scan, turn_of(0.003, 2)));
  Scan nearly = scan;
  std::fill_n(nearly.ranges_m.begin(), 10, std::numeric_limits<float>::quiet_NaN());
  nearly.ranges_m[40] += 0.01F;
  EXPECT_TRUE(is_repeated(scan, nearly)) << "a few readings are others";
  EXPECT_FALSE(is_repeated({}, {})) << "nothing is no sign";
  EXPECT_FALSE(is_repeated(scan, {}));
}

TEST(IsRepeated, SeesItThoughTheAnglesOfTheTurnsDiffer) {
  const Scan scan = turn_of(0.003, 1);
  Scan shifted = scan;
  for (std::size_t i = 1; i < 180; i += 3) shifted.ranges_m[i] = scan.ranges_m[i - 1];
  EXPECT_TRUE(is_repeated(scan, shifted));
}

TEST(IsRepeated, SeesItThoughTheVehicleMovesInAnotherWayMeanwhile) {
  EXPECT_TRUE(is_repeated(turn_of(0.003, 1, {0.1, 0}), turn_of(0.003, 1, {0.5, 0.3})));
}

}  // namespace
}  // namespace tocsin::laser
