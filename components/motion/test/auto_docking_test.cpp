// SPDX-License-Identifier: Apache-2.0
#include "motion/auto_docking.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kobuki_protocol/geometry.hpp"
#include "kobuki_protocol/odometry.hpp"

namespace tocsin::motion {
namespace {

using kobuki::DockInfrared;

const Time t0 = Time{} + seconds(100);

struct Docking : ::testing::Test {
  void SetUp() override { sut.start(now); }
  BodyVelocity see(const DockInfrared& infrared, int bumper = 0, int charger = 0) {
    now += std::chrono::milliseconds(20);
    const DockingInput input{infrared, static_cast<std::uint8_t>(bumper),
                             static_cast<std::uint8_t>(charger), heading};
    return sut.update(input, now);
  }
  BodyVelocity see_often(const DockInfrared& infrared, int times) {
    BodyVelocity velocity;
    for (int i = 0; i < times; ++i) velocity = see(infrared);
    return velocity;
  }
  static DockInfrared centre(int bits) { return {0, static_cast<std::uint8_t>(bits), 0}; }

  AutoDocking sut{AutoDocking::Params{}};
  Time now = t0;
  double heading = 0;
};

TEST_F(Docking, ScansByTurning) {
  const BodyVelocity velocity = see({});
  EXPECT_EQ(sut.state(), DockingState::scan);
  EXPECT_EQ(velocity.linear_mps, 0);
  EXPECT_EQ(velocity.angular_rad_s, 0.66);
}

// The rows of the reference's trace: far and near, straight, left and right.
TEST_F(Docking, DrivesAlongTheBeam) {
  EXPECT_EQ(see(centre(8)).linear_mps, 0.1);
  EXPECT_EQ(sut.state(), DockingState::aligned_far);
  EXPECT_EQ(see(centre(10)).linear_mps, 0.05);
  EXPECT_EQ(sut.state(), DockingState::aligned_near);
}

TEST_F(Docking, SteersTowardsTheCentreLine) {
  see(centre(8));
  see_often({}, 19);
  EXPECT_EQ(see(centre(16)).angular_rad_s, 0.3);
  see_often(centre(32), 20);
  EXPECT_EQ(see(centre(32)).angular_rad_s, -0.3);
  see_often(centre(1), 20);
  EXPECT_EQ(see(centre(1)).angular_rad_s, 0.1);
  see_often(centre(4), 20);
  EXPECT_EQ(see(centre(4)).angular_rad_s, -0.1);
  see_often(centre(7), 20);
  EXPECT_EQ(see(centre(7)).angular_rad_s, 0);
}

TEST_F(Docking, TurnsOnTheSpotWhenAskewOnTheCentreLine) {
  EXPECT_EQ(see({0, 8, 8}).linear_mps, 0);
  EXPECT_EQ(see({0, 8, 8}).angular_rad_s, 0.33);
  see_often(centre(8), 20);
  EXPECT_EQ(see({8, 8, 0}).angular_rad_s, -0.33);
  see_often(centre(8), 20);
  EXPECT_EQ(see(centre(8)).linear_mps, 0.1);
}

TEST_F(Docking, RemembersLightForTwentyUpdates) {
  see(centre(8));
  see_often({}, 19);
  EXPECT_EQ(sut.state(), DockingState::aligned_far);
  see({});
  EXPECT_EQ(sut.state(), DockingState::scan);
}

TEST_F(Docking, IsDoneOnThe21stChargingUpdate) {
  see(centre(2));
  for (int i = 0; i < 20; ++i) EXPECT_EQ(see(centre(2), 0, 6).linear_mps, 0);
  EXPECT_EQ(sut.state(), DockingState::docked_in);
  see(centre(2), 0, 6);
  EXPECT_EQ(sut.state(), DockingState::done);
  EXPECT_EQ(sut.result(), DockingResult::docked);
  EXPECT_FALSE(sut.running());
}

TEST_F(Docking, ContinuesWhenTheChargerIsLost) {
  see(centre(2));
  see(centre(2), 0, 6);
  see(centre(2));  // the reference is stuck here for ever
  EXPECT_EQ(sut.state(), DockingState::scan);
  see(centre(2));
  EXPECT_EQ(sut.state(), DockingState::aligned_near);
}

TEST_F(Docking, BacksOffAnObstacleAndScansAgain) {
  see(centre(8));
  EXPECT_EQ(see(centre(8), 2).linear_mps, -0.05);
  EXPECT_EQ(sut.state(), DockingState::bumped);
  for (int i = 0; i < 199; ++i) EXPECT_EQ(see(centre(8)).linear_mps, -0.05);
  see(centre(8));
  EXPECT_EQ(sut.state(), DockingState::scan);
}

TEST_F(Docking, ReleasesTheBumperAtTheDock) {
  EXPECT_EQ(see(centre(2), 2, 6).linear_mps, -0.01);
  EXPECT_EQ(sut.state(), DockingState::bumped_dock);
}

TEST_F(Docking, CrossesTheBeamFromTheSideItSaw) {
  see_often(centre(16), 5);  // dock seen from its left
  double greatest_mps = 0;
  for (int i = 0; i < 700 && sut.state() == DockingState::scan; ++i) {
    heading = kobuki::wrap_angle(heading + 0.0132);
    greatest_mps = std::max(greatest_mps, see({}).linear_mps);
  }
  ASSERT_EQ(sut.state(), DockingState::find_stream);
  EXPECT_EQ(see({}).angular_rad_s, 0.33);
  greatest_mps = std::max(greatest_mps, see({16, 0, 0}).linear_mps);
  EXPECT_EQ(sut.state(), DockingState::get_stream);
  greatest_mps = std::max(greatest_mps, see({32, 0, 0}).linear_mps);
  EXPECT_EQ(sut.state(), DockingState::scan);
  EXPECT_LE(greatest_mps, 0.1);  // the reference kicks with 0.5 m/s
}

TEST_F(Docking, EndsWhenThereIsNoDock) {
  for (int i = 0; i < 2100 && sut.running(); ++i) {
    heading = kobuki::wrap_angle(heading + 0.0132);
    EXPECT_EQ(see({}).linear_mps, 0);
  }
  EXPECT_EQ(sut.result(), DockingResult::no_dock_found);
  EXPECT_NEAR(to_seconds(now - t0), 40, 0.1);
}

TEST_F(Docking, EndsAtTheTimeout) {
  while (sut.running()) see(centre(8));
  EXPECT_EQ(sut.result(), DockingResult::timeout);
  EXPECT_NEAR(to_seconds(now - t0), 120, 0.1);
}

TEST_F(Docking, EndsWhenCancelledOrBlind) {
  sut.cancel();
  EXPECT_EQ(sut.result(), DockingResult::cancelled);
  EXPECT_EQ(see(centre(8)).linear_mps, 0);
  sut.start(now);
  EXPECT_FALSE(sut.watch(now + seconds(0.5)));
  EXPECT_TRUE(sut.watch(now + seconds(0.501)));
  EXPECT_EQ(sut.result(), DockingResult::sensors_lost);
}

TEST(DockingNames, AreAllDifferent) {
  EXPECT_STREQ(to_string(DockingState::scan), "scan");
  EXPECT_STREQ(to_string(DockingState::done), "done");
  EXPECT_STREQ(to_string(DockingResult::no_dock_found), "no_dock_found");
}

}  // namespace
}  // namespace tocsin::motion
