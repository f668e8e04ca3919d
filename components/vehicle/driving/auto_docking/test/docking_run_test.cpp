// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdio>
#include <utility>

#include "docking_rig.hpp"

namespace tocsin {
namespace {

using geometry::Pose;

constexpr std::uint64_t seed = 1;

std::string text_of(const geometry::Pose& pose) {
  char text[80];
  std::snprintf(text, sizeof text, "from %.4f,%.4f,%.4f, seed %d", pose.x_m, pose.y_m,
                pose.heading_rad, static_cast<int>(seed));
  return text;
}

DockingRig::End expect_docked(const DockingRig& rig, const geometry::Pose& start) {
  const DockingRig::End run = rig.dock_from(start);
  EXPECT_EQ(run.result, DockingResult::docked) << to_string(run.result) << text_of(start);
  return run;
}

TEST(DockingRun, ArrivesFromEveryPartOfTheField) {
  for (const double x_m : {0.6, 1.2, 2.0}) {
    for (const double angle_deg : {0.0, 20.0, -20.0, 40.0, -40.0}) {
      for (const double yaw : {0.0, 2.0, -2.5}) {
        const double y_m = x_m * std::tan(angle_deg * degree);
        EXPECT_EQ(expect_docked({}, {x_m, y_m, yaw}).source, kobuki::ChargingSource::dock);
      }
    }
  }
}

// In the map of bringup/dock.yaml they are 1.64,-0.32,2.2816 and 2.12,-0.30,0.5216.
TEST(DockingRun, ArrivesFromWhereItDroveOnWithoutLight) {
  expect_docked({}, {0.86, 0.32, -0.86});
  expect_docked({}, {0.38, 0.30, -2.62});
}

// test/docking does the same with the whole stack, from 300 starts.
TEST(DockingRun, ArrivesFromRandomStartsWithLittleDrivingWithoutLight) {
  std::mt19937_64 random(seed);
  DockingRig rig;
  for (rig.seed = 1; rig.seed <= 60; ++rig.seed) {
    // 2 s at 0.1 m/s, and what the window of 0.4 s and the dead time add
    EXPECT_LT(expect_docked(rig, draw_start(random)).dark_way_m, 0.27) << rig.seed;
  }
}

TEST(DockingRun, ComesAnewWhenTheContactsMeetOnlyAtTheirEdge) {
  EXPECT_LT(expect_docked({}, {0.368, -0.172, 2.554}).duration_s, 70);
}

TEST(DockingRun, ArrivesFromRandomStartsNearTheDockAlsoWhenCommandsTakeLong) {
  for (const auto& [starts, command_delay_s] : {std::pair(300U, 0.1), std::pair(40U, 0.3)}) {
    std::mt19937_64 random(seed);
    DockingRig rig;
    rig.base.command_delay_s = command_delay_s;
    for (rig.seed = 1; rig.seed <= starts; ++rig.seed) {
      expect_docked(rig, draw_start(random, {0.3, 0.6}));
    }
  }
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
  light.receiver_rad = uniform(45, 80) * degree;
  light.middle_view_rad = uniform(15, 60) * degree;
  light.side_view_rad = uniform(25, 60) * degree;
  return light;
}

TEST(DockingRun, DoesNotRestOnTheEstimatesOfTheDock) {
  std::mt19937_64 random(seed);
  DockingRig rig;
  for (rig.seed = 1; rig.seed <= 60; ++rig.seed) {
    rig.light = draw_light(random);
    expect_docked(rig, draw_start(random));
  }
}

TEST(DockingRun, ArrivesThoughReceiversMissHalfOfTheSignals) {
  std::mt19937_64 random(seed);
  DockingRig rig;
  rig.base.infrared_loss = 0.5;
  rig.base.command_delay_s = 0.2;
  for (rig.seed = 1; rig.seed <= 30; ++rig.seed) expect_docked(rig, draw_start(random));
}

TEST(DockingRun, EndsOutsideTheField) {
  const DockingRig::End run = DockingRig{}.dock_from({6, 0, 0});
  EXPECT_EQ(run.result, DockingResult::no_dock_found);
  EXPECT_NEAR(run.duration_s, 40, 0.2);
  EXPECT_LT(run.dark_way_m, 0.02);
}

}  // namespace
}  // namespace tocsin
