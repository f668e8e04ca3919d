// SPDX-License-Identifier: Apache-2.0
#include "laser_model/simulated_laser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/numbers.hpp"
#include "rplidar_protocol/decoder.hpp"

namespace tocsin::laser {
namespace {

/// A vehicle that drives along x, its laser 0.1 m behind its middle; a wall at 5 m.
class SimulatedLaserTest : public ::testing::Test {
 protected:
  std::vector<rplidar::Reading> drive(double speed_mps, double turn_rad_s) {
    laser_.receive(view(scan_), now_);
    std::vector<rplidar::Reading> readings;
    pose_ = {};
    for (const Time end = now_ + seconds(2); now_ < end; now_ += std::chrono::milliseconds(20)) {
      pose_.x_m += speed_mps * 0.02;
      pose_.heading_rad += turn_rad_s * 0.02;
      laser_.step({pose_, {speed_mps, turn_rad_s}}, now_, [&](ByteView bytes) {
        decoder_.feed(bytes, [&](const rplidar::Answer& answer) {
          if (const auto* one = std::get_if<rplidar::Reading>(&answer)) readings.push_back(*one);
        });
      });
    }
    return readings;
  }
  static ByteView view(const rplidar::Bytes& bytes) { return {bytes.data(), bytes.size()}; }
  static LaserProfile clean() {
    LaserProfile profile = find_laser_profile("rplidar_a1");
    profile.noise_m = profile.noise_share = profile.missing_share = profile.mixed_share = 0;
    return profile;
  }

  const rplidar::Bytes scan_ = rplidar::request(rplidar::Command::scan);
  Time now_ = Time() + std::chrono::hours(1);
  geometry::Pose pose_;
  SimulatedLaser laser_{clean(),
                        std::make_shared<Scene>(std::vector<geometry::Wall>{{5, -50, 5, 50, 0}}),
                        {-0.1, 0, 0},
                        1,
                        now_};
  rplidar::Decoder decoder_;
};

TEST_F(SimulatedLaserTest, MeasuresFromWhereItIsMountedOnAMovingVehicle) {
  double before_m = infinity;
  int ahead = 0;
  for (const auto& one : drive(0.5, 0)) {
    if (std::abs(std::remainder(one.angle_rad, 2 * pi)) > 0.01) continue;
    ++ahead;
    EXPECT_LT(one.range_m, before_m);
    EXPECT_GT(one.range_m, 4.0);
    before_m = one.range_m;
  }
  EXPECT_GE(ahead, 3);
}

TEST_F(SimulatedLaserTest, CoveredItSeesWithItsRightHalfOnly) {
  laser_.cover(true);
  int right = 0;
  for (const auto& one : drive(0, 0)) {
    const double bearing_rad = std::remainder(-one.angle_rad, 2 * pi);
    if (bearing_rad > 0) {
      EXPECT_EQ(one.range_m, 0);
    } else if (bearing_rad > -1) {
      ++right;
      EXPECT_GT(one.range_m, 4);
    }
  }
  EXPECT_GT(right, 100);
}

TEST_F(SimulatedLaserTest, StuckItRepeatsItsLastTurnWhereverTheVehicleDrives) {
  const auto farthest_ahead = [this] {
    double farthest_m = 0;
    for (const auto& one : drive(0.5, 0)) {
      if (std::cos(one.angle_rad) > 0.99) farthest_m = std::max(farthest_m, one.range_m);
    }
    return farthest_m;
  };
  (void)farthest_ahead();  // its motor comes to speed
  EXPECT_GT(farthest_ahead(), 4.9);
  laser_.stick(true);
  EXPECT_LT(farthest_ahead(), 4.4) << "the wall was 4.1 m away in the end";
  laser_.stick(false);
  EXPECT_GT(farthest_ahead(), 4.9);
}

}  // namespace
}  // namespace tocsin::laser
