// SPDX-License-Identifier: Apache-2.0
#include "running_system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <yaml-cpp/yaml.h>

#include <fstream>

#include "deployment/resolved_copy.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using ::testing::Property;
using ::testing::Throws;

class RunningSystemTest : public ::testing::Test {
 protected:
  static deployment::Deployment two_hosts() {
    deployment::Deployment deployment;
    deployment.hosts.resize(2);
    deployment.hosts[0].name = "vehicle";
    deployment.hosts[0].role = Role::uxv;
    deployment.hosts[1].name = "station";
    deployment.hosts[1].role = Role::gcs;
    deployment.hosts[1].containers.resize(1);
    deployment.hosts[1].containers[0].name = "view";
    deployment.hosts[1].containers[0].terminal = true;
    return deployment;
  }
  /// Both hosts of runs with these folders.
  static deployment::RunningHosts running(const std::vector<std::string>& folders) {
    deployment::RunningHosts all;
    for (const std::string& folder : folders) {
      deployment::Deployment deployment = two_hosts();
      deployment.run_dir = folder;
      all.hosts.push_back({deployment, "vehicle", 10});
      all.hosts.push_back({deployment, "station", 11});
    }
    return all;
  }
  const TemporaryFolder temporary_;
  const std::string folder_ = temporary_.path();
};

TEST_F(RunningSystemTest, JoinsTheOnlyRunThatHasTheRole) {
  const auto joined = host_to_join({"", "gcs"}, running({"/a"}));
  EXPECT_EQ(joined.host, "station");
  EXPECT_EQ(host_to_join({"", "uxv"}, running({"/a"})).host, "vehicle");
}

TEST_F(RunningSystemTest, ChoosesAmongSeveralByTheirFolder) {
  EXPECT_EQ(host_to_join({"/b", "gcs"}, running({"/a", "/b"})).deployment.run_dir, "/b");
  EXPECT_EQ(host_to_join({"/x/../b", "gcs"}, running({"/a", "/b"})).deployment.run_dir, "/b");
  EXPECT_THAT(
      [&] {
        (void)host_to_join({"", "gcs"}, running({"/a", "/b"}));
      },
      Throws<ConfigError>(Property(
          &ConfigError::what, HasSubstr("one of: --run-dir /a --host station, --run-dir /b"))));
}

TEST_F(RunningSystemTest, SaysWhenNothingRunsOrCannotBeLookedInto) {
  EXPECT_THAT(
      [&] {
        (void)host_to_join({"", "gcs"}, {});
      },
      Throws<EnvironmentError>(
          Property(&EnvironmentError::what, HasSubstr("no host gcs runs on this computer"))));
  EXPECT_THAT(
      [&] {
        (void)host_to_join({"/c", "gcs"}, running({"/a"}));
      },
      Throws<EnvironmentError>(Property(&EnvironmentError::what, HasSubstr("in /c"))));
  deployment::RunningHosts hidden;
  hidden.hidden = {7};
  EXPECT_THAT(
      [&] {
        (void)host_to_join({"", "gcs"}, hidden);
      },
      Throws<EnvironmentError>(
          Property(&EnvironmentError::what, HasSubstr("cannot be looked into"))));
}

TEST_F(RunningSystemTest, AddsAContainerToTheHostOfTheRole) {
  const auto joined = with_guest(two_hosts(), "station",
                                 {"teleop_keyboard", {"linear_mps=0.2", "layout=turtlebot"}});
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
  const deployment::ResolvedCopy copy(
      with_guest(loaded, "station", {"teleop_keyboard", {"rate_hz=20"}}));
  const auto read = deployment::load_resolved(file, copy.path());
  ASSERT_EQ(read.hosts[0].containers.size(), 2U);
  EXPECT_EQ((*read.hosts[0].containers[1].components[0].parameters)["rate_hz"].as<int>(), 20);
}

TEST_F(RunningSystemTest, RefusesWrongSettings) {
  for (const char* wrong : {"layout", "a=[1"}) {
    EXPECT_THROW((void)with_guest(two_hosts(), "station", {"teleop_keyboard", {wrong}}),
                 ConfigError);
  }
}

}  // namespace
}  // namespace tocsin
