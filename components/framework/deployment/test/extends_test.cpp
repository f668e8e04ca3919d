// SPDX-License-Identifier: Apache-2.0
#include <yaml-cpp/yaml.h>

#include <sstream>

#include "fixture.hpp"
#include "foundation/parameters.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

/// Names of the components of a container.
std::vector<std::string> names(const Container& container) {
  std::vector<std::string> all;
  for (const ComponentInstance& one : container.components) all.push_back(one.name);
  return all;
}

/// A user's file `mine/robot.yaml` beside the folder of the base `bringup/m.yaml`.
class ExtendsTest : public DeploymentTest {
 protected:
  ExtendsTest() {
    std::filesystem::create_directories(folder_ / "mine");
    write("bringup/m.yaml", whole);
  }
  [[nodiscard]] Deployment load_own(const std::string& text) const {
    return load_deployment(write("mine/robot.yaml", "extends: ../bringup/m.yaml\n" + text),
                           overrides_);
  }
  [[nodiscard]] std::string error_of_own(const std::string& text) const {
    try {
      (void)load_own(text);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  [[nodiscard]] const YAML::Node& pilot(const Deployment& deployment) const {
    return *deployment.hosts[0].containers[0].components[1].parameters;
  }
};

TEST_F(ExtendsTest, HoldsOnlyWhatDiffers) {
  const Deployment sut = load_own("domain: 60\nrestart: {limit: 5}\n");
  EXPECT_EQ(sut.link_domain, 62);
  EXPECT_EQ(sut.restart.limit, 5);
  EXPECT_EQ(sut.restart.backoff_s, 0.5);
  EXPECT_EQ(sut.ros_namespace, "robot_1");
  EXPECT_EQ(sut.hosts.size(), 2U);
  EXPECT_EQ(sut.file, path("mine/robot.yaml"));
}

TEST_F(ExtendsTest, PathsAreRelativeToTheFileThatSaysThem) {
  write("mine/qos.yaml", "{}");
  const Deployment sut = load_own(
      "qos: qos.yaml\nhosts:\n  uxv:\n    programs: [{name: base, command: [./base, ../x]}]\n");
  EXPECT_EQ(sut.qos, path("mine/qos.yaml"));
  EXPECT_EQ(sut.traffic, path("traffic.yaml"));
  EXPECT_THAT(sut.hosts[0].programs[0].command, ElementsAre(path("mine/base"), path("x")));
  EXPECT_EQ(pilot(sut)["map"].Scalar(), path("maps/a.yaml"));
}

TEST_F(ExtendsTest, ComponentsContainersAndProgramsAreKnownByName) {
  const Deployment sut = load_own(R"(
hosts:
  uxv:
    programs:
      - {name: lidar, command: [lidar]}
    containers:
      - name: drive
        components:
          - driver: ~
          - {name: pilot, parameters: {gain: 5}}
          - scanner
      - {name: payload, components: [camera]}
)");
  const Host& uxv = sut.hosts[0];
  ASSERT_EQ(uxv.programs.size(), 2U);
  EXPECT_EQ(uxv.programs[0].name, "base");
  EXPECT_EQ(uxv.programs[1].name, "lidar");
  ASSERT_EQ(uxv.containers.size(), 2U);
  EXPECT_THAT(names(uxv.containers[0]), ElementsAre("pilot", "scanner"));
  EXPECT_THAT(names(uxv.containers[1]), ElementsAre("camera"));
  EXPECT_EQ(uxv.containers[0].components[0].component, "navigator");
  EXPECT_EQ((*uxv.containers[0].components[0].parameters)["gain"].as<int>(), 5);
  EXPECT_EQ((*uxv.containers[0].components[0].parameters)["map"].Scalar(), path("maps/a.yaml"));
}

TEST_F(ExtendsTest, TheRadioCanBeTakenAway) {
  EXPECT_FALSE(load_own("radio: ~\n").radio);
  EXPECT_THAT(error_of_own("raido: ~\n"), HasSubstr("raido: there is nothing to remove"));
}

TEST_F(ExtendsTest, ParameterFilesComeAfterTheBases) {
  write("bringup/m.yaml", with(whole, "parameters: []", "parameters: [../a.yaml]"));
  write("a.yaml", "driver: {port: one, rate: 50}");
  write("mine/b.yaml", "driver: {port: two}");
  const Deployment sut = load_own("parameters: [b.yaml]\n");
  const YAML::Node& driver = *sut.hosts[0].containers[0].components[0].parameters;
  EXPECT_EQ(driver["port"].Scalar(), "two");
  EXPECT_EQ(driver["rate"].Scalar(), "50");
}

TEST_F(ExtendsTest, ParametersOfWhatWasTakenAwayAreNoMistake) {
  write("bringup/m.yaml", with(whole, "parameters: []", "parameters: [../a.yaml]"));
  write("a.yaml", "driver: {port: one}\nuxv/pilot: {speed: 1}\nmission_control: {file: x}");
  EXPECT_EQ(error_of_own("hosts:\n  uxv:\n    containers:\n      - name: drive\n        "
                         "components:\n          - driver: ~\n"),
            "no error");
  EXPECT_EQ(error_of_own("stop_when_exits: ~\nhosts:\n  gcs:\n    containers: ~\n"), "no error");
  EXPECT_EQ(error_of_own("stop_when_exits: ~\nradio: ~\nhosts:\n  gcs: ~\n"), "no error");
  overrides_.set = {"driver.port=two"};
  EXPECT_THAT(error_of_own("hosts:\n  uxv:\n    containers:\n      - name: drive\n        "
                           "components:\n          - driver: ~\n"),
              HasSubstr("driver: no such component"));
}

TEST_F(ExtendsTest, AParameterFileMayExtendAShippedOne) {
  std::filesystem::create_directories(folder_ / "share/config");
  overrides_.share = path("share");
  write("share/config/mission.yaml", "driver: {port: '${run_dir}/k', rate: 50}\npilot: {speed: 1}");
  write("mine/robot_parameters.yaml", "extends: mission.yaml\ndriver: {rate: 20}\npilot: ~\n");
  const Deployment sut = load_own("parameters: [robot_parameters.yaml]\n");
  const YAML::Node& driver = *sut.hosts[0].containers[0].components[0].parameters;
  EXPECT_EQ(driver["port"].Scalar(), "/tmp/run/k");
  EXPECT_EQ(driver["rate"].Scalar(), "20");
  EXPECT_FALSE(pilot(sut)["speed"].IsDefined());
}

TEST_F(ExtendsTest, ABareNameIsAShippedBringupFile) {
  std::filesystem::create_directories(folder_ / "share");
  std::filesystem::rename(folder_ / "bringup", folder_ / "share/bringup");
  std::filesystem::create_directories(folder_ / "bringup");
  for (const char* name : {"qos.yaml", "traffic.yaml", "channel.yaml", "walls.yaml"}) {
    write(std::string("share/") + name, "{}");
  }
  overrides_.share = path("share");
  const Deployment sut = load("extends: m.yaml\ndomain: 7\n");
  EXPECT_EQ(sut.link_domain, 9);
  EXPECT_EQ(sut.qos, path("share/qos.yaml"));
}

TEST_F(ExtendsTest, AMistakeIsShownInTheFileThatMadeIt) {
  write("bringup/m.yaml", with(whole, "limit: 3", "limit: 3000"));
  EXPECT_THAT(error_of_own(""), AllOf(HasSubstr("restart.limit: 3000 is outside"),
                                      EndsWith("(" + path("bringup/m.yaml") + ":7)")));
  write("bringup/m.yaml", whole);
  EXPECT_THAT(error_of_own("restart: {limit: 3000}"),
              EndsWith("(" + path("mine/robot.yaml") + ":2)"));
  EXPECT_THAT(error_of_own("hosts:\n  gcs: {rool: gcs}"),
              AllOf(HasSubstr("hosts.gcs.rool: unknown key"), EndsWith("mine/robot.yaml:3)")));
  EXPECT_THAT(error_of_own("hosts:\n  gcs: {role: ~}"),
              AllOf(HasSubstr("hosts.gcs.role: is missing"), EndsWith(":25)")));
}

struct Gain {
  double gain = 1;
  std::string map;
  template <class Visitor>
  void visit(Visitor& v) {
    v("gain", gain, {0, 1}, "[1] gain");
    v("map", map, "map");
  }
};

TEST_F(ExtendsTest, ABadParameterIsShownInTheFileThatSetIt) {
  const auto error = [&](const Deployment& deployment) -> std::string {
    try {
      (void)load_parameters<Gain>(pilot(deployment), "pilot", deployment.sources);
    } catch (const ConfigError& wrong) {
      return wrong.what();
    }
    return "no error";
  };
  EXPECT_THAT(error(load_own("")), EndsWith("(" + path("bringup/m.yaml") + ":22)"));
  EXPECT_THAT(error(load_own("hosts:\n  uxv:\n    containers:\n      - name: drive\n        "
                             "components: [{name: pilot, parameters: {gain: 7}}]")),
              EndsWith("(" + path("mine/robot.yaml") + ":6)"));
  overrides_.set = {"pilot.gain=8"};
  EXPECT_THAT(error(load_own("")), EndsWith("(--set pilot.gain=8)"));
}

TEST_F(ExtendsTest, TheResolvedFileIsTheMergedResultWithTheOriginOfEachParameter) {
  const Deployment merged = load_own(
      "domain: 60\nhosts:\n  uxv:\n    containers:\n      - name: drive\n        "
      "components: [{name: pilot, parameters: {speed: 7}}]");
  write_resolved(merged, path("resolved.yaml"));
  const Deployment sut = load_resolved(path("resolved.yaml"));
  EXPECT_EQ(sut.link_domain, 62);
  EXPECT_EQ(sut.hosts[1].role, Role::gcs);
  std::ostringstream text;
  text << std::ifstream(path("resolved.yaml")).rdbuf();
  EXPECT_THAT(text.str(), AllOf(HasSubstr("gain: 2  # " + path("bringup/m.yaml") + ":22"),
                                HasSubstr("speed: 7  # " + path("mine/robot.yaml") + ":7"),
                                HasSubstr("#   " + path("bringup/m.yaml"))));
}

}  // namespace
}  // namespace tocsin::deployment
