// SPDX-License-Identifier: Apache-2.0
#include "exploration/explorer.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "foundation/numbers.hpp"
#include "navigation/planner.hpp"
#include "simulated_sight.hpp"

namespace tocsin::exploration {
namespace {

using geometry::Point;
using What = Step::What;

/// Drives to goals, one after the other, and looks around every half metre.
class Drive {
 public:
  Drive(double range_m, Point robot) : sight(two_rooms(), range_m), robot_(robot) {
    sight.look(robot_);
  }
  /// `fails`: whether a drive does. The number of goals until it was done; 0 when it was not.
  int run(Explorer& sut, const std::function<bool(const Point&)>& fails) {
    for (int goals = 1; goals < 500; ++goals) {
      const Step step = sut.next(sight.map(), robot_);
      last = step;
      if (step.what == What::done) return goals;
      if (step.what == What::wait) continue;
      if (fails(step.goal)) {
        sut.on_failed("blocked");
      } else {
        drive(step.goal);
        sut.on_reached();
      }
    }
    return 0;
  }
  double known_share() const {
    const navigation::DistanceField ways(navigation::CostMap(sight.truth(), {}), robot_);
    double all = 0;
    double known = 0;
    for (std::size_t i = 0; i < sight.truth().grid().size(); ++i) {
      if (!ways.reaches(i)) continue;
      ++all;
      known += sight.map().cells()[i] != navigation::Cell::unknown;
    }
    return known / all;
  }

  SimulatedSight sight;
  Step last;

 private:
  void drive(const Point& goal) {
    navigation::Planner planner(
        std::make_shared<const navigation::CostMap>(sight.map(), navigation::InflationParams{}));
    const auto path = planner.plan(robot_, goal);
    if (!path) return;
    for (std::size_t i = 1; i < path->size(); ++i) {
      const int steps = 1 + static_cast<int>(distance((*path)[i - 1], (*path)[i]) / 0.5);
      for (int k = 1; k <= steps; ++k) {
        robot_ = between((*path)[i - 1], (*path)[i], double(k) / steps);
        sight.look(robot_);
      }
    }
  }
  Point robot_;
};

/// Its answer once it waits no more.
Step settled(Explorer& sut, const navigation::OccupancyMap& map, const Point& robot) {
  Step step = sut.next(map, robot);
  for (int i = 0; i < 20 && step.what == What::wait; ++i) step = sut.next(map, robot);
  return step;
}

bool never(const Point&) { return false; }

TEST(Explorer, SeesAllThatCanBeReachedAndEnds) {
  for (const double range_m : {1.0, 2.5, 8.0}) {
    Drive drive(range_m, {0.8, 0.8});
    Explorer sut({});
    EXPECT_GT(drive.run(sut, never), 1) << range_m;
    EXPECT_GE(drive.known_share(), 0.99) << range_m;
    EXPECT_EQ(drive.last.reason, "all that can be reached is known");
  }
}

TEST(Explorer, EndsWhereEveryGoalFails) {
  Drive drive(1.5, {0.8, 0.8});
  Explorer sut({});
  EXPECT_GT(drive.run(sut, [](const Point&) { return true; }), 2);
  ASSERT_FALSE(sut.listed().empty());
  EXPECT_EQ(sut.listed().front().reason, "blocked");
  EXPECT_NE(drive.last.reason.find("given up"), std::string::npos) << drive.last.reason;
}

TEST(Explorer, GoesRoundOnePlaceThatFailsAndSeesTheRest) {
  Drive drive(2.5, {0.8, 0.8});
  Explorer sut({});
  EXPECT_GT(drive.run(sut, [](const Point& p) { return p.x_m > 4 && p.y_m > 2; }), 1);
  EXPECT_GE(drive.known_share(), 0.7);
}

TEST(Explorer, EndsWhateverBecomesOfItsGoals) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random(seed);
    Drive drive(1.5, {0.8, 0.8});
    Explorer sut({});
    EXPECT_GT(drive.run(sut, [&](const Point&) { return random() % 3 == 0; }), 1) << seed;
  }
}

TEST(Explorer, EndsThoughNothingMoreIsSeenFromItsGoals) {
  Explorer sut({});
  const auto map = drawn(std::vector<std::string>(20, "..............??????"));
  int goals = 0;
  Step step = sut.next(map, {0.5, 1});
  for (; step.what == What::drive && goals < 100; ++goals) {
    sut.on_reached();
    step = settled(sut, map, {0.5, 1});
  }
  EXPECT_EQ(step.what, What::done);
  EXPECT_GT(goals, 1);
  EXPECT_EQ(sut.listed().front().reason, "reached twice, and more is not seen from there");
}

/// A floor whose left and right ends are not known, the right one over `right` rows of 20.
navigation::OccupancyMap two_ends(int right) {
  std::vector<std::string> rows(20, "????......................????");
  for (std::size_t row = std::size_t(right); row < 20; ++row) {
    rows[row].replace(26, 4, "....");
  }
  return drawn(rows);
}

TEST(Explorer, KeepsItsGoalUntilAnotherIsClearlyBetter) {
  Explorer sut({});
  const Step first = sut.next(two_ends(20), {1.4, 1});
  ASSERT_EQ(first.what, What::drive);
  ASSERT_LT(first.goal.x_m, 1);
  EXPECT_EQ(sut.next(two_ends(20), {1.7, 1}).what, What::keep) << "the other is a little nearer";
  const Step other = sut.next(two_ends(20), {2.3, 1});
  EXPECT_EQ(other.what, What::drive) << "the other is much nearer";
  EXPECT_GT(other.goal.x_m, 2);
}

TEST(Explorer, LeavesAGoalWhoseFrontierIsGone) {
  Explorer sut({});
  const Step first = sut.next(two_ends(20), {2.0, 1});
  ASSERT_GT(first.goal.x_m, 2);
  const Step then = sut.next(two_ends(0), {2.0, 1});
  EXPECT_EQ(then.what, What::drive);
  EXPECT_LT(then.goal.x_m, 1);
}

TEST(Explorer, LeavesShortFrontiersUnknown) {
  const auto map = drawn({"##########", "#........#", "#........#", "#........#", "#...?....#",
                          "#........#", "#........#", "#........#", "#........#", "##########"});
  const Point robot{0.45, 0.75};
  ExplorerParams params;
  params.least_frontier_m = 2;
  Explorer coarse(params);
  EXPECT_EQ(settled(coarse, map, robot).what, What::done);
  params.least_frontier_m = 0.2;
  Explorer fine(params);
  EXPECT_EQ(settled(fine, map, robot).what, What::drive);
}

TEST(Explorer, TriesADoorThatOnlyTheMarginCloses) {
  std::vector<std::string> rows(24, "..........#..........????");
  for (std::size_t row : {9U, 10U, 11U, 12U, 13U}) rows[row][10] = '.';  // 0.5 m
  const auto map = drawn(rows);
  Explorer sut({});
  const Step step = sut.next(map, {0.5, 1.2});
  EXPECT_EQ(step.what, What::drive);
  EXPECT_GT(step.goal.x_m, 1.5);
  for (std::size_t row : {9U, 10U, 12U, 13U}) rows[row][10] = '#';  // 0.1 m
  Explorer other({});
  EXPECT_EQ(settled(other, drawn(rows), {0.5, 1.2}).what, What::done);
}

TEST(Explorer, WaitsTenTimesForARobotThatStandsNowhere) {
  const auto map = two_rooms();
  for (const Point& robot : {Point{nan, 1}, Point{-5, 1}, Point{1, infinity}}) {
    Explorer sut({});
    for (int i = 0; i < 9; ++i) EXPECT_EQ(sut.next(map, robot).what, What::wait);
    EXPECT_EQ(sut.next(map, robot).what, What::done);
  }
  Explorer sut({});
  for (int i = 0; i < 9; ++i) EXPECT_EQ(sut.next(map, {nan, 0}).what, What::wait);
  EXPECT_EQ(settled(sut, map, {0.8, 0.8}).reason, "all that can be reached is known");
}

TEST(Explorer, LooksThreeTimesWhetherThatWasAll) {
  Explorer sut({});
  const Point robot{2, 1};
  EXPECT_EQ(sut.next(two_rooms(), robot).what, What::wait);
  EXPECT_EQ(sut.next(two_rooms(), robot).what, What::wait);
  EXPECT_EQ(sut.next(two_ends(20), robot).what, What::drive) << "a door was only closed by mistake";
  EXPECT_EQ(sut.next(two_rooms(), robot).what, What::wait) << "counts anew";
  EXPECT_EQ(sut.next(two_rooms(), robot).what, What::wait);
  EXPECT_EQ(sut.next(two_rooms(), robot).what, What::done);
}

}  // namespace
}  // namespace tocsin::exploration
