// SPDX-License-Identifier: Apache-2.0
#include "command_line/launch_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class PlanTest : public ::testing::Test {
 protected:
  PlanTest() {
    for (const char* name : {"tocsin-container", "simulator", "link_emulator"}) {
      folder_.write_program(name, "");
    }
    deployment_.run_dir = "/run";
    deployment_.seed = 7;
    deployment_.radio = deployment::Radio{"/c.yaml", "/w.yaml"};
    deployment_.hosts.resize(2);
    deployment_.hosts[0] = {"robot", Role::uxv, "10.77.0.1", {}, 0, {{"base", {"simulator", "-x"}}},
                            {}};
    deployment_.hosts[0].containers = {{"drive", false, {}}};
    deployment_.hosts[1] = {"desk", Role::gcs, "10.77.0.2", {}, 1, {}, {{"mission", true, {}}}};
  }

  const ResolvedFile file_{"/run/d.yaml", "/proc/self/fd/5"};
  TemporaryFolder folder_;
  Folders folders_{folder_.path("")};
  deployment::Deployment deployment_;
};

TEST_F(PlanTest, StartsProgramsBeforeContainersHostByHost) {
  const auto specs = plan_processes(deployment_, file_, folders_);
  ASSERT_EQ(specs.size(), 3U);
  EXPECT_EQ(specs[0].name, "robot/base");
  EXPECT_EQ(specs[1].name, "robot/drive");
  EXPECT_EQ(specs[2].name, "desk/mission");
  EXPECT_EQ(specs[1].host, 0U);
  EXPECT_EQ(specs[2].host, 1U);
}

TEST_F(PlanTest, LocatesProgramsAndKeepsTheirArguments) {
  const auto specs = plan_processes(deployment_, file_, folders_);
  EXPECT_THAT(specs[0].command, ElementsAre(folder_.path("simulator"), "-x"));
}

TEST_F(PlanTest, StartsContainersWithTheResolvedFile) {
  const auto specs = plan_processes(deployment_, file_, folders_);
  EXPECT_THAT(specs[2].command, ElementsAre(folder_.path("tocsin-container"), "/run/d.yaml", "desk",
                                            "mission", "/proc/self/fd/5"));
  EXPECT_FALSE(specs[1].terminal);
  EXPECT_TRUE(specs[2].terminal);
}

TEST_F(PlanTest, RejectsAProgramThatIsNotFound) {
  deployment_.hosts[0].programs[0].command[0] = "simulatr";
  try {
    (void)plan_processes(deployment_, file_, folders_);
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("robot/base: program 'simulatr' is not found"));
  }
}

TEST_F(PlanTest, JoinsTheHostsByTheirRoles) {
  const auto radios = plan_radios(deployment_, {5, 6}, folders_);
  ASSERT_EQ(radios.size(), 1U);
  const ProcessSpec& sut = radios.front();
  EXPECT_EQ(sut.name, "radio");
  EXPECT_FALSE(sut.host);
  EXPECT_THAT(sut.command,
              ElementsAre(folder_.path("link_emulator"), "--channel", "/c.yaml", "--walls",
                          "/w.yaml", "--seed", "7", "--interface", "wlan0", "--end",
                          "uxv:/proc/self/fd/5:10.77.0.1/24", "--end",
                          "gcs:/proc/self/fd/6:10.77.0.2/24", "--control", "/run/radio.sock",
                          "--stats", "/run/radio.jsonl", "--wireless", "/run/wireless"));
}

TEST_F(PlanTest, JoinsSeveralVehiclesByTheirNames) {
  deployment_.vehicles = {"robot"};
  const auto radios = plan_radios(deployment_, {5, 6}, folders_);
  EXPECT_THAT(radios.front().command, Contains("robot:/proc/self/fd/5:10.77.0.1/24"));
  EXPECT_THAT(radios.front().command, Contains("/run/{vehicle}/wireless"));
}

TEST_F(PlanTest, JoinsFurtherStationsAsSites) {
  deployment::Host south;
  south.name = "south";
  south.role = Role::gcs;
  south.address = "10.77.0.3";
  deployment_.hosts.push_back(south);
  const auto radios = plan_radios(deployment_, {5, 6, 7}, folders_);
  EXPECT_THAT(radios.front().command, Contains("gcs:/proc/self/fd/6:10.77.0.2/24"));
  EXPECT_THAT(radios.front().command, Contains("south:/proc/self/fd/7:10.77.0.3/24"));
  EXPECT_THAT(radios.front().command, Contains("--site"));
}

TEST_F(PlanTest, ASecondRadioJoinsTheHostsByTheirSecondAddresses) {
  deployment_.radio->second = "/modem.yaml";
  deployment_.hosts[0].second = deployment::SecondPath{"10.78.0.1", {"10.78.0.2"}};
  deployment_.hosts[1].second = deployment::SecondPath{"10.78.0.2", {"10.78.0.1"}};
  const auto radios = plan_radios(deployment_, {5, 6}, folders_);
  ASSERT_EQ(radios.size(), 2U);
  EXPECT_EQ(radios[1].name, "second_radio");
  EXPECT_THAT(
      radios[1].command,
      ElementsAre(folder_.path("link_emulator"), "--channel", "/modem.yaml", "--walls", "/w.yaml",
                  "--seed", "7", "--interface", "wwan0", "--end",
                  "uxv:/proc/self/fd/5:10.78.0.1/24", "--end", "gcs:/proc/self/fd/6:10.78.0.2/24",
                  "--control", "/run/second_radio.sock", "--stats", "/run/second_radio.jsonl"));
}

}  // namespace
}  // namespace tocsin
