// SPDX-License-Identifier: Apache-2.0
// Each bad input: one line that names it, exit code 2, nothing left running.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/file.h>
#include <unistd.h>

#include <fstream>

#include "foundation/temporary_folder.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

class BadInputTest : public ::testing::Test {
 protected:
  /// Checks and launches a bringup file with more arguments and expects both to refuse.
  static void expect_refused(const std::vector<std::string>& more, const std::string& reason,
                             const std::string& file = "mission.yaml") {
    std::string words = file;
    for (const std::string& word : more) words += " '" + word + "'";
    const Ended check = run_to_end(Stack::program("tocsin-check"), words);
    EXPECT_EQ(check.code, 2) << check.output;
    EXPECT_THAT(check.output, HasSubstr(reason));
    expect_refused_by_launch(more, reason, file);
  }
  /// The same of what only a start can find.
  static void expect_refused_by_launch(const std::vector<std::string>& more,
                                       const std::string& reason,
                                       const std::string& file = "mission.yaml") {
    std::vector<std::string> arguments{file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Stack sut(arguments);
    EXPECT_EQ(sut.exit_code(std::chrono::seconds(30)), 2) << sut.output();
    EXPECT_THAT(sut.output(), HasSubstr(reason));
    EXPECT_TRUE(sut.processes().empty()) << "still running";
  }
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }
  const TemporaryFolder folder_;
};

TEST_F(BadInputTest, ParameterThatIsUnknownOrOutOfRangeOrNamesNoFile) {
  for (const auto& [set, reason] : std::vector<std::pair<const char*, const char*>>{
           {"navigator.speeed=1", "navigator.speeed: unknown key"},
           {"transmission_controller.alpha=-1",
            "transmission_controller.alpha: -1 is outside [0.001, 1000]"},
           {"transmission_controller.policy=magic", "'magic' is not one of"},
           {"navigator.map_file=/nowhere/map.yaml", "/nowhere/map.yaml"},
           {"naviigator.rate_hz=10", "naviigator"}}) {
    expect_refused({"--set", set}, reason);
  }
}

TEST_F(BadInputTest, WaypointInsideAWall) {
  const std::string mission = file("in_wall.yaml",
                                   "name: in_wall\nframe: map\nwaypoints:\n"
                                   "  - {x: 100.0, y: 0.0, yaw: 0.0}\n");
  expect_refused({"--set", "mission_control.mission_file=" + mission}, "waypoint");
}

TEST_F(BadInputTest, MissingQosProfile) {
  std::ifstream shipped(Stack::share("bringup/mission.yaml"));
  const std::string text((std::istreambuf_iterator<char>(shipped)), {});
  const std::string qos = file("qos.yaml", "sensor: {}\ncommand: {}\n");
  std::string changed = text;
  changed.replace(changed.find("../config/qos.yaml"), 18, qos);
  for (std::size_t at = 0; (at = changed.find("../config/", at)) != std::string::npos;) {
    changed.replace(at, 10, Stack::share("config") + "/");
  }
  expect_refused({}, "is not in " + qos, file("deployment.yaml", changed));
}

TEST_F(BadInputTest, MisspeltComponent) {
  const std::string robot =
      file("robot.yaml",
           "extends: mission.yaml\nhosts:\n  uxv:\n    containers:\n      - name: payload\n"
           "        components:\n          - camera: ~\n          - camra\n");
  expect_refused({}, "no component 'camra' is installed; did you mean 'camera'? (" + robot + ":8)",
                 robot);
}

TEST_F(BadInputTest, ProgramThatDoesNotExist) {
  const std::string robot = file("robot.yaml",
                                 "extends: mission.yaml\nhosts:\n  uxv:\n    programs:\n"
                                 "      - {name: base, command: [kobuki_simulatr]}\n");
  expect_refused({}, "uxv/base: program 'kobuki_simulatr' is not found", robot);
}

TEST_F(BadInputTest, BrokenChannelFile) {
  const std::string channel = file("channel.yaml", "radio_channel:\n  tx_power_dbn: 3\n");
  expect_refused({"--channel", channel}, "radio_channel.tx_power_dbn: unknown key; allowed: [");
  expect_refused({"--channel", channel}, "(" + channel + ":2)");
}

TEST_F(BadInputTest, BadArgumentOfTheSimulatedBase) {
  const std::string robot =
      file("robot.yaml",
           "extends: mission.yaml\nhosts:\n  uxv:\n    programs:\n"
           "      - {name: base, command: [kobuki_simulator, --link, x, --start, '0,0']}\n");
  expect_refused({}, "--start: '0,0' is not X,Y,YAW in m, m, rad", robot);
}

TEST_F(BadInputTest, LimitOfTheWatchThatDoesNotExist) {
  const std::string robot = file("robot.yaml",
                                 "extends: mission.yaml\nhosts:\n  gcs:\n    containers:\n"
                                 "      - {name: view, health: {period: 1}}\n");
  expect_refused({}, "hosts.gcs.containers.health.period: unknown key; allowed: [period_s, ",
                 robot);
}

TEST_F(BadInputTest, OccupiedSerialPort) {
  const int port = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(port, 0);
  ASSERT_EQ(grantpt(port), 0);
  ASSERT_EQ(unlockpt(port), 0);
  const int holder = open(ptsname(port), O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(holder, 0);
  ASSERT_EQ(flock(holder, LOCK_EX | LOCK_NB), 0);
  expect_refused_by_launch({"--set", std::string("kobuki_driver.device_port=") + ptsname(port)},
                           ptsname(port));
  close(holder);
  close(port);
}

}  // namespace
}  // namespace tocsin
