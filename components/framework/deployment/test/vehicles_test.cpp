// SPDX-License-Identifier: Apache-2.0
// A bringup file for several vehicles.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <regex>

#include "fixture.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two vehicles, and a station with a container for both and one for each.
const std::string fleet = R"(qos: ../qos.yaml
traffic: ../traffic.yaml
domain: 40
stop_when_exits: gcs/mission
variables: {start: "0,0,0", route: "${share}/a.yaml"}
parameters: [../p.yaml]
radio: {channel: ../channel.yaml, walls: ../walls.yaml}
vehicles:
  uxv1: {address: 10.77.0.11}
  uxv2: {address: 10.77.0.12, variables: {start: "3,0,0", route: "${share}/${vehicle}.yaml"}}
hosts:
  uxv:
    role: uxv
    address: 10.77.0.1
    peers: [10.77.0.2]
    programs:
      - {name: base, command: [simulator, --start, "${start}", --link, "${run_dir}/kobuki", --seed, "${seed}"]}
    containers:
      - {name: drive, components: [driver, network_monitor]}
  gcs:
    role: gcs
    address: 10.77.0.2
    peers: [10.77.0.1]
    containers:
      - {name: page, components: [page]}
      - {name: link, each_vehicle: true, components: [link_router, network_monitor]}
      - {name: mission, each_vehicle: true, components: [mission_control]}
)";

class VehiclesTest : public DeploymentTest {
 protected:
  VehiclesTest() {
    write("p.yaml",
          "driver: {device: \"${run_dir}/kobuki\"}\n"
          "mission_control: {file: \"${route}\", who: \"${vehicle}\"}\n"
          "page: {}\n");
  }
  [[nodiscard]] std::string without(const std::string& line) const {
    std::string text = fleet;
    return text.erase(text.find(line), line.size());
  }
};

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  return text.replace(text.find(part), part.size(), by);
}

std::vector<std::string> names_of(const std::vector<Container>& containers) {
  std::vector<std::string> names;
  for (const Container& one : containers) names.push_back(one.name);
  return names;
}

std::string parameter(const Deployment& deployment, const std::string& host,
                      const std::string& container, const std::string& key) {
  const Container* const found = find_container(*find_host(deployment, host), container);
  for (const ComponentInstance& one : found->components) {
    const YAML::Node value = (*one.parameters)[key];
    if (value.IsDefined()) return value.Scalar();
  }
  return "none";
}

/// Without the comments, which say from where each parameter is.
std::string said(const Deployment& deployment) {
  return std::regex_replace(resolved_text(deployment), std::regex("  #.*|# .*\n"), "");
}

TEST_F(VehiclesTest, EachIsAHostLikeTheOneOfTheFile) {
  const Deployment sut = load(fleet);
  EXPECT_THAT(sut.vehicles, ElementsAre("uxv1", "uxv2"));
  ASSERT_EQ(sut.hosts.size(), 3u);
  EXPECT_EQ(sut.hosts[1].name, "uxv2");
  EXPECT_EQ(sut.hosts[1].enclave, "uxv2");
  EXPECT_EQ(sut.hosts[1].address, "10.77.0.12");
  EXPECT_THAT(sut.hosts[1].peers, ElementsAre("10.77.0.2"));
  EXPECT_THAT(sut.hosts[2].peers, ElementsAre("10.77.0.11", "10.77.0.12"));
  EXPECT_THAT(sut.hosts[1].programs[0].command,
              ElementsAre("simulator", "--start", "3,0,0", "--link", "/tmp/run/uxv2/kobuki",
                          "--seed", "1007"));
  EXPECT_EQ(sut.hosts[0].programs[0].command[2], "0,0,0");
}

TEST_F(VehiclesTest, TheStationServesAllAndEach) {
  const Deployment sut = load(fleet);
  EXPECT_THAT(names_of(sut.hosts[2].containers),
              ElementsAre("page", "uxv1_link", "uxv1_mission", "uxv2_link", "uxv2_mission"));
  const Container& link = sut.hosts[2].containers[3];
  EXPECT_EQ(vehicle_of(sut, sut.hosts[2], link), "uxv2");
  EXPECT_EQ(namespace_of(sut, sut.hosts[2], link), "uxv2");
  EXPECT_EQ(namespace_of(sut, sut.hosts[2], sut.hosts[2].containers[0]), "");
  EXPECT_EQ(namespace_of(sut, sut.hosts[1], sut.hosts[1].containers[0]), "");
  EXPECT_EQ(run_dir_of(sut, sut.hosts[2], link), "/tmp/run/uxv2");
  EXPECT_EQ(run_dir_of(sut, sut.hosts[2], sut.hosts[2].containers[0]), "/tmp/run");
  EXPECT_EQ(run_dir_of(sut, sut.hosts[0], sut.hosts[0].containers[0]), "/tmp/run/uxv1");
}

TEST_F(VehiclesTest, FilesOfParametersKnowTheVehicle) {
  const Deployment sut = load(fleet);
  EXPECT_EQ(parameter(sut, "uxv2", "drive", "device"), "/tmp/run/uxv2/kobuki");
  EXPECT_EQ(parameter(sut, "gcs", "uxv1_mission", "file"), "/opt/share/a.yaml");
  EXPECT_EQ(parameter(sut, "gcs", "uxv2_mission", "file"), "/opt/share/uxv2.yaml");
  EXPECT_EQ(parameter(sut, "gcs", "uxv2_mission", "who"), "uxv2");
  EXPECT_EQ(parameter(sut, "uxv2", "drive", "target"), "10.77.0.2");
  EXPECT_EQ(parameter(sut, "gcs", "uxv2_link", "target"), "10.77.0.12");
}

TEST_F(VehiclesTest, RoutersKnowHowManyShareTheAir) {
  const std::string routed =
      replaced(fleet, "components: [driver,", "components: [link_router, driver,");
  EXPECT_EQ(parameter(load(routed), "uxv2", "drive", "vehicles"), "2");
  EXPECT_EQ(parameter(load(routed), "gcs", "uxv1_link", "vehicles"), "2");
  overrides_.set = {"link_router.vehicles=7"};
  EXPECT_EQ(parameter(load(routed), "uxv1", "drive", "vehicles"), "7");
}

TEST_F(VehiclesTest, RoutersCountAHundredVehicles) {
  std::string routed = replaced(fleet, "components: [driver,", "components: [link_router, driver,");
  std::string more = "vehicles:\n";
  for (int i = 3; i <= 101; ++i)
    more += fmt::format("  uxv{}: {{address: 10.77.0.{}}}\n", i, i + 10);
  routed = replaced(replaced(routed, "vehicles:\n", more), "domain: 40", "domain: 0");
  EXPECT_EQ(parameter(load(routed), "uxv101", "drive", "vehicles"), "100");
}

TEST_F(VehiclesTest, OneIsSetByItsName) {
  overrides_.set = {"uxv2/driver.device=/dev/x", "gcs/uxv1_mission/mission_control.file=b"};
  const Deployment sut = load(fleet);
  EXPECT_EQ(parameter(sut, "uxv1", "drive", "device"), "/tmp/run/uxv1/kobuki");
  EXPECT_EQ(parameter(sut, "uxv2", "drive", "device"), "/dev/x");
  EXPECT_EQ(parameter(sut, "gcs", "uxv1_mission", "file"), "b");
}

TEST_F(VehiclesTest, EachLinkHasADomain) {
  const Deployment sut = load(fleet);
  EXPECT_EQ(sut.hosts[2].local_domain, 42);
  EXPECT_EQ(part_of(sut, "uxv1").link_domain, 43);
  EXPECT_EQ(part_of(sut, "uxv2").link_domain, 44);
  EXPECT_THAT(error_of(replaced(fleet, "domain: 40", "domain: 229")),
              HasSubstr("domain: 229 is above 227, the last one of so many vehicles"));
}

TEST_F(VehiclesTest, APartIsADeploymentOfOneVehicle) {
  const Deployment part = part_of(load(fleet), "uxv2");
  ASSERT_EQ(part.hosts.size(), 2u);
  EXPECT_EQ(part.hosts[0].name, "uxv2");
  EXPECT_THAT(part.hosts[1].peers, ElementsAre("10.77.0.12"));
  EXPECT_THAT(names_of(part.hosts[1].containers), ElementsAre("page", "uxv2_link", "uxv2_mission"));
  EXPECT_THAT(part.stop_when_exits, ElementsAre("gcs/uxv2_mission"));
  EXPECT_EQ(part.run_dir, "/tmp/run/uxv2");
}

TEST_F(VehiclesTest, AHostAloneHasTheLinkThatItHasAmongAll) {
  overrides_.host = "uxv2";
  const Deployment vehicle = load(fleet);
  ASSERT_EQ(vehicle.hosts.size(), 1u);
  EXPECT_EQ(part_of(vehicle, "uxv2").link_domain, 44);
  EXPECT_EQ(vehicle.hosts[0].local_domain, 41);
  EXPECT_FALSE(vehicle.radio);
  EXPECT_TRUE(vehicle.stop_when_exits.empty());
  EXPECT_EQ(run_dir_of(vehicle, vehicle.hosts[0], vehicle.hosts[0].containers[0]), "/tmp/run/uxv2");
  overrides_.host = "gcs";
  const Deployment station = load(fleet);
  ASSERT_EQ(station.hosts.size(), 1u);
  EXPECT_EQ(station.stop_when_exits.size(), 2u);
  EXPECT_THAT(part_of(station, "uxv2").hosts[0].peers, ElementsAre("10.77.0.12"));
  EXPECT_EQ(part_of(station, "uxv2").link_domain, 44);
  const Deployment again = load_resolved(write("r.yaml", resolved_text(station)));
  EXPECT_EQ(said(again), said(station));
  overrides_.host = "uxv3";
  EXPECT_THAT(error_of(fleet), HasSubstr("--host uxv3: no such host"));
}

TEST_F(VehiclesTest, EachMayHaveTheSameDomainOnAComputerOfItsOwn) {
  const std::string equal =
      replaced(replaced(fleet, "    role: uxv", "    role: uxv\n    domain: 0"), "    role: gcs",
               "    role: gcs\n    domain: 0");
  const Deployment whole = load(equal);  // its radio is emulated
  EXPECT_EQ(whole.hosts[1].local_domain, 0);
  EXPECT_EQ(part_of(whole, "uxv2").link_domain, 44);
  const std::string radio = "radio: {channel: ../channel.yaml, walls: ../walls.yaml}\n";
  EXPECT_THAT(error_of(replaced(equal, radio, "")),
              HasSubstr("hosts.uxv2.domain: 0 is that of uxv1, too: start them with --host"));
  overrides_.host = "uxv2";
  EXPECT_EQ(load(replaced(equal, radio, "")).hosts[0].local_domain, 0);
}

TEST_F(VehiclesTest, AllEndTheRun) {
  EXPECT_THAT(load(fleet).stop_when_exits, ElementsAre("gcs/uxv1_mission", "gcs/uxv2_mission"));
}

TEST_F(VehiclesTest, WithoutLeavesOutEach) {
  overrides_.without = {"gcs/mission", "driver"};
  const Deployment sut = load(fleet);
  EXPECT_THAT(names_of(sut.hosts[2].containers), ElementsAre("page", "uxv1_link", "uxv2_link"));
  EXPECT_TRUE(sut.stop_when_exits.empty());
  EXPECT_EQ(sut.hosts[0].containers[0].components.size(), 1u);
  EXPECT_EQ(sut.hosts[1].containers[0].components.size(), 1u);
}

TEST_F(VehiclesTest, WithoutMayNameOne) {
  overrides_.without = {"gcs/uxv1_mission"};
  EXPECT_THAT(names_of(load(fleet).hosts[2].containers),
              ElementsAre("page", "uxv1_link", "uxv2_link", "uxv2_mission"));
}

TEST_F(VehiclesTest, AResolvedFileSaysTheSame) {
  const Deployment first = load(fleet);
  const Deployment again = load_resolved(write("r.yaml", resolved_text(first)));
  EXPECT_EQ(said(again), said(first));
  EXPECT_EQ(part_of(again, "uxv2").link_domain, 44);
}

TEST_F(VehiclesTest, EachPartIsAFileToo) {
  overrides_.run_dir = path("run");
  write_parts(load(fleet));
  const Deployment part = load_resolved(path("run/uxv2/deployment.yaml"));
  EXPECT_EQ(part.run_dir, path("run/uxv2"));
  EXPECT_EQ(part.hosts[0].local_domain, 41);
  EXPECT_EQ(part.hosts[1].local_domain, 42);
  EXPECT_EQ(part.link_domain, 44);
  EXPECT_EQ(namespace_of(part, part.hosts[1], part.hosts[1].containers[1]), "uxv2");
}

TEST_F(VehiclesTest, AFileForOneKnowsEachVehicleToo) {
  std::string one = without(
      "vehicles:\n  uxv1: {address: 10.77.0.11}\n  uxv2: {address: 10.77.0.12, variables: {start: "
      "\"3,0,0\", route: \"${share}/${vehicle}.yaml\"}}\n");
  write("p.yaml", "page: {}\n");
  const Deployment sut = load(one);
  EXPECT_TRUE(sut.vehicles.empty());
  EXPECT_THAT(names_of(sut.hosts[1].containers), ElementsAre("page", "link", "mission"));
  EXPECT_EQ(parts_of(sut).size(), 1u);
}

TEST_F(VehiclesTest, AFileMayExtendOneOfOneVehicle) {
  std::string one = without(
      "vehicles:\n  uxv1: {address: 10.77.0.11}\n  uxv2: {address: 10.77.0.12, variables: {start: "
      "\"3,0,0\", route: \"${share}/${vehicle}.yaml\"}}\n");
  write("bringup/one.yaml", one);
  write("p.yaml", "page: {}\n");
  EXPECT_EQ(load("extends: one.yaml\nvehicles: {a: {address: 10.77.0.7}}\n").hosts[0].name, "a");
}

TEST_F(VehiclesTest, EachOfManyMayReadSeveralFiles) {
  write("bringup/base.yaml", without("vehicles:\n  uxv1: {address: 10.77.0.11}\n  uxv2: {address: "
                                     "10.77.0.12, variables: {start: \"3,0,0\", route: "
                                     "\"${share}/${vehicle}.yaml\"}}\n"));
  std::string many = "extends: base.yaml\nvehicles:\n";
  for (int i = 1; i <= 60; ++i) {
    const std::string n = std::to_string(i);
    many += "  uxv" + n + ": {address: 10.77.0." + std::to_string(100 + i) + "}\n";
  }
  EXPECT_EQ(load(many).vehicles.size(), 60U);
}

TEST_F(VehiclesTest, RejectsWhatDoesNotFit) {
  const auto with = [](const std::string& part, const std::string& by) {
    return replaced(fleet, part, by);
  };
  EXPECT_THAT(error_of(with("uxv2: {address", "UXV: {address")), HasSubstr("vehicles: 'UXV'"));
  EXPECT_THAT(error_of(with("10.77.0.12", "10.77.0.11")), HasSubstr("must be different addresses"));
  EXPECT_THAT(error_of(with("10.77.0.12", "ten")), HasSubstr("'ten' is not an IPv4 address"));
  EXPECT_THAT(error_of(with("uxv2: {address: 10.77.0.12", "gcs: {address: 10.77.0.12")),
              HasSubstr("vehicles.gcs: is the station's role, and no vehicle's name"));
  EXPECT_THAT(error_of(with("role: uxv", "role: gcs")),
              HasSubstr("the one host of role uxv, of which `hosts` has 0"));
  EXPECT_THAT(error_of(with("{start: \"0", "{share: \"0")),
              HasSubstr("variables.share: has a meaning already"));
  EXPECT_THAT(error_of(with("components: [page]", "vehicle: uxv3, components: [page]")),
              HasSubstr("gcs/page: vehicle: 'uxv3' is not one of: [uxv1, uxv2]"));
  EXPECT_THAT(error_of(with("{name: drive", "{name: drive, vehicle: uxv1")),
              HasSubstr("is for a container of the station"));
  EXPECT_THAT(error_of(with("uxv1: {address: 10.77.0.11}\n", "uxv1: {speed: 3}\n")),
              HasSubstr("vehicles.uxv1.speed: unknown key"));
}

TEST_F(VehiclesTest, WhatServesAllKnowsNoVehicle) {
  write("p.yaml", "page: {who: \"${vehicle}\"}\n");
  EXPECT_THAT(error_of(fleet), HasSubstr("'${vehicle}' is known where `vehicles` is"));
  EXPECT_THAT(
      error_of(replaced(fleet, "components: [page]",
                        "components: [{component: page, parameters: {a: \"${vehicle}\"}}]")),
      HasSubstr("unknown variable 'vehicle'; allowed: ${route}, ${run_dir}, ${seed}"));
}

/// A second station behind a site's relay.
const std::string second_station = R"(qos: ../qos.yaml
traffic: ../traffic.yaml
domain: 80
relay: true
parameters: [../p.yaml]
vehicles: {uxv1: ~, uxv2: {variables: {route: b.yaml}}}
variables: {route: a.yaml}
hosts:
  site:
    role: uxv
    domain: 69
    address: 10.79.0.1
    peers: [10.79.0.2]
    containers:
      - {name: relay, each_vehicle: true, components: [link_router]}
  desk:
    role: gcs
    address: 10.79.0.2
    peers: [10.79.0.1]
    containers:
      - {name: link, each_vehicle: true, components: [link_router, mission_control]}
      - {name: page, components: [page, driver]}
)";

class RelayTest : public VehiclesTest {};

TEST_F(RelayTest, BothHostsHaveWhatIsForEachVehicle) {
  const Deployment sut = load(second_station);
  ASSERT_EQ(sut.hosts.size(), 2U);
  EXPECT_THAT(sut.vehicles, ElementsAre("uxv1", "uxv2"));
  EXPECT_THAT(names_of(sut.hosts[0].containers), ElementsAre("uxv1_relay", "uxv2_relay"));
  EXPECT_THAT(names_of(sut.hosts[1].containers), ElementsAre("page", "uxv1_link", "uxv2_link"));
  EXPECT_EQ(sut.hosts[0].local_domain, 69);
  EXPECT_EQ(parameter(sut, "desk", "uxv2_link", "file"), "b.yaml");
  EXPECT_EQ(parameter(sut, "desk", "uxv2_link", "vehicles"), "none") << "the site is on wire";
}

TEST_F(RelayTest, EachVehicleHasALinkBetweenTheTwo) {
  const Deployment whole = load(second_station);
  const Deployment part = part_of(whole, "uxv2");
  EXPECT_EQ(part.link_domain, 83);
  EXPECT_THAT(part.hosts[0].peers, ElementsAre("10.79.0.2"));
  EXPECT_THAT(part.hosts[1].peers, ElementsAre("10.79.0.1"));
  const Host& site = part.hosts[0];
  const Host& desk = part.hosts[1];
  ASSERT_THAT(names_of(site.containers), ElementsAre("uxv2_relay"));
  EXPECT_EQ(namespace_of(part, site, site.containers[0]), "desk/uxv2");
  EXPECT_EQ(routed_namespace_of(part, site.containers[0]), "uxv2");
  EXPECT_THAT(peer_names_of(part, site, site.containers[0]), ElementsAre("desk"));
  const Container& link = *find_container(desk, "uxv2_link");
  EXPECT_EQ(namespace_of(part, desk, link), "uxv2");
  EXPECT_EQ(routed_namespace_of(part, link), "uxv2");
  EXPECT_THAT(peer_names_of(part, desk, link), ElementsAre("site"));
}

TEST_F(RelayTest, AHostAloneKnowsTheOtherByName) {
  overrides_.host = "desk";
  const Deployment desk = load(second_station);
  const std::string resolved = path("resolved.yaml");
  write_resolved(desk, resolved);
  const Deployment sut = load_resolved(resolved);
  ASSERT_EQ(sut.hosts.size(), 1U);
  EXPECT_THAT(peer_names_of(sut, sut.hosts[0], *find_container(sut.hosts[0], "uxv1_link")),
              ElementsAre("site"));
  EXPECT_THAT(part_of(sut, "uxv2").hosts[0].peers, ElementsAre("10.79.0.1"));
}

TEST_F(RelayTest, RefusesWhatDoesNotFit) {
  const std::string needs = "relay: needs `vehicles`, a host with role uxv";
  EXPECT_THAT(error_of(replaced(second_station, "role: gcs", "role: uxv")),
              HasSubstr("like the one host of role uxv"));
  EXPECT_THAT(error_of(replaced(second_station, "uxv1: ~", "uxv1: {address: 10.79.0.3}")),
              HasSubstr("vehicles.uxv1.address: is none of a vehicle behind a relay"));
  EXPECT_THAT(error_of(replaced(second_station, "domain: 80",
                                "domain: 80\nradio: {channel: ../channel.yaml, walls: "
                                "../walls.yaml}")),
              HasSubstr(needs));
  EXPECT_THAT(error_of(replaced(second_station, "vehicles: {", "restart: {")),
              HasSubstr("restart.uxv1"));
  EXPECT_THAT(error_of(replaced(second_station, "relay: true", "relay: 3")), HasSubstr("relay"));
}

}  // namespace
}  // namespace tocsin::deployment
