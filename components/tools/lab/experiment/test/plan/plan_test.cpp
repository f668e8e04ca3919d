// SPDX-License-Identifier: Apache-2.0
#include "plan/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "plan/toy.hpp"

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

TEST(Plan, GivesAChannelTheSeedsOfAnotherWhenToldTo) {
  const std::string two = with(toy_text, "payloads:\n",
                               "  - {name: own, file: \"near_${mission}.yaml\"}\n"
                               "  - {name: same, file: \"near_${mission}.yaml\", seeds_of: near}\n"
                               "payloads:\n");
  const auto sut = make_plan(ToyExperiment(two).load());
  const auto seed = [&](const std::string& id) {
    return std::find_if(sut.begin(), sut.end(), [&](const auto& run) { return run.id() == id; })
        ->seed;
  };
  EXPECT_EQ(seed("main.b.same.camera.none.2"), seed("main.b.near.camera.none.2"));
  EXPECT_NE(seed("main.b.own.camera.none.2"), seed("main.b.near.camera.none.2"));
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

TEST(Plan, APolicyMayHaveQosAndTrafficOfItsOwn) {
  const ToyExperiment toy(
      with(toy_text, "- {name: none}", "- {name: none, qos: near_a.yaml, traffic: near_b.yaml}"));
  const auto experiment = toy.load();
  const auto plan = make_plan(experiment);
  const auto own = overrides_of(plan[0], experiment.timing, "/share", "/run");
  EXPECT_EQ(own.qos, toy.path("near_a.yaml"));
  EXPECT_EQ(own.traffic, toy.path("near_b.yaml"));
  EXPECT_EQ(overrides_of(plan[3], experiment.timing, "/share", "/run").qos, "") << "the bringup's";
  const auto shared = make_plan(ToyExperiment().load());
  EXPECT_NE(identity_of(plan[0]), identity_of(shared[0])) << "another run";
  EXPECT_THAT(
      error_of([] {
        (void)ToyExperiment(with(toy_text, "- {name: none}", "- {name: none, qos: gone.yaml}"))
            .load();
      }),
      HasSubstr("policies[0].file: no file"));
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

TEST(Plan, NamesItsFilesByAllThatTellsRunsApart) {
  std::set<std::string> ids;
  const auto plan = make_plan(ToyExperiment().load());
  for (const auto& run : plan) EXPECT_TRUE(ids.insert(run.id()).second) << run.id();
  EXPECT_EQ(ids.size(), 12U);
}

TEST(Plan, GivesEveryPayloadTheSameRadio) {
  const ToyExperiment toy(with(toy_text, "payloads: [camera], ", ""));
  const auto sut = make_plan(toy.load());
  ASSERT_EQ(sut.size(), 24U);
  EXPECT_EQ(sut[6].payload.name, "plain");
  EXPECT_EQ(sut[6].seed, sut[0].seed);
}

TEST(Plan, KeepsToTheNamesOfASet) {
  const ToyExperiment toy(with(toy_text, "payloads: [camera]", "missions: [b], policies: [none]"));
  for (const auto& run : make_plan(toy.load())) {
    EXPECT_EQ(run.mission.name, "b");
    EXPECT_EQ(run.policy.name, "none");
  }
}

TEST(Seeds, ArePositiveAndAlwaysTheSame) {
  // What has been published must stay what it is.
  EXPECT_EQ(seed_of("quick", "thesis_a", 1), 63613586);
  EXPECT_EQ(seed_of("quick", "thesis_a", 12), 601164442);
  for (int i = 1; i <= 1000; ++i) {
    EXPECT_GE(seed_of("a", "thesis", i), 1);
    EXPECT_LE(seed_of("a", "thesis", i), 1'000'000'000);
  }
}

TEST(Overrides, LetThePolicyHaveTheLastWord) {
  const ToyExperiment toy(with(toy_text, "{name: camera, camera: true}",
                               "{name: camera, camera: true, set: [network_monitor.window=20]}"));
  const Experiment experiment = toy.load();
  const auto sut = overrides_of(make_plan(experiment)[3], experiment.timing, "/share", "/run").set;
  const auto place = [&](const char* text) { return std::find(sut.begin(), sut.end(), text); };
  EXPECT_LT(place("navigator.speed_mps=0.1"), place("network_monitor.window=20"));
  EXPECT_LT(place("network_monitor.window=20"), place("network_monitor.window=10"));
  EXPECT_NE(place("network_monitor.window=10"), sut.end());
}

TEST(Overrides, TakeADotInAValueForNoComponent) {
  const ToyExperiment toy(with(toy_text, "alpha=3", "alpha=3.5"));
  const Experiment experiment = toy.load();
  EXPECT_THAT(overrides_of(make_plan(experiment)[3], experiment.timing, "/share", "/run").set,
              Contains("transmission_controller.alpha=3.5"));
}

TEST(Overrides, HoldSeedFolderAndShare) {
  const ToyExperiment toy;
  const Experiment experiment = toy.load();
  const auto run = make_plan(experiment)[2];
  const auto sut = overrides_of(run, experiment.timing, "/share", "/run");
  EXPECT_EQ(sut.seed, run.seed);
  EXPECT_EQ(sut.share, "/share");
  EXPECT_EQ(sut.run_dir, "/run");
}

}  // namespace
}  // namespace tocsin::experiment
