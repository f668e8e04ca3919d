// SPDX-License-Identifier: Apache-2.0
// Two vehicles and their station with all their processes, on one emulated channel.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "foundation/temporary_folder.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class FleetTest : public ::testing::Test {
 protected:
  /// `mission_s`: about how long each of them drives.
  void launch(int mission_s) {
    files_.write("mission.yaml", mission(mission_s));
    const std::string fleet = files_.write(
        "fleet.yaml",
        "extends: fleet.yaml\nvariables: {mission: ./mission.yaml}\n"
        "radio: {channel: \"${share}/config/radio/open.yaml\"}\n"
        "vehicles:\n  uxv3: {variables: {mission: ./mission.yaml}}\n  uxv2: ~\n  uxv4: ~\n"
        "  uxv5: ~\n");
    stack_.emplace(std::vector<std::string>{fleet, "--without", "page", "--without", "camera"});
  }
  /// To and fro in the classroom, 1 m from where uxv1 begins and 2 m from where uxv3 does.
  static std::string mission(int length_s) {
    std::string text = "name: short\nframe: map\nwaypoints:\n";
    for (int i = 0; i < length_s / 8; ++i) {
      text +=
          i % 2 == 0 ? "  - {x: 1.0, y: -0.4, yaw: 0.0}\n" : "  - {x: 2.5, y: -1.0, yaw: 0.0}\n";
    }
    return text;
  }
  [[nodiscard]] Ended estop(const std::string& order) const {
    return run_to_end(Stack::program("tocsin-estop"), order + " --run-dir " + stack_->folder());
  }
  [[nodiscard]] std::vector<std::string> states(const std::string& vehicle) const {
    return column(stack_->recorded(vehicle + "/gcs", "mission_status"), "state");
  }
  [[nodiscard]] bool is_done(const std::string& vehicle) const {
    const auto all = states(vehicle);
    return !all.empty() && all.back() == "done";
  }
  /// By its last two locations, 0.2 s apart.
  [[nodiscard]] bool drives(const std::string& vehicle) const {
    return moves_in(stack_->recorded(vehicle + "/uxv", "location"));
  }
  [[nodiscard]] std::set<std::string> places(const std::string& side) const {
    const auto all = column(stack_->recorded(side, "location"), "pose.pose.position.x");
    return {all.begin(), all.end()};
  }

  const TemporaryFolder files_;
  std::optional<Stack> stack_;
};

TEST_F(FleetTest, EachDrivesItsMissionAndTheRunEndsWithTheLast) {
  launch(16);
  ASSERT_EQ(stack_->exit_code(seconds(180)), 0) << stack_->output();
  EXPECT_THAT(stack_->output(), HasSubstr("; 1 to go"));
  for (const std::string vehicle : {"uxv1", "uxv3"}) {
    EXPECT_TRUE(is_done(vehicle)) << vehicle << ::testing::PrintToString(states(vehicle));
    const auto own = places(vehicle + "/uxv");
    const auto heard = places(vehicle + "/gcs");
    EXPECT_THAT(heard, Not(IsEmpty())) << vehicle;
    for (const std::string& place : heard) {
      EXPECT_EQ(own.count(place), 1u) << "the station of " << vehicle << " has another's " << place;
    }
    const auto shares = column(stack_->recorded(vehicle + "/gcs", "airtime_use"), "share");
    ASSERT_FALSE(shares.empty()) << vehicle << " was told no share of the air";
    EXPECT_GT(std::stod(shares.back()), 0);
    EXPECT_LT(std::stod(shares.back()), 1) << "while there are two";
  }
}

TEST_F(FleetTest, AStopIsForTheVehicleThatItNames) {
  launch(32);
  ASSERT_TRUE(Stack::eventually(seconds(60), [&] { return drives("uxv1") && drives("uxv3"); }))
      << stack_->output();
  ASSERT_EQ(estop("on --vehicle uxv1").code, 0);
  EXPECT_TRUE(Stack::eventually(seconds(5), [&] { return !drives("uxv1"); }));
  EXPECT_TRUE(Stack::eventually(seconds(5), [&] { return drives("uxv3"); }));
  const Ended unclear = estop("off");
  EXPECT_EQ(unclear.code, 2);
  EXPECT_THAT(unclear.output, HasSubstr("--vehicle uxv1"));
  ASSERT_TRUE(Stack::eventually(seconds(120), [&] { return is_done("uxv3"); })) << stack_->output();
  EXPECT_FALSE(is_done("uxv1"));
  EXPECT_FALSE(drives("uxv1"));
  ASSERT_EQ(estop("off --vehicle uxv1").code, 0);
  EXPECT_EQ(stack_->exit_code(seconds(120)), 0) << stack_->output();
}

/// As on three computers, which share the loopback.
TEST_F(FleetTest, HostsThatAreLaunchedAloneMeet) {
  files_.write("mission.yaml", mission(16));
  const std::string fleet = files_.write(
      "fleet.yaml",
      "extends: fleet.yaml\ndomain: 90\nvariables: {mission: ./mission.yaml}\nvehicles:\n"
      "  uxv1: {address: 127.0.0.1}\n  uxv2: ~\n"
      "  uxv3: {address: 127.0.0.1, variables: {mission: ./mission.yaml}}\n"
      "  uxv4: ~\n  uxv5: ~\n"
      "hosts: {uxv: {peers: [127.0.0.1]}, gcs: {address: 127.0.0.1}}\n");
  const auto alone = [&](const char* host) {
    return std::vector<std::string>{fleet,  "--host",    host,    "--without",
                                    "page", "--without", "camera"};
  };
  const Stack first(alone("uxv1"));
  const Stack second(alone("uxv3"));
  Stack station({fleet, "--host", "gcs", "--without", "page"});
  EXPECT_EQ(station.exit_code(seconds(120)), 0) << station.output();
  for (const std::string vehicle : {"uxv1", "uxv3"}) {
    const Stack& its = vehicle == "uxv1" ? first : second;
    const auto own = column(its.recorded(vehicle + "/uxv", "location"), "pose.pose.position.x");
    const auto heard =
        column(station.recorded(vehicle + "/gcs", "location"), "pose.pose.position.x");
    EXPECT_THAT(heard, Not(IsEmpty())) << vehicle;
    const std::set<std::string> places(own.begin(), own.end());
    for (const std::string& place : heard) EXPECT_EQ(places.count(place), 1u) << vehicle;
  }
}

}  // namespace
}  // namespace tocsin
