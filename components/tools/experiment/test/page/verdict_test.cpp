// SPDX-License-Identifier: Apache-2.0
#include "page/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::experiment {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Runs of a policy whose highest PER of telemetry and mean QNI are these.
Group group(const std::string& policy, const std::vector<double>& per, double qni = 70) {
  Group result;
  result.mission = "a";
  result.policy = policy;
  for (const double one : per) {
    std::vector<double> values(metric_count, std::nan(""));
    values[index_of(Metric::telemetry_per_max)] = one;
    values[index_of(Metric::qni_mean)] = qni;
    result.values.push_back(values);
  }
  return result;
}

TEST(Judge, NeedsTheWholeIntervalOnOneSide) {
  EXPECT_EQ(judge({-2, -3, -1, 9}, true), Verdict::better);
  EXPECT_EQ(judge({-2, -3, -1, 9}, false), Verdict::worse);
  EXPECT_EQ(judge({2, 1, 3, 9}, true), Verdict::worse);
  EXPECT_EQ(judge({2, 1, 3, 9}, false), Verdict::better);
  EXPECT_EQ(judge({-2, -5, 1, 9}, true), Verdict::undecided);
  EXPECT_EQ(judge({-2, std::nan(""), std::nan(""), 1}, true), Verdict::undecided);
}

TEST(VerdictLine, SaysThatOneBeatsTheOther) {
  const Group ours = group("tocp_dsp", {10, 11, 12});
  const Group other = group("none", {30, 32, 31});
  const std::string sut = verdict_line(ours, other, {&ours, &other}, Metric::telemetry_per_max);
  EXPECT_THAT(sut, HasSubstr("Mission A: TOCP-DSP <span class=\"yes\">beats</span> no policy"));
  EXPECT_THAT(sut, HasSubstr("11.0 against 31.0 %"));
  EXPECT_THAT(sut, HasSubstr("over 3 pairs"));
}

TEST(VerdictLine, SaysWhoIsBestWhereItDoesNot) {
  const Group ours = group("tocp_dsp", {10, 30, 12});
  const Group other = group("none", {11, 28, 14});
  const Group best = group("tocp_reverse", {1, 2, 3});
  const std::string sut =
      verdict_line(ours, other, {&ours, &other, &best}, Metric::telemetry_per_max);
  EXPECT_THAT(sut, HasSubstr("does not beat"));
  EXPECT_THAT(sut, HasSubstr("the lowest mean has tocp_reverse with 2.00"));
}

TEST(VerdictLine, SaysPlainlyThatItLoses) {
  const Group ours = group("tocp_dsp", {30, 32, 31});
  const Group other = group("threshold", {10, 11, 12});
  EXPECT_THAT(verdict_line(ours, other, {&ours, &other}, Metric::telemetry_per_max),
              HasSubstr("loses to"));
}

TEST(BestOf, KnowsWhichWayIsBetter) {
  const Group low = group("low", {10, 10}, 60);
  const Group high = group("high", {20, 20}, 80);
  EXPECT_EQ(best_of({&low, &high}, Metric::telemetry_per_max), &low);
  EXPECT_EQ(best_of({&low, &high}, Metric::qni_mean), &high);
  EXPECT_EQ(best_of({&low, &high}, Metric::camera_lost), nullptr);
}

TEST(Names, AreThoseOfTheThesis) {
  EXPECT_EQ(display_name("tocp_dsp"), "TOCP-DSP");
  EXPECT_EQ(display_name("belief"), "belief");
  EXPECT_EQ(mission_name("b"), "Mission B");
  EXPECT_EQ(mission_name("quick"), "Mission quick");
}

}  // namespace
}  // namespace tocsin::experiment
