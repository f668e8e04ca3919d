// SPDX-License-Identifier: Apache-2.0
#include "navigation/mission_writer.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::navigation {
namespace {

TEST(WriteMission, IsReadAgainByLoadMission) {
  const TemporaryFolder folder;
  Mission mission{"a: b #c", "map", {{{1.5, -2.25, 0.5}, 12.5}, {{0, 1e-4, -3.1}}}, ""};
  write_mission(mission, folder.path("m.yaml"));
  const Mission read = load_mission(folder.path("m.yaml"));
  EXPECT_EQ(read.name, mission.name);
  EXPECT_EQ(read.frame, mission.frame);
  ASSERT_EQ(read.waypoints.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(read.waypoints[i].x_m, mission.waypoints[i].x_m, 1e-4);
    EXPECT_NEAR(read.waypoints[i].y_m, mission.waypoints[i].y_m, 1e-4);
    EXPECT_NEAR(read.waypoints[i].heading_rad, mission.waypoints[i].heading_rad, 1e-4);
    EXPECT_EQ(read.waypoints[i].send_s, mission.waypoints[i].send_s);
  }
}

TEST(WriteMission, RefusesWhatNobodyCouldReadAndNamesTheFile) {
  const TemporaryFolder folder;
  Mission mission{"m", "map", {}, ""};
  EXPECT_THROW(write_mission(mission, folder.path("m.yaml")), ConfigError);
  mission.waypoints.resize(most_waypoints);
  EXPECT_NO_THROW(write_mission(mission, folder.path("m.yaml")));
  EXPECT_THROW(write_mission(mission, folder.path("no/m.yaml")), ConfigError);
  mission.waypoints.resize(most_waypoints + 1);
  EXPECT_THROW(write_mission(mission, folder.path("m.yaml")), ConfigError);
}

}  // namespace
}  // namespace tocsin::navigation
