// SPDX-License-Identifier: Apache-2.0
#include "laser_model/laser_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::laser {
namespace {

/// Without noise, edges and missing readings.
LaserProfile clean() {
  LaserProfile profile = find_laser_profile("rplidar_a1");
  profile.noise_m = profile.noise_share = profile.missing_share = profile.mixed_share = 0;
  return profile;
}

Scene wall_at(double x_m) { return Scene({{x_m, -50, x_m, 50, 6.9}}); }

TEST(LaserModel, FollowsRep117AtTheEndsOfItsRange) {
  LaserModel sut(clean(), 1);
  EXPECT_NEAR(sut.range(wall_at(2), {}, 0), 2, 1e-3);
  EXPECT_NEAR(sut.range(wall_at(2), {1, 0, pi}, pi), 1, 1e-3) << "where the laser is and looks";
  EXPECT_EQ(sut.range(wall_at(0.14), {}, 0), -infinity);
  EXPECT_EQ(sut.range(wall_at(12.1), {}, 0), infinity);
  EXPECT_EQ(sut.range(wall_at(2), {}, pi), infinity);
}

TEST(LaserModel, SeesNothingOutsideOfItsView) {
  LaserProfile kinect = find_laser_profile("kinect");
  kinect.missing_share = 0;
  LaserModel sut(kinect, 1);
  const double half_rad = 28.5 * degree;
  for (const double bearing : {0.0, half_rad - 0.01, -half_rad + 0.01}) {
    EXPECT_TRUE(std::isfinite(sut.range(wall_at(2), {}, bearing))) << bearing;
  }
  for (const double bearing : {half_rad + 0.01, -half_rad - 0.01, pi}) {
    EXPECT_TRUE(std::isnan(sut.range(wall_at(2), {}, bearing))) << bearing;
  }
}

struct Spread {
  double mean = 0;
  double deviation = 0;
  double missing = 0;
};

Spread spread(const LaserProfile& profile, double range_m) {
  LaserModel sut(profile, 7);
  const Scene scene = wall_at(range_m);
  double sum = 0, squares = 0;
  int count = 0;
  constexpr int trials = 20000;
  for (int i = 0; i < trials; ++i) {
    const double measured = sut.range(scene, {}, 0);
    if (!std::isfinite(measured)) continue;
    ++count;
    sum += measured;
    squares += measured * measured;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean), 1 - static_cast<double>(count) / trials};
}

TEST(LaserModel, ErrsAsItsProfileSays) {
  for (const LaserProfile& profile : laser_profiles()) {
    for (const double range_m : {1.0, 8.0}) {
      const Spread found = spread(profile, range_m);
      const double wanted = profile.noise_m + profile.noise_share * range_m +
                            profile.noise_square_per_m * range_m * range_m;
      EXPECT_NEAR(found.mean, range_m, 0.001 * range_m) << profile.name;
      EXPECT_NEAR(found.deviation / wanted, 1, 0.05) << profile.name << range_m;
      EXPECT_NEAR(found.missing, profile.missing_share, 0.003) << profile.name;
    }
  }
}

TEST(LaserModel, MeasuresSomethingBetweenAtAnEdge) {
  LaserProfile profile = clean();
  profile.mixed_share = 0.5;
  LaserModel sut(profile, 3);
  // The beam ahead just passes a box; its edge is met.
  const Scene scene({{2, 0.001, 2, 1, 0}, {4, -5, 4, 5, 0}});
  int between = 0;
  for (int i = 0; i < 1000; ++i) {
    const double range_m = sut.range(scene, {}, 0);
    between += range_m > 2.1 && range_m < 3.9;
  }
  EXPECT_NEAR(between, 450, 60);
}

TEST(LaserModel, ATurnIsMadeWhileTheVehicleMoves) {
  LaserModel sut(clean(), 1);
  const auto ranges = sut.turn(wall_at(3), 360, 0.001, [](double s) {
    return geometry::Pose{s, 0, 0};  // 1 m/s towards the wall
  });
  ASSERT_EQ(ranges.size(), 360U);
  EXPECT_NEAR(ranges[180], 3 - 0.18, 1e-3) << "straight ahead, half a turn later";
  EXPECT_EQ(ranges[0], infinity) << "behind";
}

TEST(LaserModel, IsTheSameForTheSameSeed) {
  const auto look = [](std::uint64_t seed) {
    LaserModel sut(find_laser_profile("rplidar_a2"), seed);
    std::vector<double> ranges;
    for (int i = 0; i < 50; ++i) ranges.push_back(sut.range(wall_at(3), {}, 0.01 * i));
    return ranges;
  };
  EXPECT_EQ(look(1), look(1));
  EXPECT_NE(look(1), look(2));
}

TEST(LaserProfile, OfAnotherNameIsRefusedWithTheNamesThatAre) {
  try {
    (void)find_laser_profile("velodyne");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "laser profile 'velodyne' is not one of: rplidar_a1, rplidar_a2, kinect");
  }
}

}  // namespace
}  // namespace tocsin::laser
