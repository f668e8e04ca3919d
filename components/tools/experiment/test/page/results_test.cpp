// SPDX-License-Identifier: Apache-2.0
#include "page/results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "page/toy_results.hpp"

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
  EXPECT_THAT(sut.groups[0].metric(Metric::probe_per_max), ElementsAre(71, 72, 73));
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
  EXPECT_TRUE(std::isnan(sut.groups[0].metric(Metric::qni_mean)[1]));
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

/// A group whose runs have this QNI at each observation.
Group with_series(const std::vector<std::vector<double>>& runs) {
  Group group;
  for (const auto& run : runs) {
    group.series.emplace_back();
    for (const double qni : run) {
      group.series.back().push_back({0, qni, NAN, NAN, 1, 0, 0, 0, NAN, false});
    }
  }
  return group;
}

double qni(const Observation& one) { return one.qni; }

TEST(Series, LeaveOutRunsWithoutAnAnswer) {
  EXPECT_EQ(mean_series(with_series({{10}, {NAN}, {30}}), qni)[0], 20);
}

TEST(Series, HaveAGapWhereNoRunHasAnAnswer) {
  const auto sut = mean_series(with_series({{10, NAN, 30}, {10, NAN, 30}}), qni);
  ASSERT_EQ(sut.size(), 3U);
  EXPECT_TRUE(std::isnan(sut[1]));
  EXPECT_EQ(sut[2], 30);
}

TEST(Series, GoOnWhileHalfOfTheRunsDo) {
  EXPECT_EQ(mean_series(with_series({{1, 2}, {1}}), qni).size(), 2U);
  EXPECT_EQ(mean_series(with_series({{1, 2}, {1}, {1}}), qni).size(), 1U);
}

TEST(Series, TakePercentilesByNearestRank) {
  const auto group = with_series({{40}, {10}, {30}, {20}});
  EXPECT_EQ(percentile_series(group, qni, 0.25)[0], 10);
  EXPECT_EQ(percentile_series(group, qni, 0.5)[0], 20);
  EXPECT_EQ(percentile_series(group, qni, 0.51)[0], 30);
}

TEST(Series, OfNoRunsAreEmpty) { EXPECT_TRUE(mean_series(Group(), qni).empty()); }

TEST(Results, KeepSimulatedAndRealRunsApart) {
  const ToyResults toy;
  toy.add_real();
  const Results sut = load_results(toy.folder());
  EXPECT_EQ(sut.runs, 12U) << "simulated ones only";
  ASSERT_EQ(sut.real.size(), 4U);
  EXPECT_EQ(sut.real[0].metric(Metric::qni_mean)[0], sut.groups[0].metric(Metric::qni_mean)[0] + 1);
}

TEST(Results, NameAllBuildsThatMadeThem) {
  const ToyResults toy;
  const std::string settings = toy.read("out/settings.yaml");
  toy.write("out/settings.yaml",
            with(settings, "build: 0.1.0+toy\n", "build: b\nearlier_builds: [a, 0]\n"));
  EXPECT_EQ(load_results(toy.folder()).build, "b, earlier runs a, earlier runs 0");
}

TEST(Rounds, AreOfOneSetOnly) {
  std::vector<Group> groups(3);
  for (Group& group : groups) group.set = "one";
  groups[1].payload = "plain";
  groups[2].payload = "plain";
  groups[2].policy = "tocp";
  const auto sut = rounds_of(groups, "one");
  ASSERT_EQ(sut.size(), 2U);
  EXPECT_EQ(sut[0].size(), 1U);
  EXPECT_EQ(sut[1].size(), 2U);
}

}  // namespace
}  // namespace tocsin::experiment
