// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <sstream>

#include "command_line/run_to_end.hpp"
#include "drawn_log.hpp"
#include "foundation/temporary_folder.hpp"
#include "navigation/map_loader.hpp"

namespace tocsin::map_tool {
namespace {

Ended map(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{MAP_PROGRAM, "replay"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_to_end(command);
}

TEST(MapProgram, WritesATrajectoryAndAMapThatTheNavigatorReads) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", drawn_log().text);
  const Ended ended =
      map({log, "--trajectory", folder.path("poses"), "--map", folder.path("room")});
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_EQ(ended.output.find("50 scans in "), 0U) << ended.output;
  std::istringstream lines(folder.read("poses"));
  double time_s = 0;
  lines >> time_s;
  EXPECT_DOUBLE_EQ(time_s, 100);
  // The laser began at (0, -1.5) of the room, in the map at the odometry's (7, 7) with heading 1.
  const navigation::OccupancyMap room = navigation::load_map(folder.path("room.yaml"));
  const auto on_map = [](double x_m, double y_m) {
    return position(geometry::compose({7, 7, 1}, {x_m, y_m + 1.5, 0}));
  };
  EXPECT_EQ(room.at(on_map(0, 0)), navigation::Cell::free);
  EXPECT_TRUE(room.collides(on_map(4, 0).x_m, on_map(4, 0).y_m, 0.1));
  EXPECT_EQ(room.at(on_map(6, 0)), navigation::Cell::unknown);
}

TEST(MapProgram, HasOneLineForEveryBadInput) {
  const TemporaryFolder folder;
  const std::string good = folder.write("good.clf", drawn_log().text);
  const std::string bad = folder.write("bad.clf", "ODOM 1 2\n");
  const std::string none = folder.write("none.clf", "ODOM 1 2 3 0 0 0 1 host 1\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{bad}, "tocsin map: " + bad + ":1: pose: is missing, the line ends before it"},
      {{none}, "tocsin map: " + none + ": has no scan; FLASER or ROBOTLASER1 lines are needed"},
      {{folder.path("absent")}, "tocsin map: "},
      {{good, "--map", folder.path("no/map")}, "tocsin map: " + folder.path("no/map.pgm")},
      {{good, "--trajectory", folder.path("no/poses")}, "tocsin map: " + folder.path("no/poses")},
      {{good, "--resolution", "7"}, "tocsin map: --resolution"},
  };
  for (const auto& [arguments, error] : table) {
    const Ended ended = map(arguments);
    EXPECT_EQ(ended.code, 2) << ended.output;
    EXPECT_EQ(ended.output.find(error), 0U) << ended.output;
    EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
  }
}

}  // namespace
}  // namespace tocsin::map_tool
