// SPDX-License-Identifier: Apache-2.0
#include "replay.hpp"

#include <gtest/gtest.h>

#include "drawn_log.hpp"

namespace tocsin::map_tool {
namespace {

Replay replayed(const std::string& text) {
  Replay replay;
  CarmenLog log(text, "log");
  while (const auto reading = log.next()) replay.on_reading(*reading);
  replay.finish();
  return replay;
}

/// The largest distance between two trajectories, each in the frame of its first pose.
template <class PoseAt>
double worst_m(const std::vector<geometry::Pose>& truth, const PoseAt& pose_at) {
  double worst = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto pose = mapping::relative(pose_at(0), pose_at(i));
    worst = std::max(worst, geometry::distance(position(pose), position(truth[i])));
  }
  return worst;
}

TEST(Replay, PutsRightWhatTheWheelsGetWrong) {
  const DrawnLog drawn = drawn_log();
  const auto trajectory = replayed(drawn.text).trajectory();
  EXPECT_GT(worst_m(drawn.truth, [&](std::size_t i) { return drawn.odometry[i]; }), 0.5);
  EXPECT_LT(worst_m(drawn.truth, [&](std::size_t i) { return trajectory[i].pose; }), 0.08);
}

TEST(Replay, HasOnePoseForEachTimeInTheOrderOfTheLog) {
  const DrawnLog drawn = drawn_log();
  const auto trajectory = replayed(drawn.text).trajectory();
  ASSERT_EQ(trajectory.size(), drawn.times_s.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    EXPECT_DOUBLE_EQ(trajectory[i].time_s, drawn.times_s[i]);
  }
}

TEST(Replay, OfALogWithoutScansIsItsOdometry) {
  const auto trajectory = replayed("ODOM 1 2 3 0 0 0 5 host 5\n").trajectory();
  ASSERT_EQ(trajectory.size(), 1U);
  EXPECT_DOUBLE_EQ(trajectory[0].time_s, 5);
  EXPECT_DOUBLE_EQ(trajectory[0].pose.x_m, 1);
}

TEST(TrajectoryText, HasALineForEachPose) {
  EXPECT_EQ(trajectory_text({{1.25, {1, -2, 0.5}}, {2, {0, 0, 0}}}),
            "1.250000 1.000000 -2.000000 0.500000\n2.000000 0.000000 0.000000 0.000000\n");
}

}  // namespace
}  // namespace tocsin::map_tool
