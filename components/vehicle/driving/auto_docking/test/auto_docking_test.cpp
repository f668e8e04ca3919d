// SPDX-License-Identifier: Apache-2.0
#include "auto_docking/auto_docking.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "kobuki_protocol/dimensions.hpp"
#include "kobuki_protocol/odometry.hpp"

namespace tocsin {
namespace {

using kobuki::DockInfrared;

const Time t0 = Time{} + seconds(100);

struct Docking : ::testing::Test {
  void SetUp() override { sut.start(now); }
  geometry::Twist see(const DockInfrared& infrared, int bumper = 0, int charger = 0) {
    now += std::chrono::milliseconds(20);
    const DockingInput input{infrared, static_cast<std::uint8_t>(bumper),
                             static_cast<std::uint8_t>(charger), heading};
    return sut.update(input, now);
  }
  geometry::Twist see_often(const DockInfrared& infrared, int times) {
    geometry::Twist velocity;
    for (int i = 0; i < times; ++i) velocity = see(infrared);
    return velocity;
  }
  static DockInfrared centre(int bits) { return {0, static_cast<std::uint8_t>(bits), 0}; }
  /// The light passes the middle receiver between the headings -0.2 and 0.2.
  void sweep(int bits) {
    see_often({}, 20);
    for (heading = -0.2; heading < 0.201; heading += 0.05) see(centre(bits));
    see_often({}, 20);
  }
  /// It faces the dock at heading 0 and has seen the centre beam.
  void align(int bits) {
    sweep(bits);
    heading = 0.04;
    see(centre(bits));
    heading = 0;
    see(centre(bits));
  }

  AutoDocking sut{AutoDocking::Params{}};
  Time now = t0;
  double heading = -1;
};

TEST_F(Docking, FacesTheDockAfterItsLightHasPassed) {
  sweep(8);
  ASSERT_EQ(sut.state(), DockingState::face);
  EXPECT_EQ(see(centre(8)).angular_rad_s, -0.33);  // back, at heading 0.25
  heading = 0.036;                                 // 2 degrees are near enough
  see(centre(8));
  EXPECT_EQ(sut.state(), DockingState::face);
  heading = 0.034;
  see(centre(8));
  EXPECT_EQ(sut.state(), DockingState::aligned_far);
}

TEST_F(Docking, LooksAgainWhenItFacesNoLight) {
  sweep(8);
  heading = 0;
  see({});
  EXPECT_EQ(sut.state(), DockingState::scan);
}

// Speeds and sides are those of the reference's trace.
TEST_F(Docking, DrivesAlongTheBeam) {
  align(8);
  EXPECT_EQ(see(centre(8)).linear_mps, 0.1);
  EXPECT_EQ(sut.state(), DockingState::aligned_far);
  EXPECT_EQ(see(centre(10)).linear_mps, 0.05);
  EXPECT_EQ(sut.state(), DockingState::aligned_near);
}

TEST_F(Docking, LeansTowardsTheCentreLineByFifteenDegreesAtMost) {
  align(8);
  see_often({}, 19);
  EXPECT_EQ(see(centre(16)).angular_rad_s, 0.3);
  for (const auto& [bits, turn_rad_s] :
       {std::pair(32, -0.3), std::pair(1, 0.3), std::pair(4, -0.3), std::pair(7, 0.0)}) {
    see_often(centre(bits), 20);
    EXPECT_NEAR(see(centre(bits)).angular_rad_s, turn_rad_s, 1e-9) << bits;
  }
  see_often(centre(16), 20);
  heading = 15 * degree;
  EXPECT_NEAR(see(centre(16)).angular_rad_s, 0, 1e-9);
  heading = 16 * degree;
  EXPECT_LT(see(centre(16)).angular_rad_s, 0);
}

TEST_F(Docking, HoldsTheHeadingThatFacesTheDock) {
  align(8);
  heading = 0.1;
  EXPECT_NEAR(see(centre(8)).angular_rad_s, -0.2, 1e-9);
  heading = -0.5;
  EXPECT_EQ(see(centre(8)).angular_rad_s, 0.3);
}

TEST_F(Docking, RemembersLightForTwentyUpdates) {
  align(8);
  see_often({}, 19);
  EXPECT_EQ(sut.state(), DockingState::aligned_far);
  see({});
  EXPECT_EQ(sut.state(), DockingState::scan);
}

TEST_F(Docking, LooksFirstOnTheSideWhereTheLightWent) {
  align(8);
  see_often({}, 19);
  EXPECT_EQ(see({8, 0, 0}).angular_rad_s, -0.66);
  EXPECT_EQ(sut.state(), DockingState::scan);
}

TEST_F(Docking, IsDoneOnThe21stChargingUpdate) {
  align(2);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(see(centre(2), 0, 6).linear_mps, 0);
  EXPECT_EQ(sut.state(), DockingState::docked_in);
  see(centre(2), 0, 6);
  EXPECT_EQ(sut.state(), DockingState::done);
  EXPECT_EQ(sut.result(), DockingResult::docked);
  EXPECT_FALSE(sut.running());
}

TEST_F(Docking, BacksOffAnObstacleAndScansAgain) {
  align(8);
  EXPECT_EQ(see(centre(8), 2).linear_mps, -0.05);
  EXPECT_EQ(sut.state(), DockingState::bumped);
  for (int i = 0; i < 199; ++i) EXPECT_EQ(see(centre(8)).linear_mps, -0.05);
  see(centre(8));
  EXPECT_EQ(sut.state(), DockingState::scan);
}

TEST_F(Docking, ComesAnewWhenTheChargerIsLostForTheThirdTimeSinceItBackedOff) {
  const auto lose_charger = [this](int times) {
    align(2);
    for (int lost = 0; lost < times; ++lost) {
      see(centre(2), 0, 6);
      EXPECT_EQ(see(centre(2)).linear_mps, 0.05);  // the reference is stuck here for ever
      ASSERT_EQ(sut.state(), DockingState::aligned_near) << lost;
    }
  };
  lose_charger(2);
  see(centre(2), 2);  // bumped beside the contacts
  see_often(centre(2), 200);
  lose_charger(2);
  see(centre(2), 0, 6);
  EXPECT_EQ(see(centre(2)).linear_mps, -0.05);
  EXPECT_EQ(sut.state(), DockingState::bumped);
  see_often(centre(2), 200);
  EXPECT_EQ(sut.state(), DockingState::scan);
}

TEST_F(Docking, ReleasesTheBumperAtTheDock) {
  EXPECT_EQ(see(centre(2), 2, 6).linear_mps, -0.01);
  EXPECT_EQ(sut.state(), DockingState::bumped_dock);
}

/// Has swept the light of one side and turned to the heading that crosses the centre line.
struct Crossing : Docking {
  void cross(int bits, double at_rad) {
    sweep(bits);
    ASSERT_EQ(sut.state(), DockingState::find_stream);
    heading = at_rad;
    see({});
    ASSERT_EQ(sut.state(), DockingState::get_stream);
  }
};

TEST_F(Crossing, GoesAtSixtyDegreesToTheBearing) {
  sweep(16);  // on the dock's left: the line is on the left
  EXPECT_EQ(see({}).angular_rad_s, 0.33);
  heading = 57 * degree;
  EXPECT_GT(see({}).angular_rad_s, 0);
  EXPECT_EQ(sut.state(), DockingState::find_stream);
  heading = 59 * degree;
  EXPECT_EQ(see({16, 0, 0}).linear_mps, 0.1);  // the reference kicks with 0.5 m/s
  EXPECT_EQ(sut.state(), DockingState::get_stream);
}

TEST_F(Crossing, EndsWhenTheLightOfTheOtherSideComes) {
  cross(16, 60 * degree);
  EXPECT_GT(see({16, 0, 0}).linear_mps, 0);
  EXPECT_EQ(see({32, 0, 0}).angular_rad_s, -0.66);  // the dock is on the right hand
  EXPECT_EQ(sut.state(), DockingState::scan);
  sut.start(now);
  heading = -1;
  cross(4, -60 * degree);
  EXPECT_GT(see({0, 0, 4}).linear_mps, 0);
  EXPECT_EQ(see({0, 0, 2 | 1}).angular_rad_s, 0.66);
}

TEST_F(Crossing, EndsAfterTwoSecondsWithoutLight) {
  cross(16, 60 * degree);
  see({16, 0, 0});
  for (int i = 0; i < 19 + 100; ++i) EXPECT_GT(see({}).linear_mps, 0) << i;
  EXPECT_EQ(see({}).linear_mps, 0);
  EXPECT_EQ(sut.state(), DockingState::scan);
}

TEST_F(Docking, EndsWhenThereIsNoDock) {
  for (int i = 0; i < 2100 && sut.running(); ++i) {
    heading = geometry::wrap_angle(heading + 0.0132);
    EXPECT_EQ(see({}).linear_mps, 0);
  }
  EXPECT_EQ(sut.result(), DockingResult::no_dock_found);
  EXPECT_NEAR(to_seconds(now - t0), 40, 0.1);
}

TEST_F(Docking, EndsAtTheTimeout) {
  align(8);
  while (sut.running()) see(centre(8));
  EXPECT_EQ(sut.result(), DockingResult::timeout);
  EXPECT_NEAR(to_seconds(now - t0), 120, 0.1);
}

TEST_F(Docking, EndsWhenCancelledOrBlind) {
  sut.cancel();
  EXPECT_EQ(sut.result(), DockingResult::cancelled);
  EXPECT_EQ(see(centre(8)).linear_mps, 0);
  sut.start(now);
  see({});
  EXPECT_FALSE(sut.watch(now + seconds(0.5)));
  EXPECT_TRUE(sut.watch(now + seconds(0.501)));
  EXPECT_EQ(sut.result(), DockingResult::sensors_lost);
}

}  // namespace
}  // namespace tocsin
