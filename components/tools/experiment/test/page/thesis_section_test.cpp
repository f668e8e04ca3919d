// SPDX-License-Identifier: Apache-2.0
// The thesis's figures and numbers, its verdicts, the overview and the sensitivity of the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "page/section_fixture.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class ThesisSectionTest : public SectionTest {
 protected:
  ThesisSectionTest() { kind("thesis"); }
  /// The thesis's four policies in one mission, QNI 70 to 73 and a series of two observations.
  void four(const std::string& mission) {
    double qni = 70;
    for (const char* policy : {"none", "threshold", "tocp", "tocp_dsp"}) {
      Group& group = add(policy, "camera", mission);
      set(group, Metric::qni_mean, qni);
      set(group, Metric::high_latency_median, 200 - qni);
      series(group, &Observation::qni, {qni, qni + 1});
      qni += 1;
    }
  }
};

TEST_F(ThesisSectionTest, NumbersTheFiguresOfBothMissionsAsTheThesisDid) {
  four("a");
  four("b");
  (void)text(add_thesis);
  for (int number = 43; number <= 52; ++number) {
    EXPECT_THAT(scripts_, HasSubstr("\"fig" + std::to_string(number) + "_main_")) << number;
  }
  EXPECT_THAT(scripts_, Not(HasSubstr("fig42")));
  EXPECT_THAT(scripts_, Not(HasSubstr("fig53")));
}

TEST_F(ThesisSectionTest, KeepsTheNumbersWhenAPolicyIsNotThere) {
  add("none");
  add("tocp_dsp");
  (void)text(add_thesis);
  EXPECT_THAT(scripts_, AllOf(HasSubstr("fig43_"), HasSubstr("fig46_"), HasSubstr("fig47_")));
  EXPECT_THAT(scripts_, AllOf(Not(HasSubstr("fig44_")), Not(HasSubstr("fig45_"))));
}

TEST_F(ThesisSectionTest, ShowsOnlyPacketErrorsWithoutTocpDsp) {
  add("none");
  (void)text(add_thesis);
  EXPECT_EQ(figures_, "Mission A: packet error rate of the four policies\n");
}

TEST_F(ThesisSectionTest, LeavesOtherPoliciesOutOfItsTable) {
  four("a");
  add("belief");
  EXPECT_THAT(text(add_thesis), Not(HasSubstr("<td>belief</td>")));
}

TEST_F(ThesisSectionTest, PutsTheThesisNumbersBesideOurs) {
  four("b");
  const std::string sut = text(add_thesis);
  // Policy, the thesis's highest PER, ours (not measured here), ..., its QNI and ours.
  EXPECT_THAT(sut, HasSubstr("<td>no policy</td><td>30.0</td><td>-</td><td>-</td><td>-</td>"
                             "<td>68.4</td><td>70.0 [70.0, 70.0]</td>"));
  EXPECT_THAT(sut, HasSubstr("<td>threshold</td><td>20.0</td>"));
  EXPECT_THAT(sut, HasSubstr("<td>TOCP</td><td>20.0</td>"));
  EXPECT_THAT(sut, HasSubstr("<td>TOCP-DSP</td><td>10.0</td><td>-</td><td>-</td><td>-</td>"
                             "<td>76.3</td><td>73.0 [73.0, 73.0]</td>"));
}

TEST_F(ThesisSectionTest, KnowsThatTheThesisPrintsNoQniOfMissionA) {
  four("a");
  EXPECT_THAT(text(add_thesis), HasSubstr("<td>threshold</td><td>45.0</td><td>-</td><td>-</td>"
                                          "<td>-</td><td>-</td><td>71.0"));
}

TEST_F(ThesisSectionTest, TellsThePeakOfTheMeanCurveNotOfASingleRun) {
  Group& none = add("none");
  series(none, &Observation::probe_per, {0, 10, 5});
  none.series[0][2].probe_per = 55;  // one run of five: the mean there is 15
  EXPECT_THAT(text(add_thesis),
              HasSubstr("<td>no policy</td><td>25.0</td><td>-</td><td>15.0</td>"));
}

TEST_F(ThesisSectionTest, TellsTheChangeOfLatencyInPerCent) {
  set(add("none"), Metric::high_latency_median, 99.97);
  set(add("tocp_dsp"), Metric::high_latency_median, 79.97);
  EXPECT_THAT(text(add_thesis), HasSubstr(" ms without a policy: -20.0 %."));
}

TEST_F(ThesisSectionTest, DrawsTheMeanOfTheRunsAndTheirSpread) {
  four("a");
  (void)text(add_thesis);
  EXPECT_THAT(scripts_, HasSubstr("0 70 \n1 71 \n"));
  EXPECT_THAT(scripts_, HasSubstr("filledcurves"));
  EXPECT_THAT(scripts_, HasSubstr("set yrange [0:100]"));
}

TEST_F(ThesisSectionTest, IsNotThereWithoutASetOfThatKind) {
  kind("comparison");
  four("a");
  EXPECT_EQ(text(add_thesis), "");
  EXPECT_EQ(text(add_verdicts), "");
}

TEST_F(ThesisSectionTest, JudgesBothMetricsAgainstEachOtherPolicy) {
  four("a");
  for (Group& group : results_.groups) {
    const bool ours = group.policy == "tocp_dsp";
    set(group, Metric::telemetry_per_max, ours ? 20 : 30);
    set(group, Metric::high_latency_p99, ours ? 900 : 500);
  }
  const std::string sut = text(add_verdicts);
  for (const char* other : {"no policy", "threshold", "TOCP"}) {
    EXPECT_THAT(sut, HasSubstr("beats</span> " + std::string(other) + " on telemetry_per_max"));
    EXPECT_THAT(sut, HasSubstr("loses to</span> " + std::string(other) + " on high_latency_p99"));
  }
}

TEST_F(ThesisSectionTest, HasNoVerdictWhereTocpDspWasNotDriven) {
  add("none");
  add("threshold");
  EXPECT_THAT(text(add_verdicts), Not(HasSubstr("<li>")));
}

using OverviewTest = SectionTest;

TEST_F(OverviewTest, TellsHowManyRunsOfWhichBuildAndHowLong) {
  results_.runs = 800;
  results_.build = "0.1.0+<abc>";
  results_.experiment.timing.duration_s = 600;
  results_.experiment.timing.warm_up_s = 12;
  results_.experiment.timing.observation_s = 6;
  EXPECT_THAT(text(add_overview),
              AllOf(HasSubstr("800 runs in simulated time, each of at most 600 s"),
                    HasSubstr("the first 12.0 s do not count"),
                    HasSubstr("one observation is 6.00 s"), HasSubstr("0.1.0+&lt;abc&gt;")));
}

TEST_F(OverviewTest, ListsTwentyFailuresAndCountsAll) {
  for (int i = 0; i < 25; ++i) {
    results_.failures.push_back("run " + std::to_string(i) + ": threw");
  }
  const std::string sut = text(add_overview);
  EXPECT_THAT(sut, AllOf(HasSubstr("25 runs failed"), HasSubstr("run 19: threw")));
  EXPECT_THAT(sut, Not(HasSubstr("run 20: threw")));
}

TEST_F(OverviewTest, SaysNothingOfFailuresWhenThereAreNone) {
  EXPECT_THAT(text(add_overview), Not(HasSubstr("failed")));
}

TEST_F(OverviewTest, DefinesEveryMetricWithItsUnit) {
  const std::string sut = text(add_definitions);
  for (const MetricText& one : metric_texts()) {
    EXPECT_THAT(sut, HasSubstr("<td>" + std::string(one.name) + "</td><td>" + one.unit + "</td>"));
  }
}

TEST_F(OverviewTest, HoldsTheSettingsAsTheyAre) {
  results_.settings = "build: <x>\nruns: 3\n";
  EXPECT_THAT(text(add_settings), HasSubstr("build: &lt;x&gt;\nruns: 3\n"));
}

TEST_F(OverviewTest, NamesRoundsForPeopleAndForFiles) {
  const Group& group = add("none", "plain", "b");
  EXPECT_EQ(round_title(group), "Mission B, channel near, payload plain");
  EXPECT_EQ(round_id(group), "main_b_near_plain");
}

TEST_F(OverviewTest, FindsTheSetsOfAKindInTheOrderOfTheFile) {
  RunSet more;
  more.name = "more";
  more.kind = "comparison";
  results_.experiment.sets.push_back(more);
  const auto sut = sets_of(results_, "comparison");
  ASSERT_EQ(sut.size(), 2U);
  EXPECT_EQ(sut[0]->name, "main");
  EXPECT_EQ(sut[1]->name, "more");
  EXPECT_TRUE(sets_of(results_, "real").empty());
}

class SensitivityTest : public SectionTest {
 protected:
  SensitivityTest() {
    kind("sensitivity");
    PolicyChoice choice;
    choice.name = "alpha_2";
    choice.set = {"alpha=2", "network_monitor.window=<10>"};
    results_.experiment.policies = {choice};
    set(add("tocp_dsp"), Metric::silent_in_good, 4.97);
    set(add("alpha_2"), Metric::silent_in_good, 9.97);
  }
};

TEST_F(SensitivityTest, ShowsEachVariantWithWhatItSets) {
  const std::string sut = text(add_sensitivity);
  EXPECT_THAT(sut, HasSubstr("<h2>The main set</h2>"));
  EXPECT_THAT(sut, HasSubstr("Mission A, channel near, payload camera: 5 runs each"));
  EXPECT_THAT(sut, HasSubstr("<td>alpha=2 network_monitor.window=&lt;10&gt;</td>"));
  EXPECT_THAT(sut, HasSubstr("<td>5.00 [4.98, 5.02]</td>"));
}

TEST_F(SensitivityTest, ShowsNoSettingOfTheUnchangedPolicy) {
  EXPECT_THAT(text(add_sensitivity), HasSubstr("<td></td></tr>"));
}

TEST_F(SensitivityTest, DrawsThreeMetricsWithTheirIntervals) {
  (void)text(add_sensitivity);
  EXPECT_EQ(figures_,
            "Mission A: high_latency_p99 of the variants\n"
            "Mission A: silent_in_good of the variants\n"
            "Mission A: sent_in_poor of the variants\n");
  EXPECT_THAT(scripts_, HasSubstr("\"tocp_dsp\" 1, \"alpha_2\" 2"));
}

}  // namespace
}  // namespace tocsin::experiment
