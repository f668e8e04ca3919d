// SPDX-License-Identifier: Apache-2.0
#include "deployment/deployment.hpp"

#include <yaml-cpp/yaml.h>

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
  EXPECT_THAT(sut.stop_when_exits, ::testing::ElementsAre("gcs/mission"));
  EXPECT_EQ(sut.restart.limit, 3);
  ASSERT_TRUE(sut.radio);
  EXPECT_EQ(sut.radio->walls, path("walls.yaml"));
  ASSERT_EQ(sut.hosts.size(), 2U);
  EXPECT_EQ(sut.hosts[0].role, Role::uxv);
  EXPECT_EQ(sut.hosts[1].address, "10.77.0.2");
  EXPECT_THAT(sut.hosts[0].peers, ElementsAre("10.77.0.2"));
  EXPECT_TRUE(sut.hosts[1].containers[0].terminal);
  EXPECT_EQ(sut.hosts[0].containers[0].parameter_services, ParameterServices::on_demand);
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

TEST_F(DeploymentTest, RejectsUnknownKeysEverywhereWithTheirLine) {
  expect_errors(
      [this](const auto& text) { return error_of(text); },
      {{"domain: 40", "domian: 40",
        "deployment.domian: unknown key; allowed: [qos, traffic, namespace, user, "
        "stop_when_exits, restart, radio, security, vehicles, relay, hosts, domain, parameters, "
        "variables]"},
       {"domain: 40", "domian: 40", "m.yaml:3)"},
       {"role: uxv", "role: uxv\n    rool: 1",
        "hosts.uxv.rool: unknown key; allowed: [role, address, peers"},
       {"role: uxv", "rol: uxv",
        "hosts.uxv.rol: unknown key; allowed: [role, address, peers, sites, second, enclave, "
        "domain, "
        "programs, "
        "containers]; did you mean 'role'? ("},
       {"terminal: true", "terminl: true",
        "hosts.gcs.containers.terminl: unknown key; allowed: [name, terminal, health, "
        "parameter_services, "
        "each_vehicle, vehicle, components]"},
       {"{name: base,", "{name: base, x: 1,", "hosts.uxv.programs.x: unknown key"},
       {"name: pilot", "nam: pilot", "hosts.uxv.containers.components.nam: unknown key"},
       {"limit: 3", "limits: 3", "restart.limits: unknown"},
       {"  walls:", "  wals:", "radio.wals: unknown key; allowed: [channel, walls, second]"},
       {"- name: drive", "- name: drive\n        health: {period: 3}",
        "hosts.uxv.containers.health.period: unknown key; allowed: [period_s, "}});
}

TEST_F(DeploymentTest, RejectsAKeyThatIsGivenTwice) {
  expect_errors([this](const auto& text) { return error_of(text); },
                {{"domain: 40", "domain: 40\ndomain: 41", "key 'domain' is given twice"},
                 {"  gcs:", "  uxv:", "key 'uxv' is given twice"}});
}

TEST_F(DeploymentTest, RejectsDuplicateNames) {
  expect_errors([this](const auto& text) { return error_of(text); },
                {{"- name: drive", "- name: base", "uxv/base: process of this name twice"},
                 {"name: pilot", "name: driver", "uxv/driver: component of this name twice"}});
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

TEST_F(DeploymentTest, RejectsBadValues) {
  const std::string watch = "hosts.uxv.containers.health";
  expect_errors(
      [this](const auto& text) { return error_of(text); },
      {{"domain: 40", "domain: 229", "no error"},
       {"domain: 40", "domain: 230", "deployment.domain: 230 is outside [0, 229]"},
       {"domain: 40", "domain: -1", "-1 is outside"},
       {"domain: 40", "domain: x", "not a whole number"},
       {"- name: drive", "- name: a/b", "hosts.uxv.containers.name: 'a/b' is not a name"},
       {"- driver", "- Driver", "'Driver' is not a name"},
       {"  gcs:", "  GCS:", "'GCS' is not a name"},
       {"address: 10.77.0.1", "address: 10.77.0.256",
        "hosts.uxv.address: '10.77.0.256' is not an IPv4 address"},
       {"peers: [10.77.0.2]", "peers: [gcs]", "hosts.uxv.peers: 'gcs' is not an IPv4 address"},
       {"peers: [10.77.0.2]", "peers: 10.77.0.2", "hosts.uxv.peers: is not a list"},
       {"role: uxv", "role: boat", "hosts.uxv.role: 'boat' is not one of: uxv, gcs"},
       {"- name: drive", "- name: drive\n        parameter_services: sometimes",
        "'sometimes' is not one of: on_demand, always, never"},
       {"- name: drive", "- name: drive\n        health: 3", watch + ": must be a map"},
       {"- name: drive", "- name: drive\n        health: {period_s: 0}",
        watch + ".period_s: 0 is outside [0.1, 60] ("},
       {"limit: 3", "limit: 1001", "restart.limit: 1001"},
       {"max_backoff_s: 4", "max_backoff_s: 0.4",
        "restart.max_backoff_s: must not be less than restart.backoff_s"},
       {"max_backoff_s: 4", "max_backoff_s: 0.5", "no error"},
       {"robot_1", "fleet/robot_1", "no error"},
       {"robot_1", "/robot", "deployment.namespace: '"},
       {"robot_1", "robot/", "deployment.namespace: '"},
       {"robot_1", "a//b", "deployment.namespace: '"},
       {"robot_1", "1robot", "deployment.namespace: '"},
       {"robot_1", "a-b", "deployment.namespace: '"}});
}

class SecondPathTest : public DeploymentTest {
 protected:
  static std::string with_second(const std::string& uxv, const std::string& gcs) {
    std::string text = with(whole, "    peers: [10.77.0.2]\n", "    peers: [10.77.0.2]\n" + uxv);
    return with(text, "    address: 10.77.0.2\n", "    address: 10.77.0.2\n" + gcs);
  }
  const std::string uxv_ = "    second: {address: 10.78.0.1, peers: [10.78.0.2]}\n";
  const std::string gcs_ = "    second: {address: 10.78.0.2, peers: [10.78.0.1]}\n";
  const std::string whole_ = with_second(uxv_, gcs_);
};

TEST_F(SecondPathTest, IsReadAndWrittenAgain) {
  const Deployment sut = load(with(whole_, "radio:\n", "radio:\n  second: ../channel.yaml\n"));
  EXPECT_EQ(sut.radio->second, path("channel.yaml"));
  const std::string resolved = path("resolved.yaml");
  write_resolved(sut, resolved);
  for (const Deployment& one : {sut, load_resolved(resolved)}) {
    ASSERT_TRUE(one.hosts[0].second);
    EXPECT_EQ(one.hosts[0].second->address, "10.78.0.1");
    EXPECT_EQ(one.hosts[0].second->peers, std::vector<std::string>{"10.78.0.2"});
    EXPECT_EQ(one.radio->second, path("channel.yaml"));
  }
  EXPECT_FALSE(load(whole).hosts[0].second);
}

TEST_F(SecondPathTest, RefusesWhatHasNoCounterpart) {
  EXPECT_THAT(error_of(with_second(uxv_, "")),
              HasSubstr("hosts.uxv.second.peers: '10.78.0.2' is not the second address of host "
                        "gcs, which has none"));
  EXPECT_THAT(error_of(with(whole_, "peers: [10.78.0.2]", "peers: [10.78.0.3]")),
              HasSubstr("of host gcs, which is 10.78.0.2"));
  EXPECT_THAT(error_of(with(whole_, "peers: [10.78.0.2]", "peers: []")),
              HasSubstr("hosts.uxv.second.peers: 0 addresses must be as many as the host's peers, "
                        "which are 1, in the same order"));
  EXPECT_THAT(error_of(with(whole_, "{address: 10.78.0.1", "{address: 10.77.0.1")),
              HasSubstr("hosts.uxv.second.address: '10.77.0.1' must not be the host's address"));
  EXPECT_THAT(error_of(with(whole_, "{address: 10.78.0.1", "{address: modem")),
              HasSubstr("hosts.uxv.second.address: 'modem' is not an IPv4 address"));
}

TEST_F(SecondPathTest, AnEmulatedOneNeedsAddressesOfAnotherNetworkOnBothHosts) {
  const auto emulated = [](const std::string& text) {
    return with(text, "radio:\n", "radio:\n  second: ../channel.yaml\n");
  };
  EXPECT_THAT(error_of(emulated(whole)), HasSubstr("radio.second: host uxv has no `second`"));
  std::string same = with(whole_, "{address: 10.78.0.1", "{address: 10.77.0.9");
  same = with(same, "peers: [10.78.0.1]", "peers: [10.77.0.9]");
  EXPECT_THAT(error_of(emulated(same)),
              HasSubstr("'10.77.0.9' must be in another /24 network than 10.77.0.1"));
  EXPECT_THAT(error_of(with(whole_, "radio:\n", "radio:\n  second: ../nothing.yaml\n")),
              HasSubstr("radio.second: '"));
}

/// A vehicle and two stations that it may speak with.
class SitesTest : public DeploymentTest {
 protected:
  const std::string file_ =
      "domain: 60\nhosts:\n"
      "  uxv1: {role: uxv, address: 10.1.0.1, peers: [10.1.0.3, 10.1.0.2]}\n"
      "  south: {role: gcs, address: 10.1.0.2, peers: [10.1.0.1]}\n"
      "  north: {role: gcs, address: 10.1.0.3, peers: [10.1.0.1]}\n";
};

TEST_F(SitesTest, AreKnownByTheNamesOfTheHostsInTheOrderOfThePeers) {
  const Deployment sut = load(file_);
  ASSERT_EQ(sut.hosts.size(), 3U);
  EXPECT_THAT(sut.hosts[0].sites, ElementsAre("north", "south"));
  EXPECT_THAT(sut.hosts[1].sites, ElementsAre());
  EXPECT_EQ(sut.link_domain, 63);
  const Container container{"link", false, {}};
  EXPECT_THAT(peer_names_of(sut, sut.hosts[0], container), ElementsAre("north", "south"));
}

TEST_F(SitesTest, AreProbedByTheNetworkMonitorOfTheirVehicle) {
  const auto parameters_in = [this](const std::string& keys) {
    const std::string containers =
        ", containers: [{name: link, components: [{component: network_monitor" + keys + "}]}]}";
    const Deployment sut = load("qos: ../qos.yaml\ntraffic: ../traffic.yaml\n" +
                                with(file_, "10.1.0.2]}", "10.1.0.2]" + containers));
    return *sut.hosts[0].containers[0].components[0].parameters;
  };
  using Texts = std::vector<std::string>;
  const YAML::Node sut = parameters_in("");
  EXPECT_EQ(sut["target"].as<std::string>(), "10.1.0.3");
  EXPECT_EQ(sut["sites"].as<Texts>(), (Texts{"north", "south"}));
  EXPECT_EQ(sut["site_targets"].as<Texts>(), (Texts{"10.1.0.3", "10.1.0.2"}));
  EXPECT_FALSE(parameters_in(", parameters: {target: 10.1.0.9}")["sites"]) << "as it is told";
}

TEST_F(SitesTest, AreNamedWhereTheFileDoesNotHaveTheirHosts) {
  const std::string alone =
      "hosts: {uxv: {role: uxv, address: 10.1.0.1, peers: [1.1.1.1, 1.1.1.2]}}";
  EXPECT_THAT(error_of(alone), HasSubstr("hosts.uxv.peers: no host has address 1.1.1.1; give the "
                                         "names of all peers as `sites`"));
  const auto named = [&](const std::string& sites) {
    return with(alone, "1.1.1.2]", "1.1.1.2], sites: " + sites);
  };
  EXPECT_THAT(load(named("[a, b]")).hosts[0].sites, ElementsAre("a", "b"));
  EXPECT_THAT(error_of(named("[a]")), HasSubstr("1 names must be as many as the host's peers"));
  EXPECT_THAT(error_of(named("[a, a]")), HasSubstr("a: site of this name twice"));
  EXPECT_THAT(error_of(named("[a, b/c]")), HasSubstr("b/c"));
}

TEST_F(SitesTest, MustBeStationsWithTheseAddresses) {
  EXPECT_THAT(
      error_of(with(file_, "10.1.0.2]}", "10.1.0.2], sites: [south, north]}")),
      HasSubstr("hosts.uxv1.sites: 'south' is not a host of role gcs with address 10.1.0.3"));
  EXPECT_THAT(error_of(with(file_, "10.1.0.3, 10.1.0.2]", "10.1.0.3]")), HasSubstr("3 hosts"))
      << "nobody speaks with the other";
}

TEST_F(SitesTest, AreKeptInTheResolvedFile) {
  const Deployment sut = load(file_);
  write_resolved(sut, path("resolved.yaml"));
  EXPECT_THAT(load_resolved(path("resolved.yaml")).hosts[0].sites, ElementsAre("north", "south"));
}

TEST_F(SitesTest, EachButTheFirstHasAFolderOfItsOwnInThatOfTheRun) {
  Deployment sut = load(file_);
  sut.run_dir = path("run");
  EXPECT_EQ(folder_of(sut, sut.hosts[0]), path("run"));
  EXPECT_EQ(folder_of(sut, sut.hosts[1]), path("run"));
  EXPECT_EQ(folder_of(sut, sut.hosts[2]), path("run/north"));
  EXPECT_EQ(run_dir_of(sut, sut.hosts[2], {"link", false, {}}), path("run/north"));
  write_parts(sut);
  EXPECT_EQ(load_resolved(path("run/north/deployment.yaml")).run_dir, path("run/north"));
}

TEST_F(SitesTest, DoNotTakeUpEachOthersStops) {
  const auto only_station = [&](const std::string& stop) {
    std::string file =
        with(file_, "gcs, address: 10.1.0.3",
             "gcs, containers: [{name: a, components: [" + stop + "]}], address: 10.1.0.3");
    const Deployment sut = load("qos: ../qos.yaml\ntraffic: ../traffic.yaml\n" + file);
    const YAML::Node& parameters = *find_host(sut, "north")->containers[0].components[0].parameters;
    return parameters["only_station"].as<std::string>("not given");
  };
  EXPECT_EQ(only_station("emergency_stop"), "false");
  EXPECT_EQ(only_station("{component: emergency_stop, parameters: {only_station: true}}"), "true");
  EXPECT_EQ(only_station("stop_relay"), "not given");
}

TEST_F(DeploymentTest, RejectsHostsAndProcessesThatDoNotFit) {
  expect_errors(
      [this](const auto& text) { return error_of(text); },
      {{"role: gcs", "role: uxv", "one with role uxv and one with role gcs"},
       {"address: 10.77.0.2", "address: 10.77.1.2",
        "must be different addresses of one /24 network"},
       {"address: 10.77.0.2", "address: 10.77.0.1", "must be different addresses"},
       {"gcs/mission", "gcs/missoin",
        "stop_when_exits: 'gcs/missoin' is not one of: [uxv/base, uxv/drive, gcs/mission]; did "
        "you mean 'gcs/mission'?"},
       {"- name: drive", "- name: drive\n        terminal: true",
        "terminal: true in more than one container"},
       {"[mission_control]", "[]", "hosts.gcs.containers.components: must name at least one"}});
  for (const auto& [text, error] : std::vector<std::pair<const char*, const char*>>{
           {"hosts: {}", "0 hosts; allowed are one or two"},
           {"domain: 1", "deployment.hosts: is missing"},
           {"hosts: {a: {role: uxv, address: 1.1.1.1, programs: [{name: x}]}}",
            "hosts.a.programs.command: must be a list"},
           {"hosts:\n  a: {role: uxv, address: 127.0.0.1}\n  b: {role: gcs, address: 127.0.0.1}\n"
            "  c: {role: gcs, address: 127.0.0.1}\n",
            "3 hosts"}}) {
    EXPECT_THAT(error_of(text), HasSubstr(error));
  }
}

TEST_F(DeploymentTest, RejectsFilesThatCannotBeRead) {
  expect_errors([this](const auto& text) { return error_of(text); },
                {{"../qos.yaml", "../nothing.yaml",
                  "deployment.qos: '" + path("nothing.yaml") + "' cannot be read"},
                 {"../walls.yaml", "../nothing.yaml", "radio.walls: '"},
                 {"parameters: []", "parameters: [none.yaml]", "none.yaml: cannot be read"}});
  EXPECT_THROW((void)load_deployment(path("absent.yaml"), overrides_), ConfigError);
}

TEST_F(DeploymentTest, RejectsTextThatIsNotYamlWithItsLine) {
  EXPECT_THAT(error_of("domain: 1\nhosts: [\n"),
              ::testing::AllOf(HasSubstr("m.yaml:"), HasSubstr("not valid YAML")));
  EXPECT_THAT(error_of("[1]"), HasSubstr("deployment: must be a map"));
}

TEST_F(DeploymentTest, RejectsUnknownVariables) {
  expect_errors(
      [this](const auto& text) { return error_of(text); },
      {{"${run_dir}", "${home}", "unknown variable 'home'; allowed: ${run_dir}, ${seed}, ${share}"},
       {"${run_dir}/kobuki", "${run_dir", "unknown variable 'run_dir'"}});
}

}  // namespace
}  // namespace tocsin::deployment
