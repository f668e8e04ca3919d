// SPDX-License-Identifier: Apache-2.0
#include "experiment/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "toy.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

TEST(Plan, HasEveryCombinationInTheOrderOfTheFile) {
  const auto sut = make_plan(ToyExperiment().load());
  ASSERT_EQ(sut.size(), 2U * 1 * 1 * 2 * 3);
  EXPECT_EQ(sut[0].id(), "main.a.near.camera.none.1");
  EXPECT_EQ(sut[2].id(), "main.a.near.camera.none.3");
  EXPECT_EQ(sut[3].id(), "main.a.near.camera.tocp_dsp.1");
  EXPECT_EQ(sut[11].id(), "main.b.near.camera.tocp_dsp.3");
  for (std::size_t i = 0; i < sut.size(); ++i) EXPECT_EQ(sut[i].number, i);
}

TEST(Plan, GivesEveryPolicyTheSameRadio) {
  const auto sut = make_plan(ToyExperiment().load());
  EXPECT_EQ(sut[0].seed, sut[3].seed);
  EXPECT_EQ(sut[2].seed, sut[5].seed);
}

TEST(Plan, GivesEveryRunAndMissionARadioOfItsOwn) {
  std::set<int> seeds;
  for (const char* mission : {"a", "b"}) {
    for (int i = 1; i <= 100; ++i) seeds.insert(seed_of(mission, "near", i));
  }
  EXPECT_EQ(seeds.size(), 200U);
  EXPECT_GT(*seeds.begin(), 0);
}

TEST(Plan, KnowsRunsOfTwoSetsThatAreTheSame) {
  const ToyExperiment toy(std::string(toy_text) +
                          "  - {name: other, payloads: [camera, plain], seeds: 1}\n");
  const auto plan = make_plan(toy.load());
  const auto other =
      std::find_if(plan.begin(), plan.end(), [](const auto& run) { return run.set == "other"; });
  EXPECT_EQ(identity_of(*other), identity_of(plan[0]));
  EXPECT_NE(identity_of(plan[1]), identity_of(plan[0])) << "another seed";
  EXPECT_NE(identity_of(plan[3]), identity_of(plan[0])) << "another policy";
  EXPECT_NE(identity_of(*(other + 2)), identity_of(plan[0])) << "no camera";
}

TEST(Plan, CountsSeedsFromTheFirst) {
  const auto sut =
      make_plan(ToyExperiment(with(toy_text, "seeds: 3", "seeds: 1, first_seed: 7")).load());
  EXPECT_EQ(sut[0].index, 7);
  EXPECT_EQ(sut[0].seed, seed_of("a", "near", 7));
}

TEST(Plan, PutsTheMissionIntoThePathOfAChannel) {
  const ToyExperiment toy;
  const auto sut = make_plan(toy.load());
  EXPECT_EQ(sut[0].channel.file, toy.path("near_a.yaml"));
  EXPECT_EQ(sut[6].channel.file, toy.path("near_b.yaml"));
}

TEST(Plan, RejectsAChannelThatOneMissionHasNot) {
  const ToyExperiment toy;
  std::filesystem::remove(toy.path("near_b.yaml"));
  EXPECT_THAT(error_of([&] { (void)make_plan(toy.load()); }), HasSubstr("near_b.yaml"));
}

TEST(Plan, SetsPolicyMissionAndWhatTheEntriesSay) {
  const ToyExperiment toy;
  const Experiment experiment = toy.load();
  const auto sut = overrides_of(make_plan(experiment)[3], experiment.timing, "/share", "/run");
  EXPECT_THAT(sut.set, Contains("transmission_controller.policy=tocp_dsp"));
  EXPECT_THAT(sut.set, Contains("mission_control.mission_file=" + toy.path("a.yaml")));
  EXPECT_THAT(sut.set, Contains("navigator.speed_mps=0.1"));
  EXPECT_THAT(sut.set, Contains("transmission_controller.alpha=3"));
  EXPECT_THAT(sut.set, Contains("network_monitor.window=10"));
  EXPECT_THAT(sut.without, Contains("gcs/view"));
  EXPECT_EQ(sut.channel, toy.path("near_a.yaml"));
}

/// A container with one component of its own name.
deployment::Container container_of(const std::string& name) {
  deployment::ComponentInstance instance;
  instance.component = instance.name = name;
  deployment::Container container;
  container.name = name;
  container.components = {instance};
  return container;
}

TEST(Instrument, PutsAListenerInPlaceOfEachRecorder) {
  deployment::Deployment sut;
  sut.hosts.resize(1);
  sut.hosts[0].containers = {container_of("recorder"), container_of("camera")};
  instrument(sut);
  EXPECT_EQ(sut.hosts[0].containers[0].components[0].component, "experiment");
  EXPECT_EQ(sut.hosts[0].containers[0].components[0].name, "recorder");
  EXPECT_EQ(sut.hosts[0].containers[1].components[0].component, "camera");
}

}  // namespace
}  // namespace tocsin::experiment
