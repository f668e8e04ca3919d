// SPDX-License-Identifier: Apache-2.0
// The main job with all its processes, in namespaces of its own, on a short mission.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <fstream>

#include "packet_tap.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;

class MissionTest : public ::testing::Test {
 protected:
  /// The first waypoints of Mission A, in the classroom: about 9 m, half a minute.
  static std::string short_mission() {
    const std::string path = ::testing::TempDir() + "short_mission.yaml";
    std::ofstream(path) << "name: short\nframe: map\nwaypoints:\n"
                           "  - {x: -0.49, y: 0.47, yaw: 0.0}\n"
                           "  - {x: 3.33, y: -1.91, yaw: 0.0}\n"
                           "  - {x: 6.14, y: -1.54, yaw: 0.0}\n";
    return path;
  }
  static std::vector<std::string> arguments() {
    return {"mission.yaml", "--set", "mission_control.mission_file=" + short_mission(), "--seed",
            "1"};
  }
  static std::size_t count(const std::vector<std::string>& cells, const std::string& wanted) {
    return static_cast<std::size_t>(std::count(cells.begin(), cells.end(), wanted));
  }
  /// The decisions of the vehicle as the vehicle recorded them.
  static std::vector<std::string> vehicle_states(const Stack& stack) {
    const auto roles = column(stack.recorded("uxv", "transmission_state"), "role");
    const auto active = column(stack.recorded("uxv", "transmission_state"), "active");
    std::vector<std::string> states;
    for (std::size_t i = 0; i < std::min(roles.size(), active.size()); ++i) {
      if (roles[i] == "uxv") states.push_back(active[i]);
    }
    return states;
  }
  static void expect_done(const Stack& stack) {
    const auto states = column(stack.recorded("gcs", "mission_status"), "state");
    EXPECT_GT(count(states, "done"), 0U) << "recorded: " << ::testing::PrintToString(states) << '\n'
                                         << stack.output();
  }
};

TEST_F(MissionTest, ATwentySecondOutagePausesResumesAndTheMissionIsCompleted) {
  auto with_policy = arguments();
  with_policy.insert(with_policy.end(), {"--set", "transmission_controller.policy=tocp_dsp"});
  Stack sut(with_policy);
  ASSERT_TRUE(Stack::eventually(seconds(60), [&] { return is_driving(sut); })) << sut.output();
  sut.control("radio.sock", "set outage 20");
  ASSERT_EQ(sut.exit_code(seconds(180)), 0) << sut.output();
  expect_done(sut);
  const auto states = vehicle_states(sut);
  const auto pause = std::find(states.begin(), states.end(), "0");
  ASSERT_NE(pause, states.end()) << "the outage did not pause the vehicle";
  EXPECT_NE(std::find(pause, states.end(), "1"), states.end()) << "it did not resume";
}

TEST_F(MissionTest, NothingOfTheVehicleOnlyTopicsCrossesTheRadio) {
  Stack sut(arguments());
  ASSERT_TRUE(Stack::eventually(seconds(60), [&] { return sut.pid("gcs/link") != 0; }));
  const PacketTap tap(sut.pid("gcs/link"));
  if (!tap.ok()) GTEST_SKIP() << "the namespace of the ground station cannot be entered";
  ASSERT_TRUE(Stack::eventually(seconds(60), [&] { return is_driving(sut); })) << sut.output();
  // Names cross only when participants meet, which may have been before the tap was open.
  kill(sut.pid("gcs/recorder"), SIGKILL);
  ASSERT_TRUE(Stack::eventually(seconds(20), [&] { return tap.saw("rt/location"); }));
  EXPECT_FALSE(tap.saw("rt/odom"));
  EXPECT_FALSE(tap.saw("rt/cmd_vel"));
  EXPECT_EQ(tap.multicasts(), 0U);
}

TEST_F(MissionTest, EveryProcessMayBeKilledAndTheMissionIsCompleted) {
  Stack sut(arguments());
  ASSERT_TRUE(Stack::eventually(seconds(60), [&] { return is_driving(sut); })) << sut.output();
  const auto names = sut.processes();
  ASSERT_GE(names.size(), 9U);
  for (const std::string& name : names) {
    const pid_t before = sut.pid(name);
    if (before == 0) continue;  // the mission is over
    kill(before, SIGKILL);
    ASSERT_TRUE(Stack::eventually(seconds(20),
                                  [&] { return sut.pid(name) != 0 && sut.pid(name) != before; }))
        << name << " did not come back\n"
        << sut.output();
  }
  ASSERT_EQ(sut.exit_code(seconds(240)), 0) << sut.output();
  expect_done(sut);
}

}  // namespace
}  // namespace tocsin
