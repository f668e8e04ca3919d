// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <tuple>

#include "drawn_map.hpp"
#include "foundation/error.hpp"
#include "navigation/mission.hpp"

namespace tocsin::navigation {
namespace {

using ::testing::HasSubstr;

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

class LoadMission : public ::testing::Test {
 protected:
  LoadMission() { std::filesystem::create_directories(folder_); }
  ~LoadMission() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  Mission load(const std::string& name, const std::string& text) const {
    return load_mission(write(name, text));
  }
  std::string error_with(const std::string& name, const std::string& text) const {
    return error_of([&] { (void)load(name, text); });
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("tocsin_mission_" + std::to_string(::getpid()));
  const std::string line_ =
      R"({"latency": "1559811064897", "orz": 0.5, "orx": 0.0, "ory": 0.0, "orw": 0.866025, )"
      R"("ts": "2019-06-06 11:51:04", "posx": -0.5, "posy": 1.25})";
};

TEST_F(LoadMission, ReadsAgainWhatHasChanged) {
  using std::filesystem::last_write_time;
  const std::string path = write("m.yaml", "waypoints: [{x: 1, y: 2}]");
  last_write_time(path, last_write_time(path) - std::chrono::hours(2));
  EXPECT_EQ(load_mission(path).waypoints.at(0).x_m, 1);
  EXPECT_EQ(load_mission(path).waypoints.at(0).x_m, 1);
  write("m.yaml", "waypoints: [{x: 3, y: 2}]");
  last_write_time(path, last_write_time(path) - std::chrono::hours(1));
  EXPECT_EQ(load_mission(path).waypoints.at(0).x_m, 3);
}

TEST_F(LoadMission, ReadsOurYaml) {
  const Mission sut = load("m.yaml",
                           "name: patrol\nframe: map\nwaypoints:\n"
                           "  - {x: 1.5, y: -2, yaw: 0.3}\n  - {x: 0, y: 4}\n");
  EXPECT_EQ(sut.name, "patrol");
  ASSERT_EQ(sut.waypoints.size(), 2u);
  EXPECT_DOUBLE_EQ(sut.waypoints[0].y_m, -2);
  EXPECT_DOUBLE_EQ(sut.waypoints[0].heading_rad, 0.3);
  EXPECT_DOUBLE_EQ(sut.waypoints[1].heading_rad, 0);
  EXPECT_EQ(load("patrol.yaml", "waypoints: [{x: 0, y: 4}]\n").name, "patrol");
}

TEST_F(LoadMission, ReadsTheThesisJsonLines) {
  const Mission sut = load("mission_a.jsonl", line_ + "\n\n" + line_ + "\r\n");
  EXPECT_EQ(sut.name, "mission_a");
  ASSERT_EQ(sut.waypoints.size(), 2u);
  EXPECT_DOUBLE_EQ(sut.waypoints[1].x_m, -0.5);
  EXPECT_DOUBLE_EQ(sut.waypoints[1].y_m, 1.25);
  EXPECT_NEAR(sut.waypoints[1].heading_rad, pi / 3, 1e-5);
}

TEST_F(LoadMission, NamesFileLineAndKeyOfWhatIsWrong) {
  const std::tuple<const char*, std::string, const char*> rows[] = {
      {"m.jsonl", line_ + "\nnonsense\n", "m.jsonl:2: not a JSON"},
      {"m.jsonl", "[]\n", "m.jsonl:1: not a JSON object"},
      {"m.jsonl", R"({"posx": 1})", "posy is missing"},
      {"m.jsonl", R"({"posx": "1", "posy": 2})", "posx"},
      {"m.jsonl", R"({"posx":1e9,"posy":2,"orx":0,"ory":0,"orz":0,"orw":1})", "100 km"},
      {"m.jsonl", "\n", "[1, 4095]"},
      {"m.yaml", "waypoints:\n  - {x: 0, y: 0}\n  - {x: .nan, y: 1}\n", "waypoint 2.x"},
      {"m.yaml", "waypoints:\n  - {x: 0, y: 0}\n  - {x: .nan, y: 1}\n", "m.yaml:3"},
      {"m.yaml", "waypoints:\n  - {x: 0}\n", "waypoint 1.y: missing"},
      {"m.yaml", "waypoints: [{x: 1, y: 1, send_s: 3601}]\n", "waypoint 1.send_s"},
      {"m.yaml", "waypoints: [3]\n", "waypoint 1"},
      {"m.yaml", "waypoints: [null]\n", "waypoint 1"},
      {"m.yaml", "wayponts: []\n", "wayponts: unknown key; allowed: name, frame, waypoints"},
      {"m.yaml", "waypoints: [{x: 1, y: 1, z: 1}]\n", "z"},
      {"m.yaml", "name: a\n", "mission.waypoints"},
      {"m.yaml", "waypoints: []\n", "[1, 4095]"},
      {"m.yaml", "- 1\n", "a mission is a map"}};
  for (const auto& [name, text, error] : rows) {
    EXPECT_THAT(error_with(name, text), HasSubstr(error)) << text;
  }
  for (const char* path : {"/nowhere/m.jsonl", "/nowhere/m.yaml"}) {
    EXPECT_THAT(error_of([&] { (void)load_mission(path); }), HasSubstr("/nowhere"));
  }
}

class RequireFree : public ::testing::Test {
 protected:
  static std::string error_at(double x, double y) {
    const auto map = drawn_map({"#####", "#...#", "#.?.#", "#...#", "#####"});
    const Mission mission{"m", "map", {{{1.5, 1.5, 0}}, {{x, y, 0}}}, "m.yaml"};
    return error_of([&] { require_free(mission, map, 0.4); });
  }
};

TEST_F(RequireFree, NamesAWaypointThatIsNotOnTheKnownFloor) {
  EXPECT_EQ(error_at(3.59, 3.5), "no error");
  EXPECT_EQ(error_at(4.5, 2.25), "waypoint 2 at (4.5, 2.25) is inside a wall (m.yaml)");
  EXPECT_THAT(error_at(3.61, 3.5), HasSubstr("nearer to a wall"));
  EXPECT_THAT(error_at(2.5, 2.5), HasSubstr("off the known floor"));
  EXPECT_THAT(error_at(50, 2.5), HasSubstr("off the known floor"));
}

}  // namespace
}  // namespace tocsin::navigation
