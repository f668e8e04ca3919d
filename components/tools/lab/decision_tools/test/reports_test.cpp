// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decide.hpp"
#include "decision/design/link_model.hpp"
#include "design.hpp"
#include "foundation/error.hpp"
#include "traces.hpp"

namespace tocsin::tools {
namespace {

using ::testing::HasSubstr;

TEST(DecideAgain, PausesInTheDip) {
  const DecidedTrace decided = decide_again(dip(), "", with_policy("tocp_reverse"));
  const DecisionSummary sut = summarize(decided);
  EXPECT_EQ(sut.samples, 150U);
  EXPECT_EQ(sut.pauses, 2U);  // 30 samples are the limit
  EXPECT_EQ(sut.forced, 1U);
  EXPECT_EQ(sut.longest_pause, 30);
  EXPECT_LT(sut.mean_qni_passive, 40);
  EXPECT_TRUE(sut.has_truth);
  EXPECT_GE(sut.cost, sut.oracle_cost);
}

TEST(DecideAgain, EndsAPauseAtItsDeadlineBetweenTwoRows) {
  QualityTrace trace = normal_trace(80, 1, 3);
  trace.time_s = {0, 1, 1000};
  trace.qni = {80, 20, 20};
  const DecidedTrace sut = decide_again(trace, "", with_policy("tocp_dsp"));
  ASSERT_EQ(sut.steps.size(), 4U);
  EXPECT_EQ(sut.steps[1].evidence.state, decision::State::passive);
  EXPECT_EQ(sut.steps[2].row, std::nullopt);
  EXPECT_EQ(sut.steps[2].evidence.reason, decision::Reason::forced_resume_time);
  EXPECT_EQ(sut.steps[2].time_s, 1 + 180);
  EXPECT_EQ(sut.steps[3].evidence.reason, decision::Reason::cusum_alarm);
  EXPECT_EQ(summarize(sut).samples, 3U);
  EXPECT_EQ(summarize(sut).forced, 1U);
}

DesignRequest request(double false_alarm_s) {
  DesignRequest r;
  r.false_alarm_s = false_alarm_s;
  r.period_s = 1;
  r.replicates = 10;
  r.paths = 100;
  return r;
}

QualityTrace ar1_trace(double correlation, int n) {
  QualityTrace trace;
  trace.path = "walk.csv";
  const auto source = decision::source_of(decision::Ar1Link{decision::thesis_good, correlation}, 3);
  for (int i = 0; i < n; ++i) {
    trace.time_s.push_back(i);
    trace.qni.push_back(source->next());
  }
  return trace;
}

/// On a short correlated recording. Takes a second, and half a minute with a sanitizer.
const Design& for_an_hour() {
  static const Design once = [] {
    DesignRequest wanted = request(3600);
    wanted.recording = ar1_trace(0.9, 7200);
    return design(wanted);
  }();
  return once;
}

TEST(Design, GivesTheKnownThresholdForAnHour) {
  const Design& sut = for_an_hour();
  EXPECT_NEAR(sut.wanted.alpha, 5.530, 1e-3);
  EXPECT_NEAR(sut.wanted.delay_s, 1.1075, 1e-3);
  EXPECT_NEAR(sut.wanted.reverse_alpha, 3.857, 1e-3);
  EXPECT_THAT(to_text(sut), HasSubstr("alpha 5.52"));
  EXPECT_EQ(to_json(sut)["table"].size(), 6U);
}

TEST(Design, TradesDelayForFewerFalseAlarms) {
  const Design& sut = for_an_hour();
  for (std::size_t i = 1; i < sut.table.size(); ++i) {
    EXPECT_GT(sut.table[i].alpha, sut.table[i - 1].alpha);
    EXPECT_GT(sut.table[i].delay_s, sut.table[i - 1].delay_s);
  }
  EXPECT_GT(sut.shifts.back().delay_s, sut.shifts.front().delay_s);
}

/// Without the table of thresholds for independent samples, which takes a second.
RecordingCalibration calibrated(const DesignRequest& wanted) {
  return calibrate_on(*wanted.recording, {wanted.params, wanted.false_alarm_s, wanted.block_s,
                                          wanted.seed, wanted.replicates, wanted.paths});
}

TEST(Design, CalibratesOnARecording) {
  DesignRequest wanted = request(1000);
  wanted.recording = ar1_trace(0, 20000);
  const RecordingCalibration sut = calibrated(wanted);
  EXPECT_EQ(sut.parameter, "alpha");
  EXPECT_NEAR(sut.found.threshold, 3.563, 0.5);
  EXPECT_LT(sut.found.true_samples.low, 1000);
  EXPECT_GT(sut.found.true_samples.high, 1000);
  const auto json = to_json(sut);
  EXPECT_EQ(json["model"], "ar1");
  EXPECT_FALSE(json["extrapolated"].get<bool>());
  EXPECT_THAT(to_text(sut), ::testing::Not(HasSubstr("extrapolated")));
}

TEST(Design, SaysHowFarAShortCorrelatedRecordingBearsItOut) {
  const Design& sut = for_an_hour();
  ASSERT_TRUE(sut.calibration);
  const decision::Calibration& found = sut.calibration->found;
  EXPECT_GT(found.true_samples.high / found.true_samples.low, 2);
  EXPECT_GT(found.needed_samples, 5 * 7200);
  EXPECT_THAT(to_text(sut), HasSubstr("with correlation 0.89"));
  EXPECT_THAT(to_text(sut), HasSubstr("extrapolated: the recording is shorter than ten"));
  EXPECT_THAT(to_text(sut), HasSubstr("+-20 % needs a recording of about"));
  EXPECT_THAT(to_text(sut), HasSubstr("alarms at it, of 2 to be expected"));
}

TEST(Design, CalibratesTheDetectorThatIsChosen) {
  DesignRequest wanted = request(300);
  wanted.params.detector = decision::DetectorKind::focus;
  wanted.recording = ar1_trace(0.5, 3000);
  const RecordingCalibration sut = calibrated(wanted);
  EXPECT_EQ(sut.parameter, "detector_threshold");
  EXPECT_GT(sut.found.threshold, 6);  // of independent samples: 5
  EXPECT_THAT(to_text(sut), HasSubstr("detector_threshold "));
}

TEST(Design, TakesAStepInTimeForAGapInTheRecording) {
  DesignRequest wanted = request(1000);
  wanted.recording = ar1_trace(0.9, 3000);
  for (std::size_t i = 1500; i < 3000; ++i) wanted.recording->time_s[i] += 500;
  EXPECT_EQ(calibrated(wanted).found.held_samples, 3000);
}

TEST(Design, NamesTheRecordingThatIsTooShort) {
  DesignRequest wanted = request(1000);
  wanted.recording = ar1_trace(0.5, 40);
  try {
    (void)design(wanted);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("walk.csv: recording: "));
    EXPECT_THAT(error.what(), HasSubstr("at least 50 are needed"));
  }
}

}  // namespace
}  // namespace tocsin::tools
