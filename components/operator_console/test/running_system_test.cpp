// SPDX-License-Identifier: Apache-2.0
#include "running_system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

class RunningSystemTest : public ::testing::Test {
 protected:
  static deployment::Deployment two_hosts() {
    deployment::Deployment deployment;
    deployment.hosts.resize(2);
    deployment.hosts[0].name = "vehicle";
    deployment.hosts[0].role = "uxv";
    deployment.hosts[1].name = "station";
    deployment.hosts[1].role = "gcs";
    deployment.hosts[1].containers.resize(1);
    deployment.hosts[1].containers[0].name = "view";
    deployment.hosts[1].containers[0].terminal = true;
    return deployment;
  }
  const TemporaryFolder temporary_;
  const std::string folder_ = temporary_.path();
};

TEST_F(RunningSystemTest, FindsTheNewestRun) {
  for (const char* run : {"20260101T000000Z", "20260102T000000Z"}) {
    fs::create_directories(folder_ + "/" + run);
    std::ofstream(folder_ + "/" + run + "/processes.json") << "{}";
  }
  fs::create_directories(folder_ + "/20260103T000000Z");  // holds no run
  EXPECT_EQ(newest_run(folder_), folder_ + "/20260102T000000Z");
}

TEST_F(RunningSystemTest, SaysWhenThereIsNoRun) {
  EXPECT_THROW((void)newest_run(folder_), EnvironmentError);
  EXPECT_THROW((void)newest_run("/nowhere"), EnvironmentError);
  EXPECT_THROW((void)run_guest({folder_, "gcs"}, {"teleop_keyboard", {}}), EnvironmentError);
}

TEST_F(RunningSystemTest, AddsAContainerToTheHostThatIsNamed) {
  const auto joined =
      with_guest(two_hosts(), "gcs", {"teleop_keyboard", {"linear_mps=0.2", "layout=turtlebot"}});
  EXPECT_TRUE(joined.hosts[0].containers.empty());
  ASSERT_EQ(joined.hosts[1].containers.size(), 2U);
  EXPECT_FALSE(joined.hosts[1].containers[0].terminal);
  const deployment::Container& guest = joined.hosts[1].containers[1];
  EXPECT_EQ(guest.name.rfind("console_", 0), 0U);
  EXPECT_EQ(guest.components[0].component, "teleop_keyboard");
  EXPECT_EQ((*guest.components[0].parameters)["linear_mps"].as<double>(), 0.2);
}

TEST_F(RunningSystemTest, WritesWhatTheContainerReadsAgain) {
  const std::string text =
      "qos: q.yaml\ntraffic: t.yaml\ndomain: 10\nhosts:\n  station:\n    role: gcs\n    address: "
      "10.0.0.2\n    peers: []\n"
      "    containers:\n      - name: view\n        components: [live_view]\n";
  for (const char* name : {"q.yaml", "t.yaml"}) std::ofstream(folder_ + "/" + name) << "{}\n";
  std::ofstream(folder_ + "/bringup.yaml") << text;
  deployment::Overrides overrides;
  overrides.run_dir = overrides.share = folder_;
  const auto loaded = deployment::load_deployment(folder_ + "/bringup.yaml", overrides);
  const std::string file = folder_ + "/operator.yaml";
  deployment::write_resolved(with_guest(loaded, "gcs", {"teleop_keyboard", {"rate_hz=20"}}), file);
  const auto read = deployment::load_resolved(file);
  ASSERT_EQ(read.hosts[0].containers.size(), 2U);
  EXPECT_EQ((*read.hosts[0].containers[1].components[0].parameters)["rate_hz"].as<int>(), 20);
}

TEST_F(RunningSystemTest, RefusesWrongSettingsAndAbsentHosts) {
  EXPECT_THROW((void)with_guest(two_hosts(), "gcs", {"teleop_keyboard", {"layout"}}), ConfigError);
  EXPECT_THROW((void)with_guest(two_hosts(), "gcs", {"teleop_keyboard", {"a=[1"}}), ConfigError);
  auto vehicle_only = two_hosts();
  vehicle_only.hosts.pop_back();
  EXPECT_THROW((void)with_guest(vehicle_only, "gcs", {"teleop_keyboard", {}}), ConfigError);
}

}  // namespace
}  // namespace tocsin
