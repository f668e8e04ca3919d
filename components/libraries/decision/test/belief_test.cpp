// SPDX-License-Identifier: Apache-2.0
#include "decision/belief.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "foundation/error.hpp"
#include "golden.hpp"

namespace tocsin::decision {
namespace {

const TwoStateChannel s1{1 / 120.0, 1 / 20.0};

Density normal(Normal law) { return {Family::normal, {law.mean, law.sd, 0}}; }

TEST(BeliefFilter, FollowsBayesByHand) {
  BeliefFilter sut({0.1, 0.5});
  EXPECT_DOUBLE_EQ(sut.predicted(), 0.1);
  // prior odds 1/9, ratio 9: even; next 0.5 * 0.5 + 0.5 * 0.1
  EXPECT_NEAR(sut.add(std::log(9)), 0.3, 1e-12);
  EXPECT_NEAR(sut.posterior(), 0.5, 1e-12);
}

TEST(BeliefFilter, OnlyPredictsWithoutAMeasurement) {
  BeliefFilter sut(s1);
  for (int i = 0; i < 2000; ++i) sut.add(NAN);
  EXPECT_NEAR(sut.predicted(), 20 / 140.0, 1e-9);
}

TEST(BeliefFilter, SurvivesInfiniteEvidence) {
  BeliefFilter sut(s1);
  EXPECT_NEAR(sut.add(INFINITY), 0.95, 1e-12);
  EXPECT_NEAR(sut.add(-INFINITY), 1 / 120.0, 1e-12);
}

TEST(BeliefFilter, ForgetsToTheLongRunShare) {
  BeliefFilter sut(s1);
  sut.add(50);
  sut.forget();
  EXPECT_NEAR(sut.predicted(), 20 / 140.0, 1e-12);
}

TEST(BeliefFilter, RejectsProbabilitiesThatAreNone) {
  EXPECT_THROW(BeliefFilter({0, 0.5}), ConfigError);
  EXPECT_THROW(BeliefFilter({0.5, 1}), ConfigError);
  EXPECT_THROW(BeliefFilter({NAN, 0.5}), ConfigError);
}

// Section 2.6 of the checked theory, S1: pause at .631; stay at .212, .244, .336, .769.
TEST(SolveBelief, HasTheKnownThresholds) {
  const auto sut = solve_belief(s1, {}, normal(thesis_good), normal(thesis_bad), 30).threshold;
  ASSERT_EQ(sut.size(), 31U);
  EXPECT_NEAR(sut[0], 0.631, 0.01);
  EXPECT_NEAR(sut[1], 0.212, 0.01);
  EXPECT_NEAR(sut[10], 0.244, 0.01);
  EXPECT_NEAR(sut[20], 0.336, 0.01);
  EXPECT_NEAR(sut[29], 0.769, 0.01);
}

TEST(SolveBelief, IsReadierToSpeakTheNearerTheDeadline) {
  const auto sut = solve_belief(s1, {}, normal(thesis_good), normal(thesis_bad), 10).threshold;
  for (std::size_t age = 2; age < 10; ++age) EXPECT_GT(sut[age], sut[age - 1]);
}

TEST(SolveBelief, NeverFallsSilentWhenAChangeCostsTooMuch) {
  const SlotCosts costs{1, 0.5, 0.1, 1000};
  EXPECT_GT(solve_belief(s1, costs, normal(thesis_good), normal(thesis_bad), 5).threshold[0], 1);
}

TEST(MyopicBelief, ComparesTheCostsOfOneSlot) {
  EXPECT_NEAR(myopic_belief({}, 30).threshold[7], 0.5 / 1.4, 1e-12);
  EXPECT_NEAR(myopic_belief({1, 1, 0, 0}, 30).threshold[0], 0.5, 1e-12);
}

Normal pair(const nlohmann::json& law) { return {law[0], law[1]}; }

TEST(SolveBelief, AgreesWithTheGoldenTable) {
  const auto path = golden_file("belief_dp_policy.json");
  if (path.empty()) GTEST_SKIP() << "no golden numbers on this machine";
  const auto file = nlohmann::json::parse(std::ifstream(path));
  Deviations all;
  int never = 0;
  for (const auto& row : file["table"]) {
    const SlotCosts costs{row["cL"], row["cS"], row["cPB"], row["cW"]};
    const auto sut = solve_belief({row["p01"], row["p10"]}, costs, normal(pair(row["f0"])),
                                  normal(pair(row["f1"])), row["Tmax"])
                         .threshold;
    for (std::size_t age = 0; age < 30; ++age) {
      const auto& want = row["pi_threshold_by_age"][age];
      if (want.is_null()) {
        EXPECT_GT(sut[age], 1 - double(row["p10"])) << age;  // beyond what can be reached
        ++never;
      } else {
        all.absolute(sut[age], want, 1e-2);
      }
    }
  }
  std::cout << "belief_dp_policy: " << all.summary() << "; " << never << " never\n";
  EXPECT_EQ(all.compared() + never, 360);
  EXPECT_EQ(all.outside(), 0);
}

void follow(const char* name) {
  const auto path = golden_file(name);
  if (path.empty()) GTEST_SKIP() << "no golden numbers on this machine";
  Table t = read_table(path);
  const NormalLlr llr;
  BeliefFilter sut(s1);
  Deviations all;
  for (std::size_t n = 0; n < t.rows; ++n) {
    sut.add(llr(t.columns["qni"][n]));
    all.strictly_relative(sut.posterior(), t.columns["hmm_bad"][n], 1e-9);
  }
  std::cout << name << ' ' << all.summary() << '\n';
  EXPECT_EQ(all.compared(), 1500);
  EXPECT_EQ(all.outside(), 0);
}

TEST(BeliefFilter, FollowsGoldenTrace1) { follow("trace1_iid.csv"); }
TEST(BeliefFilter, FollowsGoldenTrace2) { follow("trace2_ar_ramp.csv"); }

}  // namespace
}  // namespace tocsin::decision
