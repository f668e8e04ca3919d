// SPDX-License-Identifier: Apache-2.0
#include "estop_target.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <memory>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Property;
using ::testing::Throws;

/// In a folder of its own, as runs/ is looked for where the command is given.
class EstopTargetTest : public ::testing::Test {
 protected:
  EstopTargetTest() { fs::current_path(folder_.path()); }
  ~EstopTargetTest() override { fs::current_path(before_); }
  static deployment::Deployment run(const std::string& run_dir) {
    deployment::Deployment deployment;
    deployment.run_dir = run_dir;
    deployment.qos = deployment.traffic = "/gone.yaml";
    deployment.ros_namespace = "robot";
    const auto none = std::make_shared<const YAML::Node>(YAML::NodeType::Map);
    deployment.hosts.push_back({"desk",
                                Role::gcs,
                                "10.0.0.2",
                                {"10.0.0.1"},
                                0,
                                {},
                                {{"link", false, {{"part", "part", none}}}}});
    return deployment;
  }
  static deployment::RunningHosts running(const std::vector<std::string>& folders) {
    deployment::RunningHosts all;
    for (const std::string& folder : folders) all.hosts.push_back({run(folder), "desk", 77});
    return all;
  }
  static std::vector<std::string> names(const std::vector<EstopTarget>& targets) {
    std::vector<std::string> all;
    for (const EstopTarget& one : targets) all.push_back(one.name);
    return all;
  }

  const fs::path before_ = fs::current_path();
  const TemporaryFolder folder_;
  EstopOptions options_;
};

TEST_F(EstopTargetTest, IsTheStationThatRunsWithAllThatItsProcessesTell) {
  const auto sut = find_targets(options_, Among::only_one, running({"/a"}));
  ASSERT_EQ(sut.size(), 1U);
  EXPECT_EQ(sut[0].process, 77);
  EXPECT_EQ(sut[0].bus.link_address, "10.0.0.2");
  EXPECT_THAT(sut[0].bus.link_peers, ElementsAre("10.0.0.1"));
  EXPECT_EQ(sut[0].bus.ros_namespace, "robot");
  EXPECT_EQ(sut[0].bus.link_domain, 2);
  EXPECT_EQ(sut[0].bus.qos_file, "");
  EXPECT_EQ(sut[0].bus.traffic_file, "");
}

TEST_F(EstopTargetTest, AStopGoesToAllStationsThatRunAndAReleaseToOneOrToAllThatAreMeant) {
  EXPECT_THAT(names(find_targets(options_, Among::all, running({"/a", "/b"}))),
              ElementsAre("/a", "/b"));
  EXPECT_THAT(
      [&] {
        (void)find_targets(options_, Among::only_one, running({"/a", "/b"}));
      },
      Throws<ConfigError>(
          Property(&ConfigError::what, HasSubstr("choose --run-dir /a, --run-dir /b, or --all"))));
  EXPECT_THAT(names(find_targets(options_, Among::only_one, running({"/a"}))), ElementsAre("/a"));
  options_.all = true;
  EXPECT_THAT(names(find_targets(options_, Among::only_one, running({"/a", "/b"}))),
              ElementsAre("/a", "/b"));
  options_.all = false;
  options_.join.run_dir = "/b";
  for (const Among among : {Among::all, Among::only_one}) {
    EXPECT_THAT(names(find_targets(options_, among, running({"/a", "/b"}))), ElementsAre("/b"));
  }
}

TEST_F(EstopTargetTest, AStopGoesToEachVehicleOfAStationAndAReleaseToOneOrToAllThatAreMeant) {
  deployment::Deployment fleet = run("/a");
  fleet.vehicles = {"uxv1", "uxv2"};
  fleet.hosts[0].peers = {"10.0.0.1", "10.0.0.3"};
  deployment::RunningHosts stations;
  stations.hosts.push_back({fleet, "desk", 77});
  const auto all = find_targets(options_, Among::all, stations);
  EXPECT_THAT(names(all), ElementsAre("/a uxv1", "/a uxv2"));
  EXPECT_EQ(all[1].bus.ros_namespace, "robot/uxv2");
  EXPECT_THAT(all[1].bus.link_peers, ElementsAre("10.0.0.3"));
  EXPECT_EQ(all[1].bus.link_domain, 3);
  EXPECT_THAT([&] { (void)find_targets(options_, Among::only_one, stations); },
              Throws<ConfigError>(Property(
                  &ConfigError::what,
                  HasSubstr("choose --run-dir /a --vehicle uxv1, --run-dir /a --vehicle uxv2"))));
  options_.join.vehicle = "uxv2";
  EXPECT_THAT(names(find_targets(options_, Among::only_one, stations)), ElementsAre("/a uxv2"));
  options_.join.vehicle = "uxv3";
  EXPECT_THAT(
      [&] { (void)find_targets(options_, Among::all, stations); },
      Throws<ConfigError>(Property(
          &ConfigError::what, HasSubstr("--vehicle uxv3: host desk serves one of: [uxv1, uxv2]"))));
}

TEST_F(EstopTargetTest, IsTheLastOneHereWhenNoneRuns) {
  for (const char* name : {"runs/1", "runs/2"}) {
    fs::create_directories(folder_.path(name));
    write_resolved(run(folder_.path(name)), folder_.path(name) + "/deployment.yaml");
  }
  fs::create_directories(folder_.path("runs/3"));  // holds none
  const auto sut = find_targets(options_, Among::all, {});
  EXPECT_THAT(names(sut), ElementsAre(HasSubstr("runs/2, which does not run")));
  EXPECT_FALSE(sut[0].process);
  EXPECT_EQ(sut[0].bus.link_address, "10.0.0.2");
  options_.join.run_dir = "runs/1";
  EXPECT_THAT(names(find_targets(options_, Among::all, {})), ElementsAre(HasSubstr("runs/1")));
}

TEST_F(EstopTargetTest, AReleaseAsksWhichVehicleOfAStationThatDoesNotRunAnyMore) {
  deployment::Deployment fleet = run(folder_.path("runs/1"));
  fleet.vehicles = {"uxv1", "uxv2"};
  fleet.hosts[0].peers = {"10.0.0.1", "10.0.0.3"};
  fs::create_directories(folder_.path("runs/1"));
  write_resolved(fleet, folder_.path("runs/1/deployment.yaml"));
  EXPECT_EQ(find_targets(options_, Among::all, {}).size(), 2U);
  EXPECT_THAT([&] { (void)find_targets(options_, Among::only_one, {}); },
              Throws<ConfigError>(Property(&ConfigError::what, HasSubstr("--vehicle uxv2"))));
  options_.all = true;
  EXPECT_EQ(find_targets(options_, Among::only_one, {}).size(), 2U);
}

TEST_F(EstopTargetTest, AStationWithARouterIsAskedWhileItRunsAndReplacedWhenItDoesNot) {
  auto station = run(folder_.path("runs/1"));
  station.hosts[0].containers[0].components[0].component = "link_router";
  deployment::RunningHosts all;
  all.hosts.push_back({station, "desk", 77});
  const auto runs = find_targets(options_, Among::all, all);
  EXPECT_FALSE(runs[0].needs_router) << "its own router speaks on the link";
  EXPECT_FALSE(runs[0].needs_router);
  fs::create_directories(folder_.path("runs/1"));
  write_resolved(station, folder_.path("runs/1/deployment.yaml"));
  const auto ran = find_targets(options_, Among::all, {});
  EXPECT_TRUE(ran[0].needs_router);
  EXPECT_EQ(ran[0].bus.traffic_file, "/gone.yaml");
  EXPECT_EQ(ran[0].bus.host, "estop");
}

TEST_F(EstopTargetTest, AnEmulatedRadioThatHasEndedIsNoTarget) {
  auto emulated = run(folder_.path("runs/1"));
  emulated.radio = deployment::Radio{"/c.yaml", "/w.yaml"};
  emulated.hosts.push_back(emulated.hosts.front());
  emulated.hosts[1].name = "uxv";
  emulated.hosts[1].role = Role::uxv;
  fs::create_directories(folder_.path("runs/1"));
  write_resolved(emulated, folder_.path("runs/1/deployment.yaml"));
  EXPECT_THROW((void)find_targets(options_, Among::all, {}), EnvironmentError);
}

TEST_F(EstopTargetTest, SaysWhatToDoWhenNothingIsFound) {
  EXPECT_THAT(
      [&] { (void)find_targets(options_, Among::all, {}); },
      Throws<EnvironmentError>(Property(
          &EnvironmentError::what, HasSubstr("no host gcs runs on this computer; --link-domain"))));
}

TEST_F(EstopTargetTest, TheDomainsOfTheOptionsAreTakenInPlaceOfARun) {
  options_.domain = 41;
  const auto host = find_targets(options_, Among::all, running({"/a"}));
  ASSERT_EQ(host.size(), 1U);
  EXPECT_EQ(host[0].bus.host_domain, 41);
  EXPECT_EQ(host[0].bus.link_address, "");
  EXPECT_FALSE(host[0].process);
}

TEST_F(EstopTargetTest, TheLinkOfTheOptionsReachesTheVehicleAndNoOtherStation) {
  options_.link_domain = 42;
  options_.address = "10.0.0.2";
  options_.peers = {"10.0.0.1"};
  const auto link = find_targets(options_, Among::only_one, {});
  EXPECT_EQ(link[0].bus.link_domain, 42);
  EXPECT_EQ(link[0].bus.host_domain, 231);
  EXPECT_TRUE(link[0].needs_router) << "the vehicle listens to routers only";
  EXPECT_THAT(link[0].bus.traffic_file, HasSubstr("config/traffic.yaml"));
  options_.link_domain = 231;
  EXPECT_EQ(find_targets(options_, Among::only_one, {})[0].bus.host_domain, 230);
  options_.peers.clear();
  EXPECT_THROW((void)find_targets(options_, Among::only_one, {}), ConfigError);
}

}  // namespace
}  // namespace tocsin
