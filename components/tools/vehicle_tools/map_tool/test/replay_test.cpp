// SPDX-License-Identifier: Apache-2.0
#include "replay.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>

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
    const auto pose = relative(pose_at(0), pose_at(i));
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

/// Mean error [m] of the poses that people verified, as far as the trajectory has them.
double mean_error_m(const std::vector<TimedPose>& trajectory, std::istream& relations) {
  std::map<long, geometry::Pose> at;  // by time in units of 0.1 ms
  for (const auto& [time_s, pose] : trajectory) at[std::lround(time_s * 1e4)] = pose;
  double sum = 0;
  double count = 0;
  double t1 = 0;
  double t2 = 0;
  double skip = 0;
  geometry::Pose known;
  while (relations >> t1 >> t2 >> known.x_m >> known.y_m >> skip >> skip >> skip >>
         known.heading_rad) {
    const auto a = at.find(std::lround(t1 * 1e4));
    const auto b = at.find(std::lround(t2 * 1e4));
    if (a == at.end() || b == at.end()) continue;
    const auto off = relative(known, relative(a->second, b->second));
    sum += std::hypot(off.x_m, off.y_m);
    ++count;
  }
  return count > 100 ? sum / count : infinity;
}

/// The first 3,000 lines of a real log, when it is at hand.
TEST(Replay, MapsTheBeginningOfIntel) {
  const char* root = std::getenv("TOCSIN_SHARED");
  const std::string folder =
      (root != nullptr ? std::string(root) : TOCSIN_REPOSITORY "/../shared") + "/data/slam/";
  std::ifstream log(folder + "intel.clf");
  std::ifstream relations(folder + "intel.relations");
  if (!log || !relations) GTEST_SKIP() << "no recorded log in " << folder;
  std::string text;
  std::string line;
  for (int i = 0; i < 3000 && std::getline(log, line); ++i) text += line + "\n";
  EXPECT_LT(mean_error_m(replayed(text).trajectory(), relations), 0.045);
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
