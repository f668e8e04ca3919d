// SPDX-License-Identifier: Apache-2.0
#include "mapping/loop_finder.hpp"

#include <gtest/gtest.h>

#include "drawn_world.hpp"

namespace tocsin::mapping {
namespace {

using geometry::Pose;

const Laser all_round{360, 2 * pi, 0.01, 30};

/// A submap of what is seen on a way, in the frame of the world.
Submap submap_of(const std::vector<Segment>& walls, const std::vector<Pose>& way) {
  std::mt19937 random(1);
  Submap submap(0, 0.05, 0.05);
  for (std::size_t i = 0; i < way.size(); ++i) {
    submap.insert(i, scan_of(walls, way[i], all_round, random), way[i]);
  }
  submap.finish();
  return submap;
}

Points seen_from(const std::vector<Segment>& walls, const Pose& pose) {
  std::mt19937 random(2);
  return laser::thinned(scan_of(walls, pose, all_round, random).hits, 0.1);
}

TEST(FindLoop, RecognisesARoomFromAnotherPlaceAndHeading) {
  const Submap submap = submap_of(room(), {{3, 2, 0}, {4, 2, 0}, {5, 3, 1}});
  const Pose truth{5, 1.5, 1.2};
  const auto loop = find_loop(submap, seen_from(room(), truth), {3.5, 2.8, 0.9}, {2.5, 0.5});
  ASSERT_TRUE(loop);
  EXPECT_LT(geometry::distance(position(loop->pose), position(truth)), 0.02);
  EXPECT_NEAR(loop->pose.heading_rad, truth.heading_rad, 0.01);
}

TEST(FindLoop, DoesNotTakeAnotherRoomForThisOne) {
  const auto other = closed({{0, 0}, {11, 1}, {9, 4}, {3, 7}, {-1, 3}});
  const Submap submap = submap_of(room(), {{3, 2, 0}, {4, 2, 0}});
  EXPECT_FALSE(find_loop(submap, seen_from(other, {4, 2.5, 0}), {4, 2.5, 0}, {2.5, 0.5}));
}

TEST(FindLoop, RefusesACorridorThatLooksTheSameAllAlong) {
  const std::vector<Segment> corridor{{{-50, -1}, {50, -1}}, {{-50, 1}, {50, 1}}};
  const Submap submap = submap_of(corridor, {{0, 0, 0}, {3, 0, 0}});
  EXPECT_FALSE(find_loop(submap, seen_from(corridor, {1, 0, 0}), {1, 0, 0}, {4, 0.3}));
}

TEST(FindLoop, RefusesWhatLiesWhereTheSubmapSawNothing) {
  const Submap submap = submap_of(room(), {{3, 2, 0}, {4, 2, 0}, {5, 3, 1}});
  Points points = seen_from(room(), {4, 2, 0});
  const auto true_points = points.size();
  for (std::size_t i = 0; i < true_points / 3; ++i) {  // a wall across the free floor
    points.push_back({-1.5 + 0.02 * static_cast<double>(i), -0.9});
  }
  LoopParams params;
  EXPECT_FALSE(find_loop(submap, points, {4, 2, 0}, {1, 0.3}, params));
  params.max_opposed = 1;
  EXPECT_TRUE(find_loop(submap, points, {4, 2, 0}, {1, 0.3}, params));
}

TEST(Submap, ForgetsWhoWalkedThrough) {
  auto crowded = room();
  crowded.push_back({{4.5, 2}, {4.5, 2.4}});
  std::mt19937 random(1);
  Submap submap(0, 0.05, 0.05);
  submap.insert(0, scan_of(crowded, {3, 2, 0}, all_round, random), {3, 2, 0});
  EXPECT_GT(submap.field().at(4.5, 2.2).value, 0.5);
  for (std::size_t i = 1; i < 8; ++i) {
    submap.insert(i, scan_of(room(), {3, 2, 0}, all_round, random), {3, 2, 0});
  }
  submap.finish();
  EXPECT_LT(submap.field().at(4.5, 2.2).value, 0.01);
  EXPECT_GT(submap.field().at(8, 2.2).value, 0.5);
  EXPECT_TRUE(submap.contains(7));
  EXPECT_FALSE(submap.contains(8));
}

/// Local poses on a straight way of 1 m steps, and a loop back from node i to the submap of node 0.
class LoopJuryTest : public ::testing::Test {
 protected:
  LoopJuryTest() {
    for (int i = 0; i < 40; ++i) local_.push_back({1.0 * i, 0, 0});
  }
  [[nodiscard]] static LoopCandidate loop(std::size_t node, const Pose& relative) {
    return {0, 0, node, relative, Eigen::Matrix3d::Identity()};
  }
  std::vector<Pose> local_;
  LoopJury sut_;
};

TEST_F(LoopJuryTest, AcceptsTwoThatAgreeAndNotOneAlone) {
  EXPECT_TRUE(sut_.on_candidate(loop(30, {2, 1, 0}), local_).empty());
  const auto accepted = sut_.on_candidate(loop(34, {6.1, 1.1, 0}), local_);
  ASSERT_EQ(accepted.size(), 2U);
  EXPECT_EQ(accepted[0].node, 30U);
  EXPECT_EQ(accepted[1].node, 34U);
}

TEST_F(LoopJuryTest, AcceptsNeitherOfTwoThatDisagree) {
  // 4 m apart 0.3 + 0.03 * 4 m are tolerated, and 0.06 + 0.005 * 4 rad.
  EXPECT_TRUE(sut_.on_candidate(loop(30, {2, 1, 0}), local_).empty());
  EXPECT_TRUE(sut_.on_candidate(loop(34, {6.43, 1, 0}), local_).empty());
  EXPECT_TRUE(sut_.on_candidate(loop(35, {7, 1.05, 0.09}), local_).empty());
  EXPECT_EQ(sut_.on_candidate(loop(34, {6.41, 1, 0}), local_).size(), 2U);
}

TEST_F(LoopJuryTest, TheSameNodeDoesNotConfirmItself) {
  EXPECT_TRUE(sut_.on_candidate(loop(30, {2, 1, 0}), local_).empty());
  EXPECT_TRUE(sut_.on_candidate(loop(30, {2, 1, 0}), local_).empty());
}

}  // namespace
}  // namespace tocsin::mapping
