// SPDX-License-Identifier: Apache-2.0
#include "results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "toy_results.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Results, AreReadInGroups) {
  const ToyResults toy;
  const Results sut = load_results(toy.folder());
  EXPECT_EQ(sut.runs, 12U);
  EXPECT_EQ(sut.build, "0.1.0+toy");
  EXPECT_EQ(sut.experiment.sets[0].title, "The main set");
  ASSERT_EQ(sut.groups.size(), 4U);
  EXPECT_EQ(sut.groups[1].policy, "tocp_dsp");
  EXPECT_THAT(sut.groups[0].indices, ElementsAre(1, 2, 3));
  EXPECT_THAT(sut.groups[0].metric("probe_per_max"), ElementsAre(71, 72, 73));
  EXPECT_TRUE(sut.failures.empty());
  EXPECT_TRUE(sut.real.empty());
}

TEST(Results, PutPoliciesOfTheSameRadioIntoARound) {
  const ToyResults toy;
  const Results sut = load_results(toy.folder());
  const auto rounds = rounds_of(sut.groups, "main");
  ASSERT_EQ(rounds.size(), 2U);
  EXPECT_EQ(rounds[0].size(), 2U);
  EXPECT_EQ(rounds[1][0]->mission, "b");
  EXPECT_TRUE(rounds_of(sut.groups, "other").empty());
}

TEST(Results, FindTheGroupOfAnotherPolicy) {
  const ToyResults toy;
  const Results sut = load_results(toy.folder());
  EXPECT_EQ(find_group(sut.groups, sut.groups[2], "tocp_dsp"), &sut.groups[3]);
  EXPECT_EQ(find_group(sut.groups, sut.groups[2], "belief"), nullptr);
}

TEST(Results, NameRunsThatFailed) {
  const ToyResults toy;
  const auto plan = make_plan(toy.load());
  const ResultStore store(toy.folder(), "series");
  store.write(plan[1], {"policy: threw", 0, {}});
  store.write_table(plan);
  const Results sut = load_results(toy.folder());
  EXPECT_THAT(sut.failures, ElementsAre("main.a.near.camera.none.2: policy: threw"));
  EXPECT_TRUE(std::isnan(sut.groups[0].metric("qni_mean")[1]));
}

TEST(Results, OfAnotherFolderAreRejected) {
  EXPECT_THAT(error_of([] { (void)load_results("/tmp"); }), HasSubstr("holds no results"));
}

TEST(Series, AreAveragedOverRuns) {
  const ToyResults toy;
  const Results sut = load_results(toy.folder());
  const auto per = [](const Observation& one) { return one.probe_per; };
  const auto mean = mean_series(sut.groups[0], per);
  ASSERT_EQ(mean.size(), 10U);
  EXPECT_DOUBLE_EQ(mean[0], 0);
  EXPECT_DOUBLE_EQ(mean[4], 72);
  EXPECT_DOUBLE_EQ(percentile_series(sut.groups[0], per, 1)[4], 73);
}

TEST(Series, EndWhereFewerThanHalfOfTheRunsReach) {
  Group group;
  const Observation one{0, 1, 1, 1, 1, 0, 1, 0, 1, false};
  group.series = {{one, one, one}, {one, one}, {one}, {one}};
  EXPECT_EQ(mean_series(group, [](const Observation& o) { return o.qni; }).size(), 2U);
}

}  // namespace
}  // namespace tocsin::experiment
