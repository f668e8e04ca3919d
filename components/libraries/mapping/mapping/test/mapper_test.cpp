// SPDX-License-Identifier: Apache-2.0
#include "mapping/mapper.hpp"

#include <gtest/gtest.h>

#include "drawn_world.hpp"

namespace tocsin::mapping {
namespace {

using geometry::compose;
using geometry::Pose;

/// A corridor round a block of 24 x 14 m with doors at uneven places.
std::vector<Segment> ring() {
  auto walls = closed({{0, 0}, {24, 0}, {24, 14}, {0, 14}});
  const auto block = closed({{2, 2}, {22, 2}, {22, 12}, {2, 12}});
  walls.insert(walls.end(), block.begin(), block.end());
  for (const double x_m : {3.0, 5.5, 9.0, 15.5, 17.0}) walls.push_back({{x_m, 0}, {x_m, 0.3}});
  for (const double x_m : {4.0, 8.5, 10.0, 18.0}) walls.push_back({{x_m, 13.6}, {x_m, 14}});
  for (const double y_m : {3.0, 4.5, 9.0}) walls.push_back({{0, y_m}, {0.4, y_m}});
  for (const double y_m : {5.0, 8.5}) walls.push_back({{23.6, y_m}, {24, y_m}});
  return walls;
}

/// A drive with wheels that err, and what a mapper makes of it.
struct Driven {
  Driven(const std::vector<Segment>& walls, const std::vector<Pose>& way, Mapper& mapper) {
    std::mt19937 random(4);
    Pose odometry{};
    for (std::size_t i = 0; i < way.size(); ++i) {
      if (i > 0) odometry = compose(odometry, measured(relative(way[i - 1], way[i]), {}, random));
      if (!mapper.on_scan(odometry, scan_of(walls, way[i], {}, random))) continue;
      truth.push_back(relative(way.front(), way[i]));
    }
    mapper.finish();
  }
  /// Largest distance between the truth and where a node is, both in the frame of the first one.
  template <class PoseAt>
  [[nodiscard]] double worst_m(const PoseAt& pose_at) const {
    double worst = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Pose pose = relative(pose_at(0), pose_at(i));
      worst = std::max(worst, geometry::distance(position(pose), position(truth[i])));
    }
    return worst;
  }
  std::vector<Pose> truth;
};

std::vector<Pose> twice_round() {
  return drive({{1, 1}, {23, 1}, {23, 13}, {1, 13}, {1, 1}, {23, 1}, {23, 4}}, 0.4, 0.3);
}

TEST(Mapper, ClosesALoopThatTheWheelsLeaveOpen) {
  Mapper sut;
  const Driven driven(ring(), twice_round(), sut);
  EXPECT_GT(driven.worst_m([&](std::size_t i) { return sut.nodes()[i].odometry; }), 3);
  EXPECT_LT(driven.worst_m([&](std::size_t i) { return sut.poses()[i]; }), 0.15);
}

TEST(Mapper, ItsMapHasTheWalls) {
  Mapper sut;
  const Driven driven(room(), drive({{1, 1}, {6, 1}, {6, 3}, {4, 3}}, 0.2, 0.3), sut);
  const auto map = sut.map(0.05);
  const auto at = [&](double x_m, double y_m) { return geometry::Point{x_m - 1, y_m - 1}; };
  EXPECT_EQ(map.at(at(4, 1)), navigation::Cell::free);
  EXPECT_TRUE(map.collides(at(8, 2).x_m, at(8, 2).y_m, 0.06));
  EXPECT_TRUE(map.collides(at(2.6, 4).x_m, at(2.6, 4).y_m, 0.06));
  EXPECT_EQ(map.at(at(2.3, 4)), navigation::Cell::unknown);
}

TEST(Mapper, UsesNoScanOfAVehicleThatStands) {
  Mapper sut;
  std::mt19937 random(1);
  const Scan scan = scan_of(room(), {1, 1, 0}, {}, random);
  EXPECT_TRUE(sut.on_scan({1, 1, 0}, scan));
  EXPECT_FALSE(sut.on_scan({1.099, 1, 0.099}, scan));
  EXPECT_TRUE(sut.on_scan({1.101, 1, 0}, scan));
  EXPECT_EQ(sut.poses().size(), 2U);
}

TEST(Mapper, FollowsTheWheelsWhenNothingIsSeen) {
  Mapper sut;
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(sut.on_scan({0.5 * i, 0, 0}, Scan{}));
  sut.finish();
  EXPECT_NEAR(sut.poses().back().x_m, 14.5, 1e-6);
  EXPECT_FALSE(sut.nodes().back().matched);
}

TEST(Mapper, KnowsWhereTheVehicleIsBetweenScans) {
  Mapper sut;
  EXPECT_DOUBLE_EQ(sut.pose_at({3, 4, 1}).x_m, 3);
  std::mt19937 random(1);
  (void)sut.on_scan({3, 4, 0}, scan_of(room(), {1, 1, 0}, {}, random));
  EXPECT_DOUBLE_EQ(sut.pose_at({3.05, 4, 0}).x_m, 3.05);
}

TEST(Mapper, IsTheSameBitForBit) {
  const auto way = drive({{1, 1}, {6, 1}, {6, 3}, {4, 3}}, 0.3, 0.3);
  Mapper one;
  Mapper two;
  const Driven first(room(), way, one);
  const Driven second(room(), way, two);
  ASSERT_EQ(one.poses().size(), two.poses().size());
  for (std::size_t i = 0; i < one.poses().size(); ++i) {
    EXPECT_EQ(one.poses()[i].x_m, two.poses()[i].x_m);
    EXPECT_EQ(one.poses()[i].y_m, two.poses()[i].y_m);
    EXPECT_EQ(one.poses()[i].heading_rad, two.poses()[i].heading_rad);
  }
}

}  // namespace
}  // namespace tocsin::mapping
