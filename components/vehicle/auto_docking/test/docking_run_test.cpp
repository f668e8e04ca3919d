// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdio>
#include <ostream>

#include "docking_rig.hpp"

namespace tocsin {
namespace {

using geometry::Pose;
using kobuki::degree_rad;

constexpr std::uint64_t seed = 1;

std::string text_of(const geometry::Pose& pose) {
  char text[80];
  std::snprintf(text, sizeof text, "from %.4f,%.4f,%.4f, seed %d", pose.x_m, pose.y_m,
                pose.heading_rad, static_cast<int>(seed));
  return text;
}

TEST(DockingRun, ArrivesFromEveryPartOfTheField) {
  for (const double x_m : {0.6, 1.2, 2.0}) {
    for (const double angle_deg : {0.0, 20.0, -20.0, 40.0, -40.0}) {
      for (const double yaw : {0.0, 2.0, -2.5}) {
        const geometry::Pose start{x_m, x_m * std::tan(angle_deg * degree_rad), yaw};
        const DockingRig::End run = DockingRig{}.dock_from(start);
        EXPECT_EQ(run.result, DockingResult::docked) << to_string(run.result) << text_of(start);
        EXPECT_EQ(run.source, kobuki::ChargingSource::dock);
      }
    }
  }
}

// In the map of bringup/dock.yaml they are 1.64,-0.32,2.2816 and 2.12,-0.30,0.5216.
TEST(DockingRun, ArrivesFromWhereItDroveOnWithoutLight) {
  for (const geometry::Pose& start :
       {geometry::Pose{0.86, 0.32, -0.86}, geometry::Pose{0.38, 0.30, -2.62}}) {
    const DockingRig::End run = DockingRig{}.dock_from(start);
    EXPECT_EQ(run.result, DockingResult::docked) << to_string(run.result) << text_of(start);
  }
}

// test/docking does the same with the whole stack, from 300 starts.
TEST(DockingRun, ArrivesFromRandomStartsWithLittleDrivingWithoutLight) {
  std::mt19937_64 random(seed);
  DockingRig rig;
  for (rig.seed = 1; rig.seed <= 60; ++rig.seed) {
    const geometry::Pose start = draw_start(random);
    const DockingRig::End run = rig.dock_from(start);
    EXPECT_EQ(run.result, DockingResult::docked) << to_string(run.result) << text_of(start);
    // 2 s at 0.1 m/s, and what the window of 0.4 s and the dead time add
    EXPECT_LT(run.dark_way_m, 0.27) << text_of(start);
  }
}

TEST(DockingRun, ComesAnewWhenTheContactsMeetOnlyAtTheirEdge) {
  const DockingRig::End run = DockingRig{}.dock_from({0.368, -0.172, 2.554});
  EXPECT_EQ(run.result, DockingResult::docked) << to_string(run.result);
  EXPECT_LT(run.duration_s, 70);
}

int count_docked_nearby(int starts, double command_delay_s) {
  std::mt19937_64 random(seed);
  DockingRig rig;
  rig.base.command_delay_s = command_delay_s;
  int docked = 0;
  for (int i = 0; i < starts; ++i, ++rig.seed) {
    const DockingRig::End run = rig.dock_from(draw_start(random, {0.3, 0.6}));
    docked += run.result == DockingResult::docked ? 1 : 0;
  }
  return docked;
}

TEST(DockingRun, ArrivesFromRandomStartsNearTheDock) {
  EXPECT_EQ(count_docked_nearby(300, 0.1), 300);
  EXPECT_EQ(count_docked_nearby(40, 0.3), 40) << "commands take long";
}

/// A dock and receivers as they may well be in truth.
kobuki::DockLight draw_light(std::mt19937_64& random) {
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  kobuki::DockLight light;
  light.far_m = uniform(3, 6);
  light.near_m = uniform(0.5, 2.5);
  light.centre_half_width_m = uniform(0.04, 0.12);
  light.overlap_m = uniform(-0.02, 0.04);
  light.rim_m = uniform(0.1, 0.178);
  light.receiver_rad = uniform(45, 80) * degree_rad;
  light.middle_view_rad = uniform(15, 60) * degree_rad;
  light.side_view_rad = uniform(25, 60) * degree_rad;
  return light;
}

TEST(DockingRun, DoesNotRestOnTheEstimatesOfTheDock) {
  std::mt19937_64 random(seed);
  DockingRig rig;
  for (rig.seed = 1; rig.seed <= 60; ++rig.seed) {
    rig.light = draw_light(random);
    const geometry::Pose start = draw_start(random);
    const DockingRig::End run = rig.dock_from(start);
    EXPECT_EQ(run.result, DockingResult::docked) << to_string(run.result) << text_of(start);
  }
}

TEST(DockingRun, ArrivesThoughReceiversMissHalfOfTheSignals) {
  std::mt19937_64 random(seed);
  DockingRig rig;
  rig.base.infrared_loss = 0.5;
  rig.base.command_delay_s = 0.2;
  for (rig.seed = 1; rig.seed <= 30; ++rig.seed) {
    const geometry::Pose start = draw_start(random);
    const DockingRig::End run = rig.dock_from(start);
    EXPECT_EQ(run.result, DockingResult::docked) << to_string(run.result) << text_of(start);
  }
}

TEST(DockingRun, EndsOutsideTheField) {
  const DockingRig::End run = DockingRig{}.dock_from({6, 0, 0});
  EXPECT_EQ(run.result, DockingResult::no_dock_found);
  EXPECT_NEAR(run.duration_s, 40, 0.2);
  EXPECT_LT(run.dark_way_m, 0.02);
}

}  // namespace
}  // namespace tocsin
