// SPDX-License-Identifier: Apache-2.0
#include "plan/experiment_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/toy.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string error_in(const std::string& old, const std::string& fresh) {
  return error_of([&] { (void)ToyExperiment(with(toy_text, old, fresh)).load(); });
}

TEST(ExperimentFile, ReadsEveryPart) {
  const ToyExperiment toy;
  const Experiment sut = toy.load();
  EXPECT_EQ(sut.timing.duration_s, 100);
  EXPECT_EQ(sut.missions[0].file, toy.path("a.yaml"));
  EXPECT_THAT(sut.missions[0].set, ElementsAre("navigator.speed_mps=0.1"));
  EXPECT_TRUE(sut.payloads[0].camera);
  EXPECT_EQ(sut.sets[0].kind, SetKind::thesis);
  EXPECT_EQ(sut.sets[0].seeds, 3);
}

TEST(ExperimentFile, TakesAllNamesWhereASetNamesNone) {
  const Experiment sut = ToyExperiment().load();
  EXPECT_THAT(sut.sets[0].missions, ElementsAre("a", "b"));
  EXPECT_THAT(sut.sets[0].payloads, ElementsAre("camera"));
}

TEST(ExperimentFile, CallsAPolicyAsItIsNamed) {
  const Experiment sut = ToyExperiment().load();
  EXPECT_EQ(sut.policies[1].policy, "tocp_dsp");
}

TEST(ExperimentFile, NamesTheLineOfAnUnknownKey) {
  EXPECT_THAT(error_in("warm_up_s", "warmup_s"), AllOf(HasSubstr("warmup_s"), HasSubstr(":2)")));
  EXPECT_THAT(error_in("file: b.yaml", "path: b.yaml"), AllOf(HasSubstr("path"), HasSubstr(":6)")));
}

TEST(ExperimentFile, NamesTheLineOfAValueOutOfRange) {
  EXPECT_THAT(error_in("seeds: 3", "seeds: 0"),
              AllOf(HasSubstr("sets[0].seeds: 0"), HasSubstr(":16)")));
}

TEST(ExperimentFile, NamesWhatASetMayName) {
  EXPECT_THAT(error_in("payloads: [camera]", "payloads: [video]"),
              AllOf(HasSubstr("'video' is not one of [camera, plain]"), HasSubstr(":16)")));
}

TEST(ExperimentFile, RejectsANameTwice) {
  EXPECT_THAT(error_in("name: b", "name: a"), AllOf(HasSubstr("a twice"), HasSubstr(":6)")));
}

TEST(ExperimentFile, RejectsANameThatWouldBeNoFileName) {
  EXPECT_THAT(error_in("name: b", "name: B/2"), HasSubstr("is not a name"));
}

TEST(ExperimentFile, RejectsAMissionFileThatIsNotThere) {
  EXPECT_THAT(error_in("file: b.yaml", "file: c.yaml"),
              AllOf(HasSubstr("missions[1].file"), HasSubstr("c.yaml"), HasSubstr(":6)")));
}

TEST(ExperimentFile, RejectsAListThatIsMissingOrEmpty) {
  EXPECT_THAT(error_in("  - {name: near, file: \"near_${mission}.yaml\"}\n", ""),
              HasSubstr("experiment.channels: is not a list"));
  EXPECT_THAT(error_in("payloads:\n  - {name: camera, camera: true}\n  - {name: plain}\n", ""),
              HasSubstr("experiment.payloads: is not a list"));
}

TEST(ExperimentFile, SaysThatARunHasOneVehicle) {
  EXPECT_EQ(ToyExperiment(std::string("vehicles: 1\n") + toy_text).load().timing.vehicles, 1);
  const ToyExperiment two(std::string("vehicles: 2\n") + toy_text);
  EXPECT_THAT(error_of([&] { (void)two.load(); }),
              HasSubstr("experiment.vehicles: 2 is not possible"));
}

TEST(ExperimentFile, RejectsAWarmUpThatLeavesNothing) {
  EXPECT_THAT(error_in("warm_up_s: 0", "warm_up_s: 100"), HasSubstr("less than duration_s"));
}

TEST(ExperimentFile, RejectsWhatIsNotYaml) {
  EXPECT_THAT(error_in("sets:", "sets: ["), HasSubstr("toy.yaml"));
  EXPECT_THAT(error_of([] { (void)load_experiment("/nonexistent.yaml"); }),
              HasSubstr("/nonexistent.yaml"));
}

TEST(ExperimentFile, HasWeightsOfItsOwn) {
  EXPECT_EQ(ToyExperiment().load().timing.cost.critical_late, 10);
  const ToyExperiment sut(std::string(toy_text) + "cost: {critical_late: 3}\n");
  EXPECT_EQ(sut.load().timing.cost.critical_late, 3);
  EXPECT_EQ(sut.load().timing.cost.high_late, 4);
  EXPECT_THAT(error_in("warm_up_s: 0", "warm_up_s: 0\ncost: {high_late: -1}"),
              AllOf(HasSubstr("experiment.cost.high_late: -1 is outside"), HasSubstr(":3)")));
  EXPECT_THAT(error_in("warm_up_s: 0", "warm_up_s: 0\ncost: {hi: 1}"),
              HasSubstr("experiment.cost.hi: unknown key"));
}

TEST(ExperimentFile, NamesTheChannelWhoseSeedsAreNotThere) {
  EXPECT_THAT(error_in("{name: near,", "{name: near, seeds_of: far,"),
              HasSubstr("channels[0].seeds_of: 'far' is not a channel"));
}

TEST(ExperimentFile, IsParsedWithoutItsFiles) {
  const Experiment sut = parse_experiment(toy_text, "/nowhere/toy.yaml");
  EXPECT_EQ(sut.missions.size(), 2U);
}

TEST(ExperimentFile, ShippedOnesLoad) {
  const std::string config = std::string(TOCSIN_REPOSITORY) + "/config/experiments/";
  const Experiment thesis = load_experiment(config + "thesis.yaml");
  EXPECT_EQ(make_plan(thesis).size(), 800U);
  EXPECT_NO_THROW((void)make_plan(load_experiment(config + "study.yaml")));
  EXPECT_EQ(make_plan(load_experiment(config + "replay.yaml")).size(), 15U);
  EXPECT_EQ(make_plan(load_experiment(config + "link.yaml")).size(), 560U);
}

TEST(ExperimentFile, ShippedOnesFitOnSeedsThatAreNotCompared) {
  const std::string config = std::string(TOCSIN_REPOSITORY) + "/config/experiments/";
  int fitted = 0;
  for (const RunSet& set : load_experiment(config + "study.yaml").sets) {
    if (set.kind != SetKind::fit) {
      EXPECT_LT(set.first_seed + set.seeds, 1001) << set.name;
    } else {
      EXPECT_GE(set.first_seed, 1001) << set.name;
      fitted += set.seeds;
    }
  }
  EXPECT_EQ(fitted, 20);
}

}  // namespace
}  // namespace tocsin::experiment
