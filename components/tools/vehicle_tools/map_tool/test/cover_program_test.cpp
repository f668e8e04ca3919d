// SPDX-License-Identifier: Apache-2.0
// tocsin map cover, on a bare floor of 3 m by 2 m.
#include <gtest/gtest.h>

#include <algorithm>

#include "command_line/run_to_end.hpp"
#include "foundation/temporary_folder.hpp"
#include "navigation/mission.hpp"

namespace tocsin::map_tool {
namespace {

class CoverProgram : public ::testing::Test {
 protected:
  CoverProgram() {
    folder_.write("room.pgm", "P5 60 40 255\n" + std::string(2400, '\xfe'));
    map_ = folder_.write("room.yaml", "image: room.pgm\nresolution: 0.05\norigin: [-1.5, -1, 0]\n");
  }
  Ended cover(const std::vector<std::string>& arguments) {
    std::vector<std::string> command{MAP_PROGRAM, "cover", map_};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_to_end(command);
  }
  TemporaryFolder folder_;
  std::string map_;
};

TEST_F(CoverProgram, WritesAMissionThatIsReadAndAPicture) {
  const std::string file = folder_.path("floor.yaml");
  const Ended ended = cover({"--mission", file, "--picture", folder_.path("floor.pgm"), "--polygon",
                             "-1,-1", "1,-1", "1,1", "-1,1"});
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_NE(ended.output.find(" m2 that can be reached, on "), std::string::npos) << ended.output;
  const auto mission = navigation::load_mission(file);
  EXPECT_EQ(mission.name, "floor");
  EXPECT_GE(mission.waypoints.size(), 12U);
  for (const auto& pose : mission.waypoints) {
    EXPECT_LE(std::abs(pose.x_m), 1) << "outside of the polygon";
  }
  EXPECT_EQ(folder_.read("floor.pgm").find("P5\n60 40\n255\n"), 0U);
}

TEST_F(CoverProgram, HasOneLineForEveryBadInput) {
  const std::string good = folder_.path("m.yaml");
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{"--mission", folder_.path("no/m.yaml")}, "tocsin map: " + folder_.path("no/m.yaml")},
      {{"--mission", good, "--start", "1"}, "tocsin map: --start: '1' is no place"},
      {{"--mission", good, "--start", "9,9"}, "tocsin map: start: (9, 9) is outside of the map"},
      {{"--mission", good, "--polygon", "0,0", "1,0"}, "tocsin map: polygon: has 2 corners"},
      {{"--mission", good, "--polygon", "0,0", "1,0", "inf,1"}, "tocsin map: --polygon: 'inf,1'"},
      {{"--mission", good, "--width", "nan"}, "tocsin map: width: nan m is outside"},
      {{"--mission", good, "--overlap", "1"}, "tocsin map: overlap: 1 m is outside"},
      {{"--mission", good, "--picture", folder_.path("no/p")},
       "tocsin map: " + folder_.path("no/p")},
      {{}, "tocsin map: --mission"},
  };
  for (const auto& [arguments, error] : table) {
    const Ended ended = cover(arguments);
    EXPECT_EQ(ended.code, 2) << ended.output;
    EXPECT_EQ(ended.output.find(error), 0U) << ended.output;
    EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
  }
}

}  // namespace
}  // namespace tocsin::map_tool
