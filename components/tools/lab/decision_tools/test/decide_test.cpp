// SPDX-License-Identifier: Apache-2.0
// What holds for every policy on every trace, and what a pause that ends between two samples costs.
#include "decide.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/numbers.hpp"
#include "traces.hpp"

namespace tocsin::tools {
namespace {

using decision::Reason;
using decision::State;

constexpr unsigned seeds = 12;

/// Belief without its programme, which takes some tenths of a second.
PolicySettings quick(const std::string& policy, std::vector<std::string> set = {}) {
  set.emplace_back("belief_myopic=true");
  return load_settings({{}, "", set, policy});
}

class DecideWith : public ::testing::TestWithParam<const char*> {
 protected:
  template <class Check>
  void for_each_trace(Check check) const {
    for (unsigned seed = 1; seed <= seeds; ++seed) {
      SCOPED_TRACE(std::string(GetParam()) + ", seed " + std::to_string(seed));
      const QualityTrace trace = random_trace(seed, 300);
      check(decide_again(trace, GetParam(), quick(GetParam())));
    }
  }
};

/// Without the clairvoyant, which knows what comes and has no clock.
class DecideCausally : public DecideWith {};

TEST_P(DecideWith, EachRowIsDecidedOnceInItsOrderAndOnlyEndsOfPausesBetween) {
  for_each_trace([](const DecidedTrace& decided) {
    std::size_t next = 0;
    double time_s = 0;
    for (const Step& step : decided.steps) {
      if (step.row) {
        EXPECT_EQ(*step.row, next++);
      } else {
        EXPECT_EQ(step.evidence.reason, Reason::forced_resume_time);
      }
      EXPECT_GE(step.time_s, time_s);
      time_s = step.time_s;
    }
    EXPECT_EQ(next, decided.trace.qni.size());
  });
}

TEST_P(DecideCausally, NoPauseIsLongerThanItMayBe) {
  for_each_trace([](const DecidedTrace& decided) {
    double began_s = -1;
    for (const Step& step : decided.steps) {
      const bool passive = step.evidence.state == State::passive;
      if (passive && began_s < 0) began_s = step.time_s;
      if (began_s >= 0) {
        EXPECT_LE(step.time_s - began_s, 180 + 1e-6);
      }
      if (!passive) began_s = -1;
      EXPECT_LE(step.evidence.age, 30);
    }
  });
}

TEST_P(DecideWith, TheSummaryIsWhatTheStepsAmountTo) {
  for_each_trace([](const DecidedTrace& decided) {
    const DecisionSummary sut = summarize(decided);
    std::size_t changes = 0;
    std::size_t silent = 0;
    double silent_sum = 0;
    double silent_count = 0;
    for (const Step& step : decided.steps) {
      const bool passive = step.evidence.state == State::passive;
      changes += step.evidence.changed;
      silent += step.row && passive;
      if (!step.row || !passive || std::isnan(decided.trace.qni[*step.row])) continue;
      silent_sum += decided.trace.qni[*step.row];
      ++silent_count;
    }
    EXPECT_EQ(sut.samples, decided.trace.qni.size());
    EXPECT_EQ(sut.missing, sut.samples - decided.trace.measured().size());
    EXPECT_EQ(sut.passive, silent);
    EXPECT_EQ(sut.pauses, (changes + 1) / 2) << "it begins active, each pause is two changes";
    EXPECT_LE(sut.forced, sut.pauses);
    if (silent_count > 0) {
      EXPECT_NEAR(sut.mean_qni_passive, silent_sum / silent_count, 1e-9);
    }
    if (silent_count == 0) {
      EXPECT_TRUE(std::isnan(sut.mean_qni_passive));
    }
  });
}

TEST_P(DecideWith, CostsNoLessThanTheClairvoyant) {
  for_each_trace([](const DecidedTrace& decided) {
    const DecisionSummary sut = summarize(decided);
    ASSERT_TRUE(sut.has_truth);
    EXPECT_GE(sut.cost, sut.oracle_cost - 1e-9);
    if (decided.policy == "oracle") {
      EXPECT_NEAR(sut.cost, sut.oracle_cost, 1e-9);
    }
  });
}

TEST_P(DecideCausally, NothingIsDecidedByWhatComesLater) {
  for_each_trace([](const DecidedTrace& whole) {
    QualityTrace begin = whole.trace;
    begin.qni.resize(120);
    begin.time_s.resize(120);
    begin.bad.resize(120);
    const DecidedTrace sut = decide_again(begin, GetParam(), quick(GetParam()));
    for (std::size_t i = 0; i < sut.steps.size(); ++i) {
      ASSERT_EQ(sut.steps[i].row, whole.steps[i].row);
      ASSERT_EQ(sut.steps[i].evidence.state, whole.steps[i].evidence.state) << "step " << i;
      ASSERT_EQ(sut.steps[i].evidence.reason, whole.steps[i].evidence.reason) << "step " << i;
    }
  });
}

std::string name_of(const ::testing::TestParamInfo<const char*>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(Policy, DecideCausally, ::testing::ValuesIn(decision::policy_names),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Policy, DecideWith, ::testing::ValuesIn(decision::policy_names), name_of);
INSTANTIATE_TEST_SUITE_P(Clairvoyant, DecideWith, ::testing::Values("oracle"), name_of);

/// One good sample, then a network that stays bad, a sample every `period_s`.
QualityTrace turned_bad(int samples, double period_s) {
  QualityTrace trace;
  for (int i = 0; i < samples; ++i) {
    trace.time_s.push_back(i * period_s);
    trace.qni.push_back(i == 0 ? 90 : 20);
    trace.bad.push_back(i > 0);
  }
  return trace;
}

TEST(DecisionCost, ASlotInWhichAPauseEndedAtItsDeadlineIsSpokenIn) {
  // Sample 1 pauses until 180 s later, between samples 2 and 3; sample 3 pauses again.
  const auto settings = quick("threshold");
  const DecisionSummary sut = summarize(decide_again(turned_bad(5, 100), "", settings));
  EXPECT_EQ(sut.pauses, 2U);
  // slot 1 spoken 1, slot 2 silent 0.1, slot 3 spoken 1, slot 4 silent 0.1, three changes of 0.5
  EXPECT_NEAR(sut.cost, 1 + 0.1 + 1 + 0.1 + 3 * 0.5, 1e-9);
}

TEST(DecisionCost, IsOfTheSamplesAndNotOfARecordedEndOfAPause) {
  QualityTrace trace = turned_bad(5, 1);
  trace.qni[3] = nan;
  trace.recorded.resize(5);
  trace.recorded[3].at_deadline = true;
  // With a longer limit the recorded end of the pause is none.
  const DecidedTrace decided = decide_again(trace, "", quick("threshold", {"th_max_s=1000"}));
  EXPECT_EQ(decided.steps.size(), 4U);
  EXPECT_NEAR(summarize(decided).cost, 1 + 2 * 0.1 + 0.5, 1e-9);
  const DecisionSummary oracle = summarize(decide_again(trace, "oracle", {}));
  EXPECT_NEAR(oracle.cost, oracle.oracle_cost, 1e-9) << "its slots are the samples, too";
}

TEST(DecisionCost, TheClairvoyantKnowsTheWholeTraceAlsoWhenTheControllerWasRestarted) {
  QualityTrace trace = random_trace(3, 100);
  trace.recorded.resize(100);
  trace.recorded[40].restarted = true;
  const DecisionSummary sut = summarize(decide_again(trace, "oracle", {}));
  EXPECT_NEAR(sut.cost, sut.oracle_cost, 1e-9);
}

TEST(DecisionCost, OfOneSampleIsNone) {
  const DecisionSummary sut = summarize(decide_again(turned_bad(1, 1), "", quick("threshold")));
  EXPECT_FALSE(sut.has_truth);
}

}  // namespace
}  // namespace tocsin::tools
