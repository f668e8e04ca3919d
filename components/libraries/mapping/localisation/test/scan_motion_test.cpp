// SPDX-License-Identifier: Apache-2.0
#include "localisation/scan_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "foundation/numbers.hpp"
#include "laser_model/laser_model.hpp"

namespace tocsin::localisation {
namespace {

using geometry::Pose;
using geometry::Wall;

/// A vehicle that drives along a corridor 2 m wide, past boxes or past nothing.
struct Corridor {
  explicit Corridor(bool has_boxes) {
    if (!has_boxes) return;
    for (const double x_m : {-3.0, 1.5, 4.0}) obstacles.boxes.push_back({{x_m, 0.7, 0}, 0.4, 0.3});
  }
  ScanMotion::Step step(double way_m, double wheels_m) {
    truth = compose(truth, {way_m, 0, 0});
    const laser::Scene scene(walls, obstacles);
    const auto ranges_m = laser.turn(scene, 180, 0, [this](double) { return truth; });
    const laser::Scan scan = laser::make_scan(ranges_m, {{}, -pi, 2 * degree, 0, {}});
    const ScanMotion::Step step = sut.on_scan(scan.hits, {wheels_m, 0, 0});
    driven = compose(driven, step.step);
    decided += step.covariance ? 1 : 0;
    return step;
  }
  std::vector<Wall> walls{{-40, -1, 40, -1, 1}, {-40, 1, 40, 1, 1}};
  laser::Obstacles obstacles;
  laser::LaserModel laser{laser::find_laser_profile("rplidar_a2"), 1};
  Pose truth;
  Pose driven;
  int decided = 0;  ///< steps in which the scans did
  ScanMotion sut;
};

TEST(ScanMotion, FollowsTheWheelsWhileNothingContradictsThem) {
  Corridor corridor(true);
  for (int i = 0; i < 60; ++i) (void)corridor.step(0.05, 0.05 * (i % 2 == 0 ? 1.04 : 0.97));
  EXPECT_EQ(corridor.decided, 0);
  EXPECT_NEAR(corridor.driven.x_m, 0.05 * 60 * 1.005, 1e-9);
}

TEST(ScanMotion, SeesThatWheelsTurnInVainPastBoxesThatNoMapNeedsToHave) {
  Corridor corridor(true);
  for (int i = 0; i < 40; ++i) (void)corridor.step(0.02, 0.05);
  EXPECT_GT(corridor.decided, 20);
  EXPECT_NEAR(corridor.driven.x_m, 0.8, 0.15) << "the wheels say 2 m";
  for (int i = 0; i < 20; ++i) (void)corridor.step(0, 0.05);
  EXPECT_NEAR(corridor.driven.x_m, 0.8, 0.25);
}

TEST(ScanMotion, BelievesTheWheelsWhereASmoothWallIsAllThereIs) {
  Corridor corridor(false);
  for (int i = 0; i < 40; ++i) (void)corridor.step(0.05, 0.05);
  EXPECT_EQ(corridor.decided, 0);
  EXPECT_NEAR(corridor.driven.x_m, 2, 1e-9);
}

TEST(ScanMotion, SeesThatItStandsElsewhereAtOnce) {
  Corridor corridor(true);
  for (int i = 0; i < 10; ++i) EXPECT_GT(corridor.step(0.05, 0.05).seen_before, 0.8);
  corridor.truth = {-20, 0.2, 1.1};
  EXPECT_LT(corridor.step(0.05, 0.05).seen_before, 0.6);
  corridor.sut.begin_anew();
  EXPECT_EQ(corridor.step(0.05, 0.05).seen_before, 1) << "nothing to compare with";
}

TEST(ScanMotion, SomebodyWhoStandsCloseIsNoOtherPlace) {
  Corridor corridor(true);
  for (int i = 0; i < 10; ++i) (void)corridor.step(0.05, 0.05);
  const auto here = corridor.obstacles;
  for (const double bearing_rad : {0.0, 1.1, 2.2, 3.3, 4.4}) {
    corridor.obstacles.discs.push_back({{corridor.truth.x_m + 0.4 * std::cos(bearing_rad),
                                         corridor.truth.y_m + 0.4 * std::sin(bearing_rad)},
                                        0.2});
  }
  for (int i = 0; i < 10; ++i) EXPECT_EQ(corridor.step(0, 0).seen_before, 1);
  corridor.obstacles = here;
  for (int i = 0; i < 10; ++i) EXPECT_GT(corridor.step(0.05, 0.05).seen_before, 0.8);
}

TEST(ScanMotion, SaysNothingOfScansThatHaveHardlyAnyHits) {
  ScanMotion sut;
  const laser::Points few(19, {1, 1});
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(sut.on_scan(few, {0.3, 0, 0}).covariance);
  EXPECT_FALSE(sut.on_scan({}, {0.3, 0, 0}).covariance);
}

}  // namespace
}  // namespace tocsin::localisation
