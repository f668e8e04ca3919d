// SPDX-License-Identifier: Apache-2.0
#include "explorer/exploration_drive.hpp"

#include <gtest/gtest.h>

#include "foundation/numbers.hpp"

namespace tocsin {
namespace {

using navigation::Cell;

const Time t0{std::chrono::hours(1)};

/// A floor of 4 m by 2 m of which the left `known_m` are known.
navigation::OccupancyMap floor_known_to(double known_m) {
  const navigation::Grid grid{40, 20, 0.1, {0, 0}};
  std::vector<Cell> cells;
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 40; ++column) {
      const bool is_wall = row == 0 || row == 19 || column == 0 || column == 39;
      const bool is_known = column < static_cast<int>(known_m * 10);
      cells.push_back(!is_known ? Cell::unknown : is_wall ? Cell::occupied : Cell::free);
    }
  }
  return {grid, cells};
}

class ExplorationDriveTest : public ::testing::Test {
 protected:
  ExplorationDriveTest() {
    sut.on_map(floor_known_to(2));
    sut.on_navigator(true);
    at(0);
  }
  Time at(double s, double aside_m = 0) {
    const Time now = t0 + seconds(s);
    sut.on_pose({0.6, 1 + aside_m, 0}, now);
    return now;
  }
  ExplorationDrive sut{{}};
};

TEST_F(ExplorationDriveTest, DrivesToTheEndOfTheMapUntilItIsKnown) {
  EXPECT_EQ(sut.status(), "idle");
  EXPECT_FALSE(sut.update(t0).drive_to);
  sut.start();
  const auto order = sut.update(t0);
  ASSERT_TRUE(order.drive_to);
  EXPECT_NEAR(order.drive_to->x_m, 1.95, 1e-9);
  EXPECT_NEAR(order.drive_to->heading_rad, 0, 0.1) << "looks to where it drives";
  EXPECT_EQ(sut.status().find("exploring: to (1.95, "), 0U) << sut.status();
  sut.on_map(floor_known_to(4));
  EXPECT_FALSE(sut.update(at(1)).cancel);
  EXPECT_EQ(sut.status(), "waiting: it looks whether that was all");
  EXPECT_FALSE(sut.update(at(2)).cancel);
  const auto last = sut.update(at(3));
  EXPECT_TRUE(last.cancel);
  EXPECT_FALSE(last.drive_to);
  EXPECT_EQ(sut.status(), "done: all that can be reached is known");
  EXPECT_FALSE(sut.is_running());
}

TEST_F(ExplorationDriveTest, StopsAndBeginsAnew) {
  sut.start();
  ASSERT_TRUE(sut.update(t0).drive_to);
  sut.stop();
  EXPECT_TRUE(sut.update(t0).cancel);
  EXPECT_EQ(sut.status(), "idle");
  EXPECT_FALSE(sut.update(at(5)).drive_to);
  sut.start();
  EXPECT_TRUE(sut.update(at(5)).drive_to);
}

TEST_F(ExplorationDriveTest, StartsByItselfWhereItShall) {
  ExplorationDrive::Params params;
  params.autostart = true;
  EXPECT_TRUE(ExplorationDrive(params).is_running());
  EXPECT_FALSE(ExplorationDrive({}).is_running());
}

TEST_F(ExplorationDriveTest, ChoosesNoGoalWithoutMapFreshPoseOrNavigator) {
  sut.start();
  sut.on_navigator(false);
  EXPECT_FALSE(sut.update(at(0)).drive_to);
  EXPECT_EQ(sut.status(), "waiting: there is no navigator");
  sut.on_navigator(true);
  EXPECT_FALSE(sut.update(t0 + seconds(3.01)).drive_to);
  EXPECT_EQ(sut.status(), "waiting: there is no fresh location");
  sut.on_pose({nan, 1, 0}, t0 + seconds(5));
  EXPECT_FALSE(sut.update(t0 + seconds(5)).drive_to) << "a pose with NaN is none";
  EXPECT_TRUE(sut.update(at(7)).drive_to);
  ExplorationDrive other{{}};
  other.start();
  EXPECT_FALSE(other.update(t0).drive_to);
  EXPECT_EQ(other.status(), "waiting: there is no map");
}

TEST_F(ExplorationDriveTest, AGoalThatTakesTooLongHasFailed) {
  sut.start();
  ASSERT_TRUE(sut.update(t0).drive_to);
  for (int s = 1; s < 120; ++s) {
    (void)at(s, 0.1 * (s % 2));
    EXPECT_FALSE(sut.update(at(s + 0.9, 0.12 * (s % 2))).drive_to) << "it is driven to";
  }
  const auto second = sut.update(at(120));
  EXPECT_TRUE(second.drive_to) << "it is tried once more";
  EXPECT_FALSE(second.cancel) << "the new one replaces it";
}

TEST_F(ExplorationDriveTest, AGoalThatItDoesNotGetOnToHasFailed) {
  sut.start();
  ASSERT_TRUE(sut.update(t0).drive_to);
  EXPECT_FALSE(sut.update(at(7.9)).drive_to);
  EXPECT_TRUE(sut.update(at(8.9)).drive_to) << "it is tried once more";
  EXPECT_FALSE(sut.update(at(16)).drive_to) << "counted anew";
}

TEST_F(ExplorationDriveTest, WaitsForTheMapToShowWhatIsSeenFromAGoal) {
  sut.start();
  ASSERT_TRUE(sut.update(t0).drive_to);
  sut.on_reached(at(1));
  EXPECT_FALSE(sut.update(at(2.9)).drive_to);
  sut.on_map(floor_known_to(3));
  const auto order = sut.update(at(3));
  ASSERT_TRUE(order.drive_to);
  EXPECT_NEAR(order.drive_to->x_m, 2.95, 1e-9);
}

TEST_F(ExplorationDriveTest, EndsThoughEveryGoalFails) {
  sut.start();
  int goals = 0;
  for (double s = 0; s < 1000 && sut.is_running(); s += 1) {
    if (sut.update(at(s)).drive_to) ++goals;
    sut.on_failed("blocked");
  }
  EXPECT_GE(goals, 2);
  EXPECT_EQ(sut.status().find("done: all that can be reached is known, but for "), 0U)
      << sut.status();
}

TEST_F(ExplorationDriveTest, SendsARejectedGoalAgainAndGivesItUpAfterAMinute) {
  sut.start();
  ASSERT_TRUE(sut.update(t0).drive_to);
  sut.on_rejected("busy", t0);
  EXPECT_FALSE(sut.update(at(4.9)).drive_to);
  EXPECT_EQ(sut.status(), "waiting: the navigator rejects a goal: busy");
  EXPECT_TRUE(sut.update(at(5)).drive_to);
  double s = 5;
  int sent = 2;
  for (; s < 3600 && sut.is_running(); s += 5) {
    sut.on_rejected("busy", at(s));
    sent += sut.update(at(s + 5)).drive_to.has_value();
  }
  EXPECT_FALSE(sut.is_running()) << "it ends";
  EXPECT_GE(sent, 24) << "a place fails twice, a minute each";
}

}  // namespace
}  // namespace tocsin
