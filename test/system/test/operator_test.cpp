// SPDX-License-Identifier: Apache-2.0
// An operator at the ground station: drives by hand over the radio, stops the vehicle, docks it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "foundation/temporary_folder.hpp"
#include "operator_process.hpp"
#include "peer.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::HasSubstr;

class OperatorTest : public ::testing::Test {
 protected:
  static std::vector<std::string> verb(const Stack& stack, std::vector<std::string> words) {
    words.insert(words.begin(), Stack::program("tocsin"));
    words.insert(words.end(), {"--run-dir", stack.folder()});
    return words;
  }
  /// Runs a command to its end; its exit code.
  static int run(const Stack& stack, const std::vector<std::string>& words) {
    return OperatorProcess(verb(stack, words), stack.folder() + "/command.out")
        .exit_code(seconds(60));
  }
  /// Where the vehicle itself said it was, [m] along x, with the instants.
  static std::vector<std::pair<double, double>> way(const Stack& stack) {
    const std::string csv = stack.recorded("uxv", "location");
    const auto times = column(csv, "send_s");
    const auto xs = column(csv, "pose.pose.position.x");
    std::vector<std::pair<double, double>> all;
    for (std::size_t i = 0; i < std::min(times.size(), xs.size()); ++i) {
      if (!xs[i].empty()) all.push_back({std::stod(times[i]), std::stod(xs[i])});
    }
    return all;
  }
  static bool moved(const Stack& stack, double metres) {
    const auto all = way(stack);
    return !all.empty() && std::abs(all.back().second - all.front().second) > metres;
  }
  static bool has_recorded_until(const Stack& stack, double wall) {
    const auto all = way(stack);
    return !all.empty() && all.back().first > wall;
  }
  /// Holds a key down as a keyboard repeats it, until the vehicle has driven half a metre.
  static bool drive(const Stack& stack, const OperatorProcess& keyboard) {
    for (int i = 0; i < 400; ++i) {
      keyboard.type("w");
      if (moved(stack, 0.5)) return true;
      std::this_thread::sleep_for(milliseconds(50));
    }
    return false;
  }
  /// When the vehicle last moved [s since the epoch].
  static double stopped_at(const Stack& stack) {
    const auto all = way(stack);
    double last = 0;
    for (std::size_t i = 1; i < all.size(); ++i) {
      if (std::abs(all[i].second - all[i - 1].second) > 0.002) last = all[i].first;
    }
    return last;
  }
};

TEST_F(OperatorTest, DrivesByHandAndTheVehicleStandsWhenTheKeyboardProcessIsKilled) {
  Stack stack({"teleop.yaml", "--seed", "1"});
  ASSERT_TRUE(Stack::eventually(seconds(40), [&] { return !way(stack).empty(); }));
  const OperatorProcess keyboard(verb(stack, {"teleop", "keyboard"}), stack.folder() + "/keys.out");
  ASSERT_TRUE(drive(stack, keyboard)) << stack.output() << stack.read("keys.out");
  const double killed = wall_s();
  keyboard.kill_all();
  ASSERT_TRUE(
      Stack::eventually(seconds(20), [&] { return has_recorded_until(stack, killed + 4); }));
  const double stopping_s = stopped_at(stack) - killed;
  std::printf("keyboard process killed at 0.3 m/s: the vehicle stands after %.1f s\n", stopping_s);
  EXPECT_LT(stopping_s, 2.5);
}

TEST_F(OperatorTest, TheEmergencyStopHoldsOverADeathOfTheVehiclesProcessesAndIsReleased) {
  Stack stack({"mission.yaml", "--seed", "1", "--without", "uxv/payload"});
  ASSERT_TRUE(Stack::eventually(seconds(60), [&] { return moved(stack, 0.3); })) << stack.output();
  ASSERT_EQ(run(stack, {"estop", "on"}), 0) << stack.read("command.out");
  const double pressed = wall_s();
  kill(stack.pid("uxv/drive"), SIGKILL);
  kill(stack.pid("gcs/link"), SIGKILL);
  ASSERT_TRUE(
      Stack::eventually(seconds(30), [&] { return has_recorded_until(stack, pressed + 6); }));
  EXPECT_LT(stopped_at(stack) - pressed, 1.0);
  EXPECT_EQ(run(stack, {"estop", "status"}), 0);
  EXPECT_THAT(stack.read("command.out"), HasSubstr("ON; vehicle stands by emergency stop"));
  ASSERT_EQ(run(stack, {"estop", "off"}), 0) << stack.read("command.out");
  const double released = wall_s();
  EXPECT_TRUE(Stack::eventually(seconds(40), [&] { return stopped_at(stack) > released + 1; }));
}

TEST_F(OperatorTest, DocksByOrderInVirtualTime) {
  for (const char* seed : {"1", "2", "3"}) {
    const TemporaryFolder folder;
    OperatorProcess sim({Stack::program("tocsin-sim"), "dock.yaml", "--seed", seed, "--run-dir",
                         folder.path("run")},
                        folder.path("out"));
    EXPECT_EQ(sim.exit_code(seconds(60)), 0);
    EXPECT_THAT(folder.read("out"), HasSubstr("docking docked")) << "seed " << seed;
  }
}

TEST_F(OperatorTest, CancelsDocking) {
  // A computer that stalls for half a second ends docking, too.
  Stack stack({"teleop.yaml", "--seed", "1", "--set", "auto_docking.silence_s=10"});
  ASSERT_TRUE(Stack::eventually(seconds(40), [&] { return !way(stack).empty(); }));
  const OperatorProcess dock(verb(stack, {"dock", "start"}), stack.folder() + "/dock.out");
  ASSERT_TRUE(Stack::eventually(seconds(40), [&] {
    return stack.read("dock.out").find("aligned") != std::string::npos;
  })) << stack.read("dock.out");
  EXPECT_EQ(run(stack, {"dock", "cancel"}), 0);
  EXPECT_THAT(stack.read("command.out"), HasSubstr("docking cancelled"));
}

TEST_F(OperatorTest, SaysThatNothingRuns) {
  OperatorProcess order({Stack::program("tocsin-estop"), "on", "--run-dir", "/nowhere"},
                        "/dev/null");
  EXPECT_EQ(order.exit_code(seconds(10)), 1);
}

}  // namespace
}  // namespace tocsin
