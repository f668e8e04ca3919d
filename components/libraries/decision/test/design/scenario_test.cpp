// SPDX-License-Identifier: Apache-2.0
#include "decision/design/scenario.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace tocsin::decision {
namespace {

Scenario scenario(int i) { return standard_scenarios()[static_cast<std::size_t>(i) - 1]; }

TEST(Simulate, IsTheSameForTheSameSeed) {
  EXPECT_EQ(simulate(scenario(1), 1000, 7).qni, simulate(scenario(1), 1000, 7).qni);
  EXPECT_NE(simulate(scenario(1), 1000, 7).qni, simulate(scenario(1), 1000, 8).qni);
}

TEST(Simulate, HasTheShareOfBadSlotsThatItsLengthsGive) {
  for (const Scenario& one : standard_scenarios()) {
    const SimulatedTrace sut = simulate(one, 200000, 1);
    double bad = 0;
    for (const bool b : sut.bad) bad += b;
    const double want = one.mean_bad_samples / (one.mean_bad_samples + one.mean_good_samples);
    EXPECT_NEAR(bad / 200000, want, 0.02) << one.name;
  }
}

TEST(Simulate, StaysOnTheScale) {
  for (const double x : simulate(scenario(4), 50000, 3).qni) {
    EXPECT_GE(x, 0);
    EXPECT_LE(x, 100);
  }
}

TEST(Simulate, RampsInS5OnlyAndCorrelatesNeighbours) {
  const SimulatedTrace sut = simulate(scenario(5), 100000, 1);
  double top = 0;
  double bottom = 0;
  for (std::size_t n = 1; n < sut.qni.size(); ++n) {
    if (sut.bad[n] || sut.bad[n - 1]) continue;
    top += (sut.qni[n] - 81.5) * (sut.qni[n - 1] - 81.5);
    bottom += (sut.qni[n] - 81.5) * (sut.qni[n] - 81.5);
  }
  EXPECT_GT(top / bottom, 0.75);
}

TEST(Decide, SpeaksInTheFirstSlotAndLagsByOne) {
  PolicyParams params;
  params.policy = PolicyKind::threshold;
  const auto sut = make_policy(params);
  EXPECT_EQ(decide(*sut, {20, 90, 90}), (std::vector<bool>{true, false, true}));
}

TEST(Estimate, GivesMeanAndStandardError) {
  const Estimate sut = estimate({1, 2, 3, 4});
  EXPECT_DOUBLE_EQ(sut.mean, 2.5);
  EXPECT_DOUBLE_EQ(sut.standard_error, std::sqrt(5.0 / 3 / 4));
  EXPECT_EQ(estimate({7}).standard_error, 0);
}

PolicyParams params_for(const std::string& policy, const Scenario& one) {
  PolicyParams params;
  params.policy = value_of<PolicyKind>(policy).value();
  params.th_max_s = 86400;
  return fitted_to(one, params);
}

struct Reference {
  double tocp_dsp;
  double error;  // standard error of the reference
};

/// A short slice of the campaign of test/bench/decision: the targets of the project on S1 to S3.
class Regret : public ::testing::TestWithParam<int> {};

TEST_P(Regret, OfBeliefAndReverseIsNearTheOptimumAndFarBelowTocpDsp) {
  const Scenario one = scenario(GetParam());
  Campaign slice;
  slice.seeds = 6;
  slice.slots = 60000;
  const auto all = regrets(
      one,
      {params_for("belief", one), params_for("tocp_reverse", one), params_for("tocp_dsp", one)},
      slice);
  const Estimate belief = estimate(all[0]);
  const Estimate reverse = estimate(all[1]);
  const Estimate dsp = estimate(all[2]);
  std::cout << one.name << " belief " << belief.mean << " reverse " << reverse.mean << " dsp "
            << dsp.mean << " +- " << dsp.standard_error << '\n';
  EXPECT_LE(reverse.mean, 1.10 * belief.mean);
  EXPECT_LE(belief.mean, 0.35 * dsp.mean);
  EXPECT_LE(reverse.mean, 0.35 * dsp.mean);
  // reference: 20 seeds of 200 000 slots
  const Reference references[] = {{37.03, 0.21}, {39.01, 0.22}, {80.42, 0.29}};
  const Reference& want = references[GetParam() - 1];
  EXPECT_NEAR(dsp.mean, want.tocp_dsp, 3 * std::hypot(dsp.standard_error, want.error));
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Regret, ::testing::Values(1, 2, 3));

TEST(RegretUnderGlitches, IsHalvedByClippingTheRatios) {
  Campaign slice;
  slice.seeds = 3;
  slice.slots = 40000;
  const Scenario& one = glitch_scenarios()[1];
  const PolicyParams plain = params_for("tocp_reverse", one);
  PolicyParams clipped = plain;
  clipped.llr_clip = 4;
  clipped.alpha = 6.9;
  const auto all = regrets(one, {plain, clipped}, slice);
  EXPECT_LT(estimate(all[1]).mean, 0.5 * estimate(all[0]).mean);
}

TEST(RegretOfEveryPolicy, IsNeverBelowZero) {
  const Scenario one = scenario(4);
  Campaign slice;
  slice.seeds = 2;
  slice.slots = 20000;
  for (const char* name : {"none", "threshold", "tocp", "tocp_dsp", "tocp_reverse", "belief"}) {
    const auto sut = regrets(one, {params_for(name, one)}, slice);
    for (const double x : sut[0]) EXPECT_GE(x, 0) << name;
  }
}

}  // namespace
}  // namespace tocsin::decision
