// SPDX-License-Identifier: Apache-2.0
#include "engine/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/real_run.hpp"
#include "plan/toy.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string settings_of(const ToyExperiment& toy) {
  const Experiment experiment = toy.load();
  return settings_text(experiment, make_plan(experiment));
}

TEST(Settings, HoldEverythingThatDecidesTheResults) {
  const ToyExperiment toy;
  const std::string sut = settings_of(toy);
  EXPECT_THAT(sut, HasSubstr("build: 0.1.0+"));
  EXPECT_THAT(sut, HasSubstr("  warm_up_s: 0\n"));
  EXPECT_THAT(sut, HasSubstr(toy.path("near_a.yaml") + ": |\n    x: 1\n"));
  EXPECT_THAT(sut, HasSubstr("a.near.2: " + std::to_string(seed_of("a", "near", 2)) + "\n"));
}

TEST(Settings, AreTheSameEachTime) {
  const ToyExperiment toy;
  EXPECT_EQ(settings_of(toy), settings_of(toy));
}

TEST(Settings, ChangeWithAFileThatTheExperimentNames) {
  const ToyExperiment toy;
  const std::string before = settings_of(toy);
  toy.write("near_b.yaml", "x: 2\n");
  EXPECT_NE(before, settings_of(toy));
}

TEST(Settings, HoldTheFilesThatAChannelExtends) {
  const ToyExperiment toy;
  toy.write("base.yaml", "y: 5\n");
  toy.write("near_a.yaml", "extends: base.yaml\n");
  EXPECT_THAT(settings_of(toy), HasSubstr(toy.path("base.yaml") + ": |\n    y: 5\n"));
}

TEST(LaunchCommand, SaysWhatTheSimulationIsTold) {
  const ToyExperiment toy;
  const Experiment experiment = toy.load();
  const auto run = make_plan(experiment)[3];
  const auto sut = launch_command(run, experiment.timing, {"/share", "/out"});
  EXPECT_THAT(sut[0], HasSubstr("tocsin-launch"));
  EXPECT_THAT(sut, Contains("/out/real/main.a.near.camera.tocp_dsp.1.run"));
  EXPECT_THAT(sut, Contains(std::to_string(run.seed)));
  EXPECT_THAT(sut, Contains("transmission_controller.alpha=3"));
  EXPECT_THAT(sut, Contains("gcs/view"));
}

TEST(LaunchCommand, HasASetAndAWithoutBeforeEachOfThem) {
  const ToyExperiment toy;
  Experiment experiment = toy.load();
  experiment.timing.without = {"gcs/view", "gcs/recorder"};
  const auto sut = launch_command(make_plan(experiment)[0], experiment.timing, {"/share", "/out"});
  EXPECT_EQ(std::count(sut.begin(), sut.end(), "--without"), 2);
  EXPECT_EQ(std::count(sut.begin(), sut.end(), "--set"), 3) << "mission file, policy, speed";
  const auto seed = std::find(sut.begin(), sut.end(), "--seed");
  ASSERT_LT(seed + 1, sut.end());
  EXPECT_EQ(*(seed + 1), std::to_string(seed_of("a", "near", 1)));
  EXPECT_EQ(sut[1], experiment.timing.bringup);
}

TEST(Settings, TellTheSeedOfARunOnceForAllPolicies) {
  const std::string sut = settings_of(ToyExperiment());
  const std::string line = "a.near.1: ";
  EXPECT_EQ(sut.find(line), sut.rfind(line));
  EXPECT_THAT(sut, HasSubstr("runs: 12\n"));
}

TEST(Settings, HoldTheFileOfFittedParameters) {
  const ToyExperiment toy(std::string("fitted: fitted.yaml\n") + toy_text);
  toy.write("fitted.yaml", "a: {tocp: [alpha=9]}\n");
  EXPECT_THAT(settings_of(toy), HasSubstr("fitted.yaml: |\n    a: {tocp: [alpha=9]}\n"));
}

}  // namespace
}  // namespace tocsin::experiment
