// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "page/section_fixture.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(SectionTest, SaysWhereAPolicyHelps) {
  pair(30, 20, 900, 500);
  EXPECT_THAT(text(add_regimes), HasSubstr("<td>helps</td>"));
}

TEST_F(SectionTest, SaysWhereItHarms) {
  pair(20, 30, 500, 500);
  EXPECT_THAT(text(add_regimes), HasSubstr("<td>harms</td>"));
}

TEST_F(SectionTest, SaysWhereItDoesBoth) {
  pair(20, 30, 900, 500);
  EXPECT_THAT(text(add_regimes), HasSubstr("<td>helps and harms</td>"));
}

TEST_F(SectionTest, SaysWhereNothingIsShown) {
  pair(20, 20, 500, 500);
  EXPECT_THAT(text(add_regimes), HasSubstr("<td>no difference shown</td>"));
}

TEST_F(SectionTest, ComparesRegimesOnlyWithNoPolicyBesideIt) {
  add("tocp_dsp");
  EXPECT_EQ(text(add_regimes), "");
}

TEST_F(SectionTest, ShowsMeansAndDifferences) {
  pair(30, 20, 900, 500);
  const std::string sut = text(add_comparisons);
  EXPECT_THAT(sut, AllOf(HasSubstr("The main set"), HasSubstr("telemetry_per_max [%]"),
                         HasSubstr("30.0 [30.0, 30.0]"), HasSubstr("TOCP-DSP minus ...")));
  EXPECT_THAT(sut, Not(HasSubstr("<td>camera_lost [%]</td><td>-</td><td>-</td>")));
}

TEST_F(SectionTest, KeepsToTheKindsOfTheSets) {
  pair(30, 20, 900, 500);
  EXPECT_EQ(text(add_thesis), "");
  EXPECT_EQ(text(add_sensitivity), "");
  EXPECT_EQ(text(add_verdicts), "");
  EXPECT_EQ(text(add_distributions), "");
  EXPECT_EQ(text(add_reality), "");
}

TEST_F(SectionTest, DrawsABoxFigureForEachMetricOfTheThesisSet) {
  results_.experiment.sets[0].kind = "thesis";
  pair(30, 20, 900, 500);
  (void)text(add_distributions);
  EXPECT_THAT(figures_,
              AllOf(HasSubstr("telemetry_per_max over runs"), HasSubstr("silence_max over runs")));
}

TEST_F(SectionTest, TellsTheChannelOnceForEachMission) {
  pair(30, 20, 900, 500);
  (void)text(add_channels);
  EXPECT_EQ(figures_, "Mission A, channel near: mean SNR on the way\n");
}

TEST_F(SectionTest, RanksPoliciesByCostAndSaysWhoIsBestAtWhat) {
  pair(20, 30, 500, 900);
  set(results_.groups[0], Metric::user_cost, 300);
  set(results_.groups[1], Metric::user_cost, 100);
  const std::string sut = text(add_costs);
  EXPECT_LT(sut.find("<td>TOCP-DSP</td><td>100"), sut.find("<td>no policy</td><td>300"));
  EXPECT_THAT(sut, HasSubstr("<span class=\"yes\">-200 [-200, -200]</span>"));
  EXPECT_THAT(sut, HasSubstr("<td>telemetry_per_max [%]</td><td>20.0 [20.0, 20.0]</td>"
                             "<td>no policy</td>"));
  EXPECT_THAT(sut, HasSubstr("<span class=\"no\">10.0 [10.0, 10.0]</span>"));
  EXPECT_THAT(sut, HasSubstr("it is the best"));
  EXPECT_THAT(figures_, HasSubstr("cost of what users feel"));
}

TEST_F(SectionTest, TellsTheWeightsOfTheCostAndWhatItIsMadeOf) {
  pair(20, 30, 500, 900);
  set(results_.groups[0], Metric::critical_late, 12);
  results_.experiment.timing.cost.high_late = 77;
  const std::string sut = text(add_costs);
  EXPECT_THAT(sut, AllOf(HasSubstr("critical_late 10.0, "), HasSubstr("high_late 77.0, ")));
  EXPECT_THAT(sut, HasSubstr("<th>critical_late [%]</th>"));
  EXPECT_THAT(sut, HasSubstr("<td>12.0 [12.0, 12.0]</td>"));
}

TEST_F(SectionTest, HasNoCostsOfASinglePolicy) {
  add("tocp_dsp");
  EXPECT_EQ(text(add_costs), "");
}

TEST_F(SectionTest, TellsTheRuleOfTheParameters) {
  EXPECT_THAT(text(add_fit), HasSubstr("No file of fitted parameters"));
  results_.fitted = {{"a", {{"threshold", {"pause_below_qni=60", "resume_at_qni=65"}}}}};
  EXPECT_THAT(text(add_fit), AllOf(HasSubstr("By one rule for all"),
                                   HasSubstr("<td>pause_below_qni=60 resume_at_qni=65</td>")));
}

TEST_F(SectionTest, ShowsAgesAndLossesOfTheThesisSet) {
  results_.experiment.sets[0].kind = "thesis";
  pair(30, 20, 900, 500);
  (void)text(add_distributions);
  EXPECT_THAT(figures_,
              AllOf(HasSubstr("age of information at the ground station"),
                    HasSubstr("too late or never"), HasSubstr("lost of what was sent, by class")));
}

/// A real group of the same runs, QNI a point lower; the first was not done.
TEST_F(SectionTest, ShowsAllPairsAndThoseThatFinished) {
  pair(30, 20, 900, 500);
  for (Group& group : results_.groups) {
    set(group, Metric::qni_mean, 70);
    for (auto& run : group.values) run[index_of(Metric::completed)] = 1;
  }
  results_.real = results_.groups;
  for (Group& group : results_.real) set(group, Metric::qni_mean, 69);
  results_.real[0].values[0][index_of(Metric::completed)] = 0;
  results_.real[1].values[2].clear();
  const std::string sut = text(add_reality);
  EXPECT_THAT(sut, HasSubstr("Of 9 pairs left out: none 1."));
  EXPECT_THAT(sut, HasSubstr("-1.00 [-1.00, -1.00]</td><td>9</td>"));
  EXPECT_THAT(sut, HasSubstr("-1.00 [-1.00, -1.00]</td><td>8</td>"));
}

TEST_F(SectionTest, SaysThatRealRunsHaveNoPairYet) {
  pair(30, 20, 900, 500);
  results_.real.swap(results_.groups);
  EXPECT_THAT(text(add_reality), HasSubstr("no simulated runs of these seeds yet"));
}

TEST_F(SectionTest, ListsFailures) {
  results_.failures = {"main.a.none.1: threw <badly>"};
  EXPECT_THAT(text(add_overview), AllOf(HasSubstr("1 runs failed"), HasSubstr("&lt;badly&gt;")));
}

TEST_F(SectionTest, VerdictsGoThroughAllOtherPolicies) {
  results_.experiment.sets[0].kind = "thesis";
  pair(30, 20, 900, 500);
  const std::string sut = text(add_verdicts);
  EXPECT_THAT(sut, HasSubstr("beats</span> no policy on telemetry_per_max"));
  EXPECT_THAT(sut, HasSubstr("beats</span> no policy on high_latency_p99"));
  EXPECT_EQ(sut.find("user_cost"), std::string::npos) << "nobody has an answer";
}

TEST_F(SectionTest, VerdictsBeginWithWhatUsersFeel) {
  results_.experiment.sets[0].kind = "thesis";
  pair(30, 20, 900, 500);
  set(results_.groups[0], Metric::user_cost, 100);
  set(results_.groups[1], Metric::user_cost, 120);
  const std::string sut = text(add_verdicts);
  const std::size_t cost = sut.find("loses to</span> no policy on user_cost");
  ASSERT_NE(cost, std::string::npos);
  EXPECT_LT(cost, sut.find("no policy on telemetry_per_max"));
}

}  // namespace
}  // namespace tocsin::experiment
