// SPDX-License-Identifier: Apache-2.0
// The shipped map and missions and, where it is there, the thesis's own map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <utility>

#include "navigation/map_loader.hpp"
#include "navigation/mission.hpp"
#include "navigation/path_follower.hpp"
#include "navigation/planner.hpp"

namespace tocsin::navigation {
namespace {

const std::string config = std::string(TOCSIN_REPOSITORY) + "/config";

std::string thesis_folder() {
  const char* shared = std::getenv("TOCSIN_SHARED");
  return (shared != nullptr ? std::string(shared) : std::string(TOCSIN_REPOSITORY) + "/../shared") +
         "/data/thesis";
}

OccupancyMap classroom() { return load_map(std::string(TOCSIN_MAPS) + "/classroom.yaml"); }
Mission shipped(const std::string& name) {
  return load_mission(config + "/missions/" + name + ".yaml");
}

/// Plans all legs, from the map's origin on.
void expect_ways(const OccupancyMap& map, const Mission& mission) {
  Planner sut(std::make_shared<const CostMap>(map, InflationParams{}));
  geometry::Point from{0, 0};
  for (const geometry::Pose& waypoint : mission.waypoints) {
    EXPECT_TRUE(sut.plan(from, position(waypoint))) << waypoint.x_m << ", " << waypoint.y_m;
    from = position(waypoint);
  }
}

TEST(Classroom, HasWaysBetweenAllWaypointsOfBothMissionsWithClearance) {
  for (const auto& [name, size] : {std::pair("mission_a", 9U), std::pair("mission_b", 14U)}) {
    EXPECT_EQ(shipped(name).waypoints.size(), size);
    EXPECT_NO_THROW(require_free(shipped(name), classroom(), 0.45));
    expect_ways(classroom(), shipped(name));
  }
}

TEST(Classroom, IsDrivenThroughWithoutTouchingAWall) {
  const auto map = classroom();
  Planner planner(std::make_shared<const CostMap>(map, InflationParams{}));
  PathFollower sut{{}};
  geometry::Pose pose{0, 0, 0};
  for (const geometry::Pose& waypoint : shipped("mission_a").waypoints) {
    const auto path = planner.plan(position(pose), position(waypoint));
    ASSERT_TRUE(path);
    sut.start(*path);
    for (int i = 0; i < 4000 && distance(position(pose), position(waypoint)) > 0.2; ++i) {
      const geometry::Twist v = sut.follow(pose, std::chrono::milliseconds(50));
      pose = compose(pose, {v.linear_mps * 0.05, 0, v.angular_rad_s * 0.05});
      ASSERT_FALSE(map.collides(pose.x_m, pose.y_m, 0.18)) << pose.x_m << ", " << pose.y_m;
    }
    EXPECT_LE(distance(position(pose), position(waypoint)), 0.2);
  }
}

/// A worst case for the search, which visits nearly every cell: comb-shaped walls on a map of the
/// size of the thesis's.
TEST(Plan, OfALabyrinthIsFound) {
  const Grid grid{960, 736, 0.05, {0, 0}};
  std::vector<Cell> cells(grid.size(), Cell::free);
  for (int column = 60; column < 900; column += 120) {
    const int from = column % 240 == 60 ? 0 : 100;
    for (int row = from; row < from + 636; ++row)
      cells[grid.offset({column, row})] = Cell::occupied;
  }
  const OccupancyMap map{grid, cells};
  Planner sut(std::make_shared<const CostMap>(map, InflationParams{}));
  EXPECT_TRUE(sut.plan({1, 1}, {46, 1}));
}

TEST(ThesisMap, HasAWayThroughBothMissions) {
  const std::string folder = thesis_folder();
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const auto map = load_map(folder + "/experiments_map.yaml");
  for (const char* name : {"mission_a", "mission_b"}) {
    const Mission mission = load_mission(folder + "/" + name + ".jsonl");
    EXPECT_NO_THROW(require_free(mission, map, 0.18));
    expect_ways(map, mission);
  }
}

TEST(ThesisMap, HasTheWaypointsThatWeRestated) {
  const std::string folder = thesis_folder();
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  for (const std::string name : {"mission_a", "mission_b"}) {
    const Mission theirs = load_mission(folder + "/" + name + ".jsonl");
    const Mission ours = shipped(name);
    ASSERT_EQ(ours.waypoints.size(), theirs.waypoints.size());
    for (std::size_t i = 0; i < ours.waypoints.size(); ++i) {
      EXPECT_LT(distance(position(ours.waypoints[i]), position(theirs.waypoints[i])), 1e-3);
      EXPECT_NEAR(
          geometry::wrap_angle(ours.waypoints[i].heading_rad - theirs.waypoints[i].heading_rad), 0,
          1e-3);
    }
  }
}

}  // namespace
}  // namespace tocsin::navigation
