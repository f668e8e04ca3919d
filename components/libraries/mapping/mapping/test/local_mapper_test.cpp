// SPDX-License-Identifier: Apache-2.0
#include "mapping/local_mapper.hpp"

#include <gtest/gtest.h>

#include "drawn_world.hpp"

namespace tocsin::mapping {
namespace {

using geometry::compose;
using geometry::Pose;

/// A vehicle in the drawn room that goes straight on from (1, 1), its laser and its odometry.
struct Straight {
  Straight() { step(0, 0); }
  /// `way_m` by the odometry, `true_m` by the floor.
  void step(double way_m, double true_m) {
    truth = compose(truth, {true_m, 0, 0});
    odometry = compose(odometry, {way_m, 0, 0});
    if (const auto node = sut.on_scan(odometry, scan_of(room(), truth, {}, random))) {
      matched = node->matched;
    }
  }
  [[nodiscard]] double off_m() const {
    return geometry::distance(position(sut.pose_at(odometry)), position(truth));
  }
  std::mt19937 random{1};
  Pose truth{1, 1, 0};
  Pose odometry{};
  LocalMapper sut{LocalParams{}, Pose{1, 1, 0}};
  bool matched = false;
};

TEST(LocalMapper, DoesNotFollowWheelsThatSlip) {
  Straight drive;
  for (int i = 0; i < 15; ++i) drive.step(0.1, 0.1);
  for (int i = 0; i < 15; ++i) drive.step(0.1, 0);
  EXPECT_LT(drive.off_m(), 0.05);
  for (int i = 0; i < 15; ++i) drive.step(0.1, 0.1);
  EXPECT_LT(drive.off_m(), 0.05);
  EXPECT_TRUE(drive.matched);
}

TEST(LocalMapper, GoesOnWhereOdometryBeginsAnew) {
  Straight drive;
  for (int i = 0; i < 15; ++i) drive.step(0.07, 0.07);
  const Pose before = drive.odometry;
  drive.odometry = {-7, 3, 2};
  drive.sut.on_new_odometry(before, drive.odometry);
  EXPECT_LT(drive.off_m(), 0.05) << "it has moved since the last scan that was used";
  for (int i = 0; i < 15; ++i) drive.step(0.07, 0.07);
  EXPECT_LT(drive.off_m(), 0.05);
}

TEST(LocalMapper, KeepsOnlyWhatGrows) {
  Straight drive;
  std::size_t finished = 0;
  for (int i = 0; i < 50; ++i) {
    drive.truth = compose(drive.truth, {0.11, 0, 0});
    drive.odometry = compose(drive.odometry, {0.11, 0, 0});
    const auto node =
        drive.sut.on_scan(drive.odometry, scan_of(room(), drive.truth, {}, drive.random));
    ASSERT_TRUE(node);
    finished += node->finished.size();
  }
  EXPECT_EQ(finished, 4U) << "of 20 scans each, each half beside the next";
  EXPECT_EQ(drive.sut.finish().size(), 2U);
  EXPECT_TRUE(drive.sut.finish().empty());
}

}  // namespace
}  // namespace tocsin::mapping
