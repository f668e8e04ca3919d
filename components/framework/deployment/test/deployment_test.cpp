// SPDX-License-Identifier: Apache-2.0
#include "deployment/deployment.hpp"

#include "fixture.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST_F(DeploymentTest, ReadsEveryPart) {
  const Deployment sut = load(whole);
  EXPECT_EQ(sut.qos, path("qos.yaml"));
  EXPECT_EQ(sut.traffic, path("traffic.yaml"));
  EXPECT_EQ(sut.ros_namespace, "robot_1");
  EXPECT_EQ(sut.stop_when_exits, "gcs/mission");
  EXPECT_EQ(sut.restart.limit, 3);
  ASSERT_TRUE(sut.radio);
  EXPECT_EQ(sut.radio->walls, path("walls.yaml"));
  ASSERT_EQ(sut.hosts.size(), 2U);
  EXPECT_EQ(sut.hosts[0].role, Role::uxv);
  EXPECT_EQ(sut.hosts[1].address, "10.77.0.2");
  EXPECT_THAT(sut.hosts[0].peers, ElementsAre("10.77.0.2"));
  EXPECT_TRUE(sut.hosts[1].containers[0].terminal);
}

TEST_F(DeploymentTest, NamesAComponentAfterItsLibraryUnlessToldOtherwise) {
  const Deployment sut = load(whole);
  const auto& components = sut.hosts[0].containers[0].components;
  ASSERT_EQ(components.size(), 2U);
  EXPECT_EQ(components[0].component, "driver");
  EXPECT_EQ(components[0].name, "driver");
  EXPECT_EQ(components[1].component, "navigator");
  EXPECT_EQ(components[1].name, "pilot");
}

TEST_F(DeploymentTest, DrivesAVehicleWhenAComponentBeforeTheWheelsRunsSomewhere) {
  EXPECT_FALSE(drives_a_vehicle(load(whole)));
  for (const char* const one :
       {"kobuki_driver", "safety_controller", "velocity_mux", "velocity_smoother"}) {
    EXPECT_TRUE(drives_a_vehicle(load(with(whole, "- driver", std::string("- ") + one)))) << one;
  }
}

TEST_F(DeploymentTest, ReplacesVariablesAndRelativePathsInCommands) {
  const Deployment sut = load(whole);
  EXPECT_THAT(
      sut.hosts[0].programs[0].command,
      ElementsAre("simulator", "--link", "/tmp/run/kobuki", "--seed", "7", path("map.yaml")));
}

TEST_F(DeploymentTest, GivesEachHostAndTheLinkADomainOfItsOwn) {
  const Deployment sut = load(whole);
  EXPECT_EQ(sut.hosts[0].local_domain, 40);
  EXPECT_EQ(sut.hosts[1].local_domain, 41);
  EXPECT_EQ(sut.link_domain, 42);
}

TEST_F(DeploymentTest, TakesTheDomainOfTheCommandLine) {
  overrides_.domain = 90;
  EXPECT_EQ(load(whole).link_domain, 92);
}

TEST_F(DeploymentTest, AllowsDomainsUpTo229) {
  EXPECT_EQ(error_of(with(whole, "domain: 40", "domain: 229")), "no error");
  EXPECT_THAT(error_of(with(whole, "domain: 40", "domain: 230")),
              HasSubstr("deployment.domain: 230 is outside [0, 229]"));
  EXPECT_THAT(error_of(with(whole, "domain: 40", "domain: -1")), HasSubstr("-1 is outside"));
  EXPECT_THAT(error_of(with(whole, "domain: 40", "domain: x")), HasSubstr("not a whole number"));
}

TEST_F(DeploymentTest, RejectsUnknownKeysEverywhereWithTheirLine) {
  EXPECT_THAT(error_of(with(whole, "domain: 40", "domian: 40")),
              HasSubstr("deployment.domian: unknown key; allowed: ["));
  EXPECT_THAT(error_of(with(whole, "domain: 40", "domian: 40")), HasSubstr("m.yaml:3)"));
  EXPECT_THAT(error_of(with(whole, "role: uxv", "role: uxv\n    rool: 1")),
              HasSubstr("hosts.uxv.rool: unknown key; allowed: [role, address, peers"));
  EXPECT_THAT(error_of(with(whole, "terminal: true", "terminl: true")),
              HasSubstr("hosts.gcs.containers.terminl: unknown key"));
  EXPECT_THAT(error_of(with(whole, "{name: base,", "{name: base, x: 1,")),
              HasSubstr("hosts.uxv.programs.x: unknown key"));
  EXPECT_THAT(error_of(with(whole, "name: pilot", "nam: pilot")),
              HasSubstr("hosts.uxv.containers.components.nam: unknown key"));
  EXPECT_THAT(error_of(with(whole, "limit: 3", "limits: 3")), HasSubstr("restart.limits: unknown"));
  EXPECT_THAT(error_of(with(whole, "  walls:", "  wals:")),
              HasSubstr("radio.wals: unknown key; allowed: [channel, walls]"));
}

TEST_F(DeploymentTest, AnUnknownKeyNamesAllKeysOnceAndComesBeforeWhatIsMissing) {
  EXPECT_THAT(error_of(with(whole, "role: uxv", "rol: uxv")),
              HasSubstr("hosts.uxv.rol: unknown key; allowed: [role, address, peers, enclave, "
                        "programs, containers]; did you mean 'role'? ("));
  EXPECT_THAT(error_of(with(whole, "terminal: true", "terminl: true")),
              HasSubstr("allowed: [name, terminal, health, parameter_services, components]"));
  EXPECT_THAT(
      error_of(with(whole, "domain: 40", "domian: 40")),
      HasSubstr(
          "allowed: [qos, traffic, namespace, user, stop_when_exits, restart, radio, security, "
          "hosts, domain, parameters]"));
}

TEST_F(DeploymentTest, RejectsAKeyThatIsGivenTwice) {
  EXPECT_THAT(error_of(with(whole, "domain: 40", "domain: 40\ndomain: 41")),
              HasSubstr("key 'domain' is given twice"));
  EXPECT_THAT(error_of(with(whole, "  gcs:", "  uxv:")), HasSubstr("key 'uxv' is given twice"));
}

TEST_F(DeploymentTest, RejectsDuplicateNames) {
  EXPECT_THAT(error_of(with(whole, "- name: drive", "- name: base")),
              HasSubstr("uxv/base: process of this name twice"));
  EXPECT_THAT(error_of(with(whole, "name: pilot", "name: driver")),
              HasSubstr("uxv/driver: component of this name twice"));
}

TEST_F(DeploymentTest, RejectsAComponentThatIsNotInstalledWithASuggestion) {
  overrides_.installed = {"driver", "navigator", "mission_control"};
  EXPECT_EQ(error_of(whole), "no error");
  EXPECT_EQ(error_of(with(whole, "component: navigator", "component: navigater")),
            "no component 'navigater' is installed; did you mean 'navigator'? (" +
                path("bringup/m.yaml") + ":22)");
  EXPECT_THAT(error_of(with(whole, "[mission_control]", "[lidar]")),
              HasSubstr("no component 'lidar' is installed; there are: driver, navigator, "
                        "mission_control ("));
  // Before the file of parameters is asked for its components.
  overrides_.set = {"driver.port=x"};
  EXPECT_THAT(error_of(with(whole, "- driver", "- drivr")), HasSubstr("did you mean 'driver'?"));
}

TEST_F(DeploymentTest, RejectsBadNames) {
  EXPECT_THAT(error_of(with(whole, "- name: drive", "- name: a/b")),
              HasSubstr("hosts.uxv.containers.name: 'a/b' is not a name"));
  EXPECT_THAT(error_of(with(whole, "- driver", "- Driver")), HasSubstr("'Driver' is not a name"));
  EXPECT_THAT(error_of(with(whole, "  gcs:", "  GCS:")), HasSubstr("'GCS' is not a name"));
}

TEST_F(DeploymentTest, RejectsBadAddresses) {
  EXPECT_THAT(error_of(with(whole, "address: 10.77.0.1", "address: 10.77.0.256")),
              HasSubstr("hosts.uxv.address: '10.77.0.256' is not an IPv4 address"));
  EXPECT_THAT(error_of(with(whole, "peers: [10.77.0.2]", "peers: [gcs]")),
              HasSubstr("hosts.uxv.peers: 'gcs' is not an IPv4 address"));
  EXPECT_THAT(error_of(with(whole, "peers: [10.77.0.2]", "peers: 10.77.0.2")),
              HasSubstr("hosts.uxv.peers: is not a list"));
}

TEST_F(DeploymentTest, RejectsARoleThatIsNeitherUxvNorGcs) {
  EXPECT_THAT(error_of(with(whole, "role: uxv", "role: boat")),
              HasSubstr("hosts.uxv.role: 'boat' is not one of: uxv, gcs"));
}

TEST_F(DeploymentTest, RejectsARadioWithoutOneHostOfEachRoleInOneNetwork) {
  EXPECT_THAT(error_of(with(whole, "role: gcs", "role: uxv")),
              HasSubstr("one with role uxv and one with role gcs"));
  EXPECT_THAT(error_of(with(whole, "address: 10.77.0.2", "address: 10.77.1.2")),
              HasSubstr("must be different addresses of one /24 network"));
  EXPECT_THAT(error_of(with(whole, "address: 10.77.0.2", "address: 10.77.0.1")),
              HasSubstr("must be different addresses"));
}

TEST_F(DeploymentTest, RejectsMoreThanTwoHostsOrNone) {
  EXPECT_THAT(error_of("hosts: {}"), HasSubstr("0 hosts; allowed are one or two"));
  EXPECT_THAT(error_of("domain: 1"), HasSubstr("deployment.hosts: is missing"));
  EXPECT_THAT(error_of("hosts:\n  a: {role: uxv, address: 127.0.0.1}\n"
                       "  b: {role: gcs, address: 127.0.0.1}\n"
                       "  c: {role: gcs, address: 127.0.0.1}\n"),
              HasSubstr("3 hosts"));
}

TEST_F(DeploymentTest, RejectsFilesThatCannotBeRead) {
  EXPECT_THAT(error_of(with(whole, "../qos.yaml", "../nothing.yaml")),
              HasSubstr("deployment.qos: '" + path("nothing.yaml") + "' cannot be read"));
  EXPECT_THAT(error_of(with(whole, "../walls.yaml", "../nothing.yaml")),
              HasSubstr("radio.walls: '"));
  EXPECT_THAT(error_of(with(whole, "parameters: []", "parameters: [none.yaml]")),
              HasSubstr("none.yaml: cannot be read"));
  EXPECT_THROW((void)load_deployment(path("absent.yaml"), overrides_), ConfigError);
}

TEST_F(DeploymentTest, RejectsTextThatIsNotYamlWithItsLine) {
  EXPECT_THAT(error_of("domain: 1\nhosts: [\n"), HasSubstr("m.yaml:"));
  EXPECT_THAT(error_of("domain: 1\nhosts: [\n"), HasSubstr("not valid YAML"));
  EXPECT_THAT(error_of("[1]"), HasSubstr("deployment: must be a map"));
}

TEST_F(DeploymentTest, RejectsUnknownVariables) {
  EXPECT_THAT(error_of(with(whole, "${run_dir}", "${home}")),
              HasSubstr("unknown variable 'home'; allowed: ${run_dir}, ${seed}, ${share}"));
  EXPECT_THAT(error_of(with(whole, "${run_dir}/kobuki", "${run_dir")),
              HasSubstr("unknown variable 'run_dir'"));
}

TEST_F(DeploymentTest, RejectsStopWhenExitsThatNamesNoProcess) {
  EXPECT_THAT(error_of(with(whole, "gcs/mission", "gcs/missoin")),
              HasSubstr("stop_when_exits: 'gcs/missoin' is not one of: [uxv/base, uxv/drive, "
                        "gcs/mission]; did you mean 'gcs/mission'?"));
}

TEST_F(DeploymentTest, AContainerHasParameterServicesOnDemandUnlessItSaysOtherwise) {
  const std::string key = "- name: drive\n        parameter_services: ";
  EXPECT_EQ(load(whole).hosts[0].containers[0].parameter_services, ParameterServices::on_demand);
  EXPECT_THAT(error_of(with(whole, "- name: drive", key + "sometimes")),
              HasSubstr("'sometimes' is not one of: on_demand, always, never"));
}

TEST_F(DeploymentTest, TheLimitsOfAContainersWatchAreAMap) {
  EXPECT_THAT(error_of(with(whole, "- name: drive", "- name: drive\n        health: 3")),
              HasSubstr("hosts.uxv.containers.health: must be a map"));
  EXPECT_THAT(error_of(with(whole, "- name: drive", "- name: drive\n        health: {period: 3}")),
              HasSubstr("hosts.uxv.containers.health.period: unknown key; allowed: [period_s, "));
  EXPECT_THAT(
      error_of(with(whole, "- name: drive", "- name: drive\n        health: {period_s: 0}")),
      HasSubstr("hosts.uxv.containers.health.period_s: 0 is outside [0.1, 60] ("));
}

TEST_F(DeploymentTest, RejectsTwoTerminals) {
  EXPECT_THAT(error_of(with(whole, "- name: drive", "- name: drive\n        terminal: true")),
              HasSubstr("terminal: true in more than one container"));
}

TEST_F(DeploymentTest, RejectsEmptyCommandsAndContainers) {
  EXPECT_THAT(error_of(with(whole, "[mission_control]", "[]")),
              HasSubstr("hosts.gcs.containers.components: must name at least one"));
  EXPECT_THAT(error_of("hosts: {a: {role: uxv, address: 1.1.1.1, programs: [{name: x}]}}"),
              HasSubstr("hosts.a.programs.command: must be a list"));
}

TEST_F(DeploymentTest, RejectsRestartPoliciesOutsideTheirRange) {
  EXPECT_THAT(error_of(with(whole, "limit: 3", "limit: 1001")), HasSubstr("restart.limit: 1001"));
  EXPECT_THAT(error_of(with(whole, "max_backoff_s: 4", "max_backoff_s: 0.4")),
              HasSubstr("restart.max_backoff_s: must not be less than restart.backoff_s"));
  EXPECT_EQ(error_of(with(whole, "max_backoff_s: 4", "max_backoff_s: 0.5")), "no error");
}

TEST_F(DeploymentTest, RejectsBadNamespaces) {
  EXPECT_EQ(error_of(with(whole, "robot_1", "fleet/robot_1")), "no error");
  for (const char* bad : {"/robot", "robot/", "a//b", "1robot", "a-b"}) {
    EXPECT_THAT(error_of(with(whole, "robot_1", bad)), HasSubstr("deployment.namespace: '"));
  }
}

}  // namespace
}  // namespace tocsin::deployment
