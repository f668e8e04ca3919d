// SPDX-License-Identifier: Apache-2.0
#include "mapping/map_painter.hpp"

#include <gtest/gtest.h>

#include "drawn_world.hpp"
#include "mapping/mapper.hpp"

namespace tocsin::mapping {
namespace {

using geometry::Pose;
using navigation::Cell;
using navigation::TileMap;

class MapPainterTest : public ::testing::Test {
 protected:
  void drive_to(double x_m) {
    for (; at_.x_m < x_m; at_.x_m += 0.25)
      (void)mapper_.on_scan(at_, scan_of(room(), at_, {}, random_));
  }
  /// Puts what has changed onto a map, as who follows does.
  std::size_t follow(bool may_begin_anew = true) {
    sut_.paint(mapper_.global(), may_begin_anew);
    auto changes = sut_.take_changes();
    for (auto& change : changes) (void)seen_.put(change.index, std::move(change.tile));
    return changes.size();
  }
  std::mt19937 random_{1};
  Pose at_{1, 1, 0};
  Mapper mapper_;
  MapPainter sut_{0.05};
  TileMap seen_{0.05};
};

TEST_F(MapPainterTest, WhoFollowsTheTilesHasTheMap) {
  EXPECT_EQ(follow(), 0U);
  for (const double x_m : {2.0, 4.0, 6.0}) {
    drive_to(x_m);
    EXPECT_GT(follow(), 0U);
  }
  EXPECT_EQ(follow(), 0U) << "nothing is new";
  const auto map = seen_.map();
  const auto whole = mapper_.map(0.05);
  int other = 0;
  for (double y_m = -0.5; y_m < 6.5; y_m += 0.05) {
    for (double x_m = -0.5; x_m < 8.5; x_m += 0.05) {
      const geometry::Point p{x_m + 0.025, y_m + 0.025};
      if (map.at(p) != whole.at(p)) ++other;
    }
  }
  EXPECT_LT(other, 100) << "but for cells that the last move of the graph has changed";
  EXPECT_TRUE(map.collides(8, 2, 0.06));
  EXPECT_EQ(map.at(geometry::Point{4, 1.5}), Cell::free);
}

TEST_F(MapPainterTest, PaintsAnewWhereTheGraphHasMoved) {
  MapSession session;
  for (const double x_m : {2.0, 5.0}) {
    session.nodes.push_back({{x_m, 1, 0}, PackedScan(scan_of(room(), {x_m, 1, 0}, {}, random_))});
  }
  session.submaps = {{0}, {1}};
  const GlobalMapper before({}, session);
  sut_.paint(before, true);
  const std::size_t tiles = sut_.take_changes().size();
  session.nodes[1].pose.x_m = 5.3;
  const GlobalMapper after({}, session);
  sut_.paint(after, false);
  EXPECT_EQ(sut_.take_changes().size(), 0U);
  sut_.paint(after, true);
  EXPECT_GT(sut_.take_changes().size(), 0U);
  EXPECT_GE(sut_.tiles().tiles().size(), tiles) << "what is empty now is told, too";
}

}  // namespace
}  // namespace tocsin::mapping
