// SPDX-License-Identifier: Apache-2.0
// tocsin map order, on a bare floor of 20 m by 10 m whose upper half has no link.
#include <gmock/gmock.h>

#include "command_line/run_to_end.hpp"
#include "foundation/temporary_folder.hpp"
#include "link_map/signal_file.hpp"
#include "navigation/mission.hpp"

namespace tocsin::map_tool {
namespace {

using ::testing::HasSubstr;

class OrderProgram : public ::testing::Test {
 protected:
  OrderProgram() {
    folder_.write("hall.pgm", "P5 200 100 255\n" + std::string(20000, '\xfe'));
    map_ = folder_.write("hall.yaml", "image: hall.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n");
    std::vector<link_map::Reading> readings;
    for (int x = 1; x < 20; ++x) {
      for (int y = 1; y < 10; ++y) {
        const bool is_lost = y > 4;
        readings.push_back({{double(x), double(y)}, is_lost ? -93.0 : -60.0, is_lost ? 1.0 : 0.0});
      }
    }
    link_ = folder_.write("hall.signal.csv", link_map::signal_text(readings));
    mission_ = folder_.write("m.yaml",
                             "name: hall\nwaypoints: [{x: 1, y: 1}, {x: 15, y: 1}, {x: 3, y: 8, "
                             "send_s: 7}, {x: 10, y: 1}, {x: 15, y: 8}, {x: 18, y: 1}]\n");
  }
  Ended order(const std::vector<std::string>& arguments) {
    std::vector<std::string> command{MAP_PROGRAM, "order"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_to_end(command);
  }
  std::vector<double> xs_of(const std::string& file) {
    std::vector<double> xs;
    for (const auto& waypoint : navigation::load_mission(file).waypoints) {
      xs.push_back(waypoint.x_m);
    }
    return xs;
  }
  TemporaryFolder folder_;
  std::string map_;
  std::string link_;
  std::string mission_;
};

TEST_F(OrderProgram, WritesAShorterMissionWithTheSameEnds) {
  const std::string out = folder_.path("o.yaml");
  const Ended ended = order({mission_, "--map", map_, "-o", out});
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_THAT(ended.output, HasSubstr("way "));
  const auto mission = navigation::load_mission(out);
  EXPECT_EQ(mission.name, "hall");
  EXPECT_EQ(xs_of(out), (std::vector<double>{1, 3, 10, 15, 15, 18}));
  EXPECT_EQ(mission.waypoints[1].send_s, 7) << "what is done there goes with it";
}

TEST_F(OrderProgram, KeepsTheLinkForALongerWay) {
  const std::string out = folder_.path("o.yaml");
  const auto silent_m = [&](const std::string& detour) {
    const Ended ended =
        order({mission_, "--map", map_, "--link", link_, "-o", out, "--detour", detour});
    EXPECT_EQ(ended.code, 0) << ended.output;
    const auto at = ended.output.rfind("-> ");
    return std::stod(ended.output.substr(at + 3));
  };
  EXPECT_LE(silent_m("0.5"), silent_m("0"));
  EXPECT_GT(silent_m("0.5"), 0) << "two waypoints have no link";
}

TEST_F(OrderProgram, HasOneLineForEveryBadInput) {
  const std::string out = folder_.path("o.yaml");
  const std::string wall = folder_.write("w.yaml", "waypoints: [{x: 1, y: 1}, {x: 30, y: 1}]\n");
  const std::string few = folder_.write("few.csv", "x_m,y_m,signal_dbm\n1,1,-50\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{mission_, "-o", out}, "tocsin map: --map"},
      {{mission_, "--map", map_}, "tocsin map: --output"},
      {{folder_.path("no.yaml"), "--map", map_, "-o", out},
       "tocsin map: " + folder_.path("no.yaml")},
      {{wall, "--map", map_, "-o", out},
       "tocsin map: waypoint 2 at (30, 1) is off the known floor"},
      {{mission_, "--map", map_, "-o", folder_.path("no/o.yaml")},
       "tocsin map: " + folder_.path("no/o")},
      {{mission_, "--map", map_, "-o", out, "--link", few},
       "tocsin map: " + few + ": has 1 places"},
      {{mission_, "--map", map_, "-o", out, "--link", mission_}, "line 1 names no column"},
      {{mission_, "--map", map_, "-o", out, "--detour", "-1"}, "tocsin map: --detour"},
  };
  for (const auto& [arguments, error] : table) {
    const Ended ended = order(arguments);
    EXPECT_EQ(ended.code, 2) << ended.output;
    EXPECT_THAT(ended.output, HasSubstr(error));
    EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
  }
}

}  // namespace
}  // namespace tocsin::map_tool
