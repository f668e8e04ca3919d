// SPDX-License-Identifier: Apache-2.0
// The emergency stop when everything else fails: real processes, real DDS, an emulated radio, and
// the wheels watched by a peer that needs none of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <thread>

#include "emergency_stop_rig.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;
using ::testing::HasSubstr;

/// As a peer at the station, on the link too.
BusOptions station_domains(int domain) {
  BusOptions options = on_host(domain + 1);
  options.link_domain = domain + 2;
  options.link_address = "10.77.0.2";
  options.link_peers = {"10.77.0.1"};
  return options;
}

TEST_F(EmergencyStopTest, WorksOnAFullDisk) {
  drive({}, 24);
  stack_->fill_disk("fill");
  ASSERT_TRUE(Stack::eventually(seconds(10), [&] { return stack_->logged("DISK FULL"); }))
      << stack_->output();
  EXPECT_EQ(estop({"on"}), 0) << said();
  EXPECT_TRUE(stands());
  const pid_t before = stack_->pid("uxv/drive");
  ASSERT_NE(before, 0) << "the list of processes is lost";
  kill(before, SIGKILL);
  kill(stack_->pid("gcs/link"), SIGKILL);
  kill(stack_->pid("uxv/recorder"), SIGKILL);
  EXPECT_TRUE(stands()) << stack_->output();
  EXPECT_EQ(stack_->pid("uxv/drive"), before);  // the old list, whole
  EXPECT_EQ(estop({"off"}), 0) << said();
  EXPECT_TRUE(moves());
  fs::remove(stack_->path("fill"));
  EXPECT_TRUE(Stack::eventually(seconds(10), [&] { return stack_->logged("has room again"); }));
  EXPECT_TRUE(Stack::eventually(seconds(10), [&] { return stack_->pid("uxv/drive") != before; }));
  EXPECT_TRUE(Stack::eventually(seconds(10), [&] {
    return fs::exists(stack_->path("uxv/bag_2/metadata.yaml"));
  })) << stack_->output();
}

TEST_F(EmergencyStopTest, WorksWithoutARunFolder) {
  drive();
  const pid_t vehicle = stack_->pid("uxv/drive");
  ASSERT_TRUE(stack_->remove_folder());
  EXPECT_EQ(estop({"on"}), 0) << said();
  EXPECT_TRUE(stands());
  EXPECT_EQ(estop({"status"}), 0);
  EXPECT_THAT(said(), HasSubstr("emergency stop ON; vehicle stands by emergency stop of: station"));
  kill(vehicle, SIGKILL);
  EXPECT_EQ(estop({"status", "--wait", "10"}), 0) << said();
  EXPECT_TRUE(Stack::eventually(seconds(5), [&] { return stack_->logged("RUN FOLDER GONE"); }))
      << stack_->output();
}

TEST_F(EmergencyStopTest, HoldsOverTheDeathOfEachOfItsTwoProcesses) {
  drive();
  ASSERT_EQ(estop({"on"}), 0) << said();
  EXPECT_TRUE(stands());
  kill(stack_->pid("gcs/link"), SIGKILL);
  EXPECT_TRUE(stands());
  stack_->control("radio.sock", "set outage 8");  // the new vehicle process hears nobody
  kill(stack_->pid("uxv/drive"), SIGKILL);
  EXPECT_TRUE(stands());
  std::this_thread::sleep_for(seconds(5));
  EXPECT_EQ(estop({"status", "--wait", "20"}), 0);
  EXPECT_THAT(said(), HasSubstr("emergency stop ON; vehicle stands"));
  EXPECT_EQ(estop({"off", "--wait", "20"}), 0) << said();
  EXPECT_TRUE(moves());
}

TEST_F(EmergencyStopTest, AnotherPeersFalseDoesNotReleaseIt) {
  drive();
  ASSERT_EQ(estop({"on"}), 0) << said();
  Peer at_vehicle(stack_->running("uxv/recorder"), on_host(domain),
                  repeat<topic::EmergencyStop>(word(false)));
  Peer at_station(stack_->running("gcs/recorder"), station_domains(domain),
                  repeat<topic::EmergencyStop>(word(false)));
  EXPECT_TRUE(stands());
  EXPECT_EQ(estop({"status"}), 0);
  EXPECT_THAT(said(), HasSubstr("of: station"));
  EXPECT_EQ(estop({"off"}), 0) << said();
  EXPECT_TRUE(moves());
}

TEST_F(EmergencyStopTest, AnybodyMayStopAndWhatTheDeadLeftIsReleasedAtTheVehicle) {
  drive();
  Peer button(stack_->running("uxv/recorder"), on_host(domain),
              repeat<topic::EmergencyStop>(word(true)));
  ASSERT_TRUE(stands());
  EXPECT_EQ(estop({"off", "--wait", "2"}), 1);
  EXPECT_THAT(said(), HasSubstr("still stands by the emergency stop of: peer"));
  button.kill();
  EXPECT_TRUE(stands());
  EXPECT_EQ(estop({"off", "--wait", "2"}), 1) << said();
  // It is known to be gone after the lease of its participant.
  EXPECT_TRUE(Stack::eventually(seconds(15), [&] {
    return estop({"off", "--host", "uxv", "--wait", "2"}) == 0;
  })) << said();
  EXPECT_TRUE(moves());
}

TEST_F(EmergencyStopTest, WorksAtThirtyPercentLoss) {
  drive();
  stack_->control("radio.sock", "set mode bernoulli");
  stack_->control("radio.sock", "set loss 0.3");
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(estop({"on"}), 0) << said();
    EXPECT_TRUE(stands());
    EXPECT_EQ(estop({"off"}), 0) << said();
    EXPECT_TRUE(moves());
  }
}

TEST_F(EmergencyStopTest, SaysSoWhenTheLauncherWasKilledAndNothingRuns) {
  drive();
  kill(stack_->launcher(), SIGKILL);
  (void)stack_->exit_code(seconds(5));
  EXPECT_EQ(estop({"on"}), 1);
  EXPECT_THAT(said(), HasSubstr("no host gcs runs on this computer"));
}

/// The two sides of the main job as two launches that meet on the loopback.
class TwoLaunchesTest : public EmergencyStopTest {
 protected:
  static constexpr int domain = 60;
  [[nodiscard]] std::string side(const std::string& role, const std::string& others) const {
    const std::string other = role == "uxv" ? "gcs" : "uxv";
    return files_.write(role + ".yaml", "extends: mission.yaml\ndomain: " + std::to_string(domain) +
                                            "\nradio: ~\n" +
                                            (role == "uxv" ? "stop_when_exits: ~\n" : "") +
                                            "hosts:\n  " + other + ": ~\n  " + role +
                                            ":\n    address: 127.0.0.1\n    peers: [127.0.0.1]\n"
                                            "    containers: [recorder: ~, " +
                                            others + "]\n");
  }
  const TemporaryFolder files_;
  std::optional<Stack> station_;
};

TEST_F(TwoLaunchesTest, TheStopReachesAVehicleWhoseStationWasKilled) {
  stack_.emplace(std::vector<std::string>{side("uxv", "payload: ~")});
  station_.emplace(std::vector<std::string>{side("gcs", "view: ~")});
  wheels_ = stack_->scratch() + "/wheels";
  ASSERT_TRUE(Stack::eventually(seconds(30), [&] { return stack_->pid("uxv/drive") != 0; }))
      << stack_->output();
  watch_.emplace(stack_->running("uxv/drive"), on_host(domain), watch_wheels(wheels_));
  ASSERT_TRUE(moves()) << stack_->output() << station_->output();
  kill(station_->launcher(), SIGKILL);
  (void)station_->exit_code(seconds(5));
  ASSERT_TRUE(moves());
  EXPECT_EQ(estop({"on", "--link-domain", std::to_string(domain + 2), "--address", "127.0.0.1",
                   "--peer", "127.0.0.1"}),
            0)
      << said();
  EXPECT_THAT(said(), HasSubstr("told directly"));
  EXPECT_TRUE(stands());
  EXPECT_EQ(estop({"off", "--run-dir", station_->folder()}), 0) << said();
  EXPECT_TRUE(moves());
}

TEST_F(EmergencyStopTest, AForeignGoalWithTheLargestIdDoesNotBlockTheMission) {
  drive();
  topic::Goal::Message goal;
  goal.id(std::numeric_limits<std::uint64_t>::max());
  goal.mission(std::numeric_limits<std::uint64_t>::max());
  goal.x(-1);
  goal.tolerance_m(0.1);
  goal.lifetime_s(3600);
  {
    const Peer foreign(stack_->running("gcs/recorder"), station_domains(domain),
                       repeat<topic::Goal>(goal));
    const std::string largest = std::to_string(goal.id());
    ASSERT_TRUE(Stack::eventually(seconds(20), [&] {
      return stack_->read("log/uxv.drive.log").find("goal " + largest + ": driving") !=
             std::string::npos;
    })) << stack_->read("log/uxv.drive.log");
  }
  const std::size_t before = column(stack_->recorded("uxv", "navigation_status"), "goal_id").size();
  EXPECT_TRUE(Stack::eventually(seconds(20), [&] {
    const auto ids = column(stack_->recorded("uxv", "navigation_status"), "goal_id");
    return ids.size() > before && ids.back() == "1";
  }));
}

}  // namespace
}  // namespace tocsin
