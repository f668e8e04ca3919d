// SPDX-License-Identifier: Apache-2.0
// What tocsin decide takes from the run that a file was recorded in.
#include "recorded_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "quality_trace.hpp"

namespace tocsin::tools {
namespace {

using ::testing::HasSubstr;

/// The deployment of a run with a controller on each side.
std::string deployment_of(const std::string& uxv, const std::string& gcs) {
  const auto host = [](const std::string& role, const std::string& address,
                       const std::string& parameters) {
    return "  " + role + ":\n    role: " + role + "\n    address: " + address +
           "\n    containers:\n      - name: link\n        components:\n" +
           "          - component: transmission_controller\n            parameters: {" +
           parameters + "}\n";
  };
  return "qos: qos.yaml\ntraffic: traffic.yaml\nhosts:\n" + host("uxv", "10.0.0.1", uxv) +
         host("gcs", "10.0.0.2", gcs);
}

class RecordedRunTest : public ::testing::Test {
 protected:
  RecordedRunTest() { std::filesystem::create_directory(folder.path("uxv")); }
  void deploy(const std::string& uxv, const std::string& gcs) {
    folder.write("deployment.yaml", deployment_of(uxv, gcs));
  }
  [[nodiscard]] std::string error_of(std::optional<Role> role) const {
    try {
      (void)controller_of_run(folder.path("uxv/a.csv"), role);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  TemporaryFolder folder;
};

TEST_F(RecordedRunTest, FindsTheDeploymentInTheFolderAboveAndBeside) {
  EXPECT_FALSE(controller_of_run(folder.path("uxv/a.csv"), Role::uxv));
  deploy("alpha: 2", "alpha: 3");
  EXPECT_EQ((*controller_of_run(folder.path("uxv/a.csv"), Role::uxv)->values)["alpha"].as<int>(),
            2);
  EXPECT_EQ((*controller_of_run(folder.path("a.csv"), Role::gcs)->values)["alpha"].as<int>(), 3);
}

TEST_F(RecordedRunTest, TakesNoDeploymentAboveAFolderThatIsNoRolesOwn) {
  deploy("alpha: 2", "alpha: 3");
  EXPECT_FALSE(controller_of_run(folder.path("somewhere/a.csv"), Role::uxv));
}

TEST_F(RecordedRunTest, NeedsARoleOnlyWhenTheControllersDecideDifferently) {
  deploy("alpha: 2", "alpha: 2, silence_is_poor: true");
  EXPECT_EQ(error_of({}), "no error");
  folder.write("deployment.yaml", deployment_of("alpha: 2", "weight_per: 0.5"));
  EXPECT_THAT(error_of({}), HasSubstr("of uxv and gcs in "));
  EXPECT_THAT(error_of({}), HasSubstr("choose one by --host"));
  EXPECT_EQ(error_of(Role::gcs), "no error");
}

TEST_F(RecordedRunTest, NamesTheDeploymentThatHasNoController) {
  folder.write("deployment.yaml", "hosts: {gcs: {role: gcs, containers: []}}\n");
  EXPECT_THAT(error_of(Role::uxv),
              HasSubstr("deployment.yaml: has no transmission_controller of role uxv"));
}

TEST_F(RecordedRunTest, NamesARoleThatIsNone) {
  folder.write("deployment.yaml",
               "hosts: {a: {role: base, containers: [{components: "
               "[{component: transmission_controller, parameters: {}}]}]}}\n");
  EXPECT_THAT(error_of({}), HasSubstr("deployment.yaml: role 'base' is not uxv or gcs"));
}

TEST_F(RecordedRunTest, NamesTheDeploymentThatCannotBeRead) {
  for (const char* text : {"hosts: [\n", "hosts:\n  uxv: 7\n", "hosts:\n  - 7\n",
                           "hosts: {uxv: {containers: [{components: [{component: [1]}]}]}}\n"}) {
    folder.write("deployment.yaml", text);
    EXPECT_THAT(error_of(Role::uxv), HasSubstr("deployment.yaml")) << text;
  }
}

TEST_F(RecordedRunTest, NeedsNoneOfTheFilesThatTheRunWasStartedWith) {
  deploy("alpha: 2", "alpha: 2");  // its qos.yaml is not there
  EXPECT_EQ(error_of(Role::uxv), "no error");
}

TEST_F(RecordedRunTest, WeighsRecordedNetworkQualityAsTheRunDid) {
  const std::string text = "receive_s,per_percent,signal_dbm,quality_percent\n5,0,-99,0\n";
  const std::string path = folder.write("uxv/network_quality.csv", text);
  EXPECT_EQ(read_quality_trace(path, {}).qni, std::vector<double>{40});
  deploy("weight_per: 1, weight_signal: 0, weight_quality: 0",
         "weight_per: 1, weight_signal: 0, weight_quality: 0");
  EXPECT_EQ(read_quality_trace(path, {}).qni, std::vector<double>{100});
}

TEST_F(RecordedRunTest, TakesTheScaleOfTheLinkQualityAsTheRunDid) {
  const std::string text = "receive_s,per_percent,signal_dbm,quality_percent\n5,0,-99,50\n";
  const std::string path = folder.write("uxv/network_quality.csv", text);
  deploy("quality_best: 35", "quality_best: 35");  // half of the 70 of /proc/net/wireless
  EXPECT_EQ(read_quality_trace(path, {}).qni, std::vector<double>{70});
}

}  // namespace
}  // namespace tocsin::tools
