// SPDX-License-Identifier: Apache-2.0
#include "coverage/coverage_plan.hpp"

#include <gtest/gtest.h>

#include "coverage/polygon.hpp"
#include "floors.hpp"
#include "foundation/numbers.hpp"
#include "navigation/planner.hpp"

namespace tocsin::coverage {
namespace {

const Area all{{-1, -1}, {}};

TEST(CoveragePlan, CoversARoomRoundItsPillarAtAnyAngle) {
  for (const double turned_rad : {0.0, 0.4}) {
    const auto map = room(4, 3.2, turned_rad);
    const auto sut = plan_coverage(map, {}, all);
    EXPECT_GE(sut.share, 0.95) << turned_rad;
    EXPECT_LE(sut.length_to_least, 1.35) << turned_rad;
    for (std::size_t i = 1; i < sut.path.size(); ++i) {
      for (double t = 0; t <= 1; t += 0.1) {
        const auto p = between(sut.path[i - 1], sut.path[i], t);
        ASSERT_FALSE(map.collides(p.x_m, p.y_m, 0.18)) << p.x_m << ", " << p.y_m;
      }
    }
  }
}

TEST(CoveragePlan, ItsMeasuresAreThoseOfItsPath) {
  const auto sut = plan_coverage(room(3, 2, 0, false), {}, all);
  EXPECT_NEAR(sut.length_m, navigation::length_m(sut.path), 1e-9);
  EXPECT_NEAR(sut.floor_m2, sut.floor.area_m2(), 1e-9);
  EXPECT_NEAR(sut.floor_m2, 2.8 * 1.8, 0.15) << "the tool comes within 0.1 m of the walls";
  EXPECT_NEAR(sut.share, 1 - sut.left_out.area_m2() / sut.floor_m2, 1e-9);
  EXPECT_NEAR(sut.length_to_least, sut.length_m * 0.3 / sut.floor_m2, 1e-9);
}

TEST(CoveragePlan, HeadsAlongItsSwathsAndNumbersThem) {
  const auto sut = plan_coverage(room(3, 2, 0, false), {}, all);
  std::size_t swath = 0;
  for (std::size_t i = 1; i < sut.stops.size(); ++i) {
    const auto& [pose, number] = sut.stops[i];
    EXPECT_TRUE(number == swath || number == swath + 1);
    swath = number;
    if (number != sut.stops[i - 1].swath) continue;
    const double heading_rad = bearing(position(sut.stops[i - 1].pose), position(pose));
    EXPECT_NEAR(geometry::wrap_angle(pose.heading_rad - heading_rad), 0, 0.1);
  }
  EXPECT_EQ(swath + 1, sut.swaths);
}

TEST(CoveragePlan, StaysInItsPolygonAndMayLeaveItOnTheWay) {
  const std::vector<geometry::Point> left{{-1.9, -1.5}, {-0.5, -1.5}, {-0.5, 1.5}, {-1.9, 1.5}};
  const auto sut = plan_coverage(room(4, 3.2, 0), {}, {{1.5, -1}, left});
  EXPECT_GE(sut.share, 0.93);
  for (const Stop& stop : sut.stops) EXPECT_TRUE(is_inside(left, position(stop.pose)));
  for (const auto& p : sut.floor.points()) EXPECT_TRUE(is_inside(left, p));
}

TEST(CoveragePlan, LeavesOutWhatTheRobotCannotReach) {
  const auto map = room(4, 3.2, 0);
  auto cells = map.cells();
  const auto& grid = map.grid();
  for (int row = 0; row < grid.height; ++row) {
    cells[grid.offset({grid.cell_of({-0.4, 0})->column, row})] = navigation::Cell::occupied;
  }
  const auto sut = plan_coverage({grid, cells}, {}, all);
  for (const auto& p : sut.floor.points()) EXPECT_LT(p.x_m, -0.4);
}

TEST(CoveragePlan, TheSameRequestGivesTheSamePlan) {
  const auto a = plan_coverage(room(3, 2.5, 0.2), {}, all);
  const auto b = plan_coverage(room(3, 2.5, 0.2), {}, all);
  ASSERT_EQ(a.stops.size(), b.stops.size());
  EXPECT_EQ(a.length_m, b.length_m);
}

TEST(CoveragePlan, CoversAFloorThatIsNoWiderThanTheTool) {
  const auto sut = plan_coverage(room(3, 0.62, 0, false), {}, {{-1, 0}, {}});
  EXPECT_GE(sut.share, 0.85);
  EXPECT_LT(sut.length_m, 8);
}

TEST(CoveragePlan, HasOneClearErrorForEachBadInput) {
  const auto map = room(3, 2, 0, false);
  const auto with = [&](double width_m, double overlap_m, const Area& area) {
    CoverageParams params;
    params.width_m = width_m;
    params.overlap_m = overlap_m;
    return error_of([&] { (void)plan_coverage(map, params, area); });
  };
  const geometry::Point at{-1, 0};
  EXPECT_EQ(with(nan, 0, {at, {}}), "width: nan m is outside [0.05, 5]");
  EXPECT_EQ(with(0.01, 0, {at, {}}), "width: 0.01 m is outside [0.05, 5]");
  EXPECT_EQ(with(0.3, 0.3, {at, {}}), "overlap: 0.3 m is outside [0, 0.3), the width");
  EXPECT_EQ(with(0.3, nan, {at, {}}), "overlap: nan m is outside [0, 0.3), the width");
  EXPECT_EQ(with(0.3, 0, {{nan, 1}, {}}), "start: (nan, 1) is not finite");
  EXPECT_EQ(with(0.3, 0, {{99, 1}, {}}).find("start: (99, 1) is outside of the map, x ["), 0U);
  EXPECT_EQ(with(0.3, 0, {{2, 2}, {}}).find("start: (2, 2) is in a wall"), 0U);
  EXPECT_EQ(with(0.3, 0, {at, {{0, 0}, {1, 1}}}), "polygon: has 2 corners, outside [3, 1000]");
  EXPECT_EQ(with(0.3, 0, {at, {{0, 0}, {1, nan}, {1, 0}}}),
            "polygon: corner 2 is (1, nan), which is not finite");
  EXPECT_EQ(with(0.3, 0, {at, {{-1, -1}, {1, 1}, {1, -1}, {-1, 1}}}),
            "polygon: its sides from corner 1 and from corner 3 cross");
  EXPECT_EQ(with(0.3, 0, {at, {{0, 0}, {1, 0}, {0.5, 0}}}), "polygon: folds back at corner 2");
  EXPECT_EQ(with(0.3, 0, {at, {{50, 50}, {51, 50}, {50, 51}}}).find("polygon: is outside of"), 0U);
  EXPECT_EQ(with(0.3, 0, {at, {{-1.5, 0.95}, {1.5, 0.95}, {0, 0.99}}}),
            "polygon: the robot reaches no free floor in it from the start");
}

}  // namespace
}  // namespace tocsin::coverage
