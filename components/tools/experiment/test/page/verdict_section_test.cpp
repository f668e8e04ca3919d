// SPDX-License-Identifier: Apache-2.0
// What the report concludes: costs, regimes, distributions, and simulated against real.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "page/section_fixture.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

using CostSectionTest = SectionTest;

TEST_F(CostSectionTest, RanksFromTheLeastCostOn) {
  for (const auto& [policy, cost] :
       {std::pair{"none", 300.0}, {"tocp_dsp", 200.0}, {"belief", 100.0}}) {
    set(add(policy), Metric::user_cost, cost);
  }
  const std::string sut = text(add_costs);
  const auto place = [&](const std::string& policy) { return sut.find("<tr><td>" + policy); };
  EXPECT_LT(place("belief"), place("TOCP-DSP"));
  EXPECT_LT(place("TOCP-DSP"), place("no policy"));
}

TEST_F(CostSectionTest, MarksWhoIsCheaperThanTocpDspRed) {
  set(add("tocp_dsp"), Metric::user_cost, 200);
  set(add("belief"), Metric::user_cost, 100);
  EXPECT_THAT(text(add_costs), HasSubstr("<span class=\"no\">100.0 [100.0, 100.0]</span>"));
}

TEST_F(CostSectionTest, LeavesOpenWhatTheIntervalDoesNotTell) {
  add("tocp_dsp");
  add("belief");
  for (std::size_t i = 0; i < 5; ++i) {
    results_.groups[0].values[i][index_of(Metric::user_cost)] = i % 2 == 0 ? 110 : 90;
    results_.groups[1].values[i][index_of(Metric::user_cost)] = 100;
  }
  EXPECT_THAT(text(add_costs), HasSubstr("<span class=\"open\">"));
}

TEST_F(CostSectionTest, KnowsThatMoreDeliveredIsBetter) {
  set(add("tocp_dsp"), Metric::low_delivered, 80);
  set(add("none"), Metric::low_delivered, 90);
  EXPECT_THAT(text(add_costs), HasSubstr("<td>low_delivered [%]</td><td>90.0 [90.0, 90.0]</td>"
                                         "<td>no policy</td>"));
}

TEST_F(CostSectionTest, LeavesOutAMetricThatNoPolicyHas) {
  set(add("tocp_dsp"), Metric::user_cost, 200);
  set(add("none"), Metric::user_cost, 300);
  EXPECT_THAT(text(add_costs), Not(HasSubstr("<td>probe_per_max [%]</td>")));
}

TEST_F(CostSectionTest, IsOfSetsThatCompareOnly) {
  add("tocp_dsp");
  add("none");
  for (const char* other : {"sensitivity", "real", "fit"}) {
    kind(other);
    EXPECT_EQ(text(add_costs), "") << other;
  }
}

using RegimeTest = SectionTest;

TEST_F(RegimeTest, HasARowForEachPayload) {
  pair(30, 20, 900, 500);
  add("none", "plain");
  add("tocp_dsp", "plain");
  const std::string sut = text(add_regimes);
  EXPECT_THAT(sut, HasSubstr("payload camera</td><td>helps</td>"));
  EXPECT_THAT(sut, HasSubstr("payload plain</td><td>no difference shown</td>"));
}

TEST_F(RegimeTest, ColoursFewerDeliveredRed) {
  pair(30, 20, 900, 500);
  set(results_.groups[0], Metric::low_delivered, 90);
  set(results_.groups[1], Metric::low_delivered, 80);
  EXPECT_THAT(text(add_regimes), HasSubstr("<span class=\"no\">-10.0 [-10.0, -10.0]</span>"));
}

TEST_F(RegimeTest, CountsTheLossOfClassHighToo) {
  pair(20, 20, 500, 500);
  set(results_.groups[0], Metric::high_lost, 5);
  set(results_.groups[1], Metric::high_lost, 2);
  EXPECT_THAT(text(add_regimes), HasSubstr("<td>helps</td>"));
}

using ChannelSectionTest = SectionTest;

TEST_F(ChannelSectionTest, DrawsTheMeanSnrAndTheLimitOfPoor) {
  results_.experiment.timing.poor_below_snr_db = 11;
  results_.experiment.timing.observation_s = 6;
  series(add("none"), &Observation::snr_db, {20, 8});
  (void)text(add_channels);
  EXPECT_THAT(scripts_, HasSubstr("0 20 \n6 8 \n"));
  EXPECT_THAT(scripts_, HasSubstr("0 11 \n6 11 \n"));
}

TEST_F(ChannelSectionTest, ShowsEachMissionOnEachChannel) {
  add("none");
  add("tocp_dsp");
  add("none", "camera", "b");
  add("none").channel = "far";
  (void)text(add_channels);
  EXPECT_EQ(figures_,
            "Mission A, channel near: mean SNR on the way\n"
            "Mission B, channel near: mean SNR on the way\n"
            "Mission A, channel far: mean SNR on the way\n");
}

TEST_F(ChannelSectionTest, TellsTheShareThatWasPoor) {
  set(add("none"), Metric::poor_share, 24.97);
  EXPECT_THAT(text(add_channels), HasSubstr("Truly poor in 25.0 [25.0, 25.0] % of the time"));
}

using DistributionTest = SectionTest;

TEST_F(DistributionTest, HasBoxesOfTheRunsOfEachPolicy) {
  kind("thesis");
  pair(30, 20, 900, 500);
  (void)text(add_distributions);
  EXPECT_THAT(scripts_, HasSubstr("\"no policy\" 1, \"TOCP-DSP\" 2"));
  // Quartiles of 30.01 to 30.05, whiskers at the ends of five runs.
  EXPECT_THAT(scripts_, HasSubstr("1 30.02 30.01 30.05 30.04 30.03 \n"));
}

TEST_F(DistributionTest, PutsPoliciesSideBySideAtEachClass) {
  kind("thesis");
  set(add("none"), Metric::critical_lost, 0.97);
  set(add("tocp_dsp"), Metric::critical_lost, 1.97);
  (void)text(add_distributions);
  EXPECT_THAT(scripts_, HasSubstr("\"critical\" 1, \"high\" 2, \"low, no camera\" 3"));
  EXPECT_THAT(scripts_, HasSubstr("0.7 1 "));
  EXPECT_THAT(scripts_, HasSubstr("1 2 "));
}

using ComparisonTest = SectionTest;

TEST_F(ComparisonTest, LeavesOutMetricsThatNoRunHas) {
  set(add("none"), Metric::qni_mean, 70);
  const std::string sut = text(add_comparisons);
  EXPECT_THAT(sut, HasSubstr("<td>qni_mean [%]</td>"));
  EXPECT_THAT(sut, Not(HasSubstr("camera_age_mean")));
}

TEST_F(ComparisonTest, HasNoDifferencesOfASinglePolicy) {
  set(add("tocp_dsp"), Metric::qni_mean, 70);
  EXPECT_THAT(text(add_comparisons), Not(HasSubstr("paired differences")));
}

TEST_F(ComparisonTest, PairsRunByRun) {
  // The runs differ by 10, the policies by 1 in each: a sharp difference of means that are not.
  add("none");
  add("tocp_dsp");
  for (std::size_t i = 0; i < 5; ++i) {
    const double base = 50 + 10 * static_cast<double>(i);
    results_.groups[0].values[i][index_of(Metric::qni_mean)] = base;
    results_.groups[1].values[i][index_of(Metric::qni_mean)] = base + 1;
  }
  EXPECT_THAT(text(add_comparisons), HasSubstr("<span class=\"yes\">1.00 [1.00, 1.00]</span>"));
}

/// Simulated and real groups of `runs` seeds; QNI of the real ones `off` points higher.
class RealityTest : public SectionTest {
 protected:
  void pairs(int runs, double off) {
    for (const char* policy : {"none", "tocp_dsp"}) {
      Group& group = add(policy);
      group.indices.clear();
      group.values.clear();
      group.series.clear();
      for (int i = 1; i <= runs / 2; ++i) {
        group.indices.push_back(i);
        group.values.emplace_back(metric_count, std::nan(""));
        group.series.emplace_back();
      }
      for (auto& run : group.values) run[index_of(Metric::completed)] = 1;
      set(group, Metric::qni_mean, 70);
      set(group, Metric::high_delivered, 97);
    }
    results_.real = results_.groups;
    for (Group& group : results_.real) set(group, Metric::qni_mean, 70 + off);
  }
};

TEST_F(RealityTest, MeetsItsGoalWithTwentyPairsWithinTwoPoints) {
  pairs(20, 1.9);
  const std::string sut = text(add_reality);
  EXPECT_THAT(sut, HasSubstr("<span class=\"yes\">met</span>: mean QNI, all pairs, within 2.00"));
  EXPECT_THAT(sut, HasSubstr("real minus simulated 1.90 [1.90, 1.90] over 20 pairs"));
}

TEST_F(RealityTest, DoesNotMeetItTwoPointsAndMoreAway) {
  pairs(20, 2.1);
  EXPECT_THAT(text(add_reality), HasSubstr("<span class=\"no\">not met</span>: mean QNI, all"));
}

TEST_F(RealityTest, DoesNotMeetItBelowEither) {
  pairs(20, -2.1);
  EXPECT_THAT(text(add_reality), HasSubstr("<span class=\"no\">not met</span>: mean QNI, all"));
}

TEST_F(RealityTest, LeavesItOpenWithFewerPairs) {
  pairs(18, 0.1);
  EXPECT_THAT(text(add_reality),
              HasSubstr("<span class=\"open\">so far, over too few pairs</span>: mean QNI, all"));
}

TEST_F(RealityTest, PairsRunsOfTheSameSeedWhateverTheirPlace) {
  pairs(20, 1);
  for (Group& group : results_.real) {
    group.indices.erase(group.indices.begin());
    group.values.erase(group.values.begin());
  }
  EXPECT_THAT(text(add_reality), HasSubstr("1.00 [1.00, 1.00] over 18 pairs"));
}

TEST_F(RealityTest, LeavesOutARealRunWithoutASimulatedOne) {
  pairs(20, 1);
  results_.real[0].policy = "belief";
  EXPECT_THAT(text(add_reality), HasSubstr("over 10 pairs"));
}

TEST_F(RealityTest, NamesThePairsThatDidNotFinish) {
  pairs(20, 1);
  results_.real[1].values[3][index_of(Metric::completed)] = 0;
  results_.groups[0].values[0][index_of(Metric::completed)] = 0;
  EXPECT_THAT(text(add_reality), HasSubstr("Of 20 pairs left out: none 1, tocp_dsp 4."));
}

TEST_F(RealityTest, LeavesNoneOutWhenAllFinished) {
  pairs(20, 1);
  EXPECT_THAT(text(add_reality), HasSubstr("Of 20 pairs left out: none."));
}

TEST_F(RealityTest, DrawsEachPairBesideTheDiagonal) {
  pairs(4, 1);
  (void)text(add_reality);
  EXPECT_THAT(figures_, AllOf(HasSubstr("Simulated and real, run by run: qni_mean"),
                              HasSubstr("Simulated and real, run by run: high_delivered")));
  EXPECT_THAT(scripts_, HasSubstr("70.01 71.01 \n"));
}

}  // namespace
}  // namespace tocsin::experiment
