// SPDX-License-Identifier: Apache-2.0
// Thresholds and delays against symmetries and known relations, and what is said of a recording.
#include "design.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "decision/policy_model.hpp"
#include "foundation/error.hpp"
#include "traces.hpp"

namespace tocsin::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Laws that mirror each other, 60 and 40 +-20, a sample each 10 minutes and a false alarm a week.
/// Few rows of its table can be had, so that it takes little time.
const Design& mirrored() {
  static const Design design = [] {
    DesignRequest request;
    request.false_alarm_s = 604800;
    request.period_s = 600;
    request.params.good_mean = 60;
    request.params.bad_mean = 40;
    request.params.good_sd = request.params.bad_sd = 20;
    return tools::design(request);
  }();
  return design;
}

/// The thesis's laws, a sample an hour: a week, 168 samples, is too little.
const Design& slow() {
  static const Design design = [] {
    DesignRequest request;
    request.false_alarm_s = 3600.0 * 3600;
    request.period_s = 3600;
    return tools::design(request);
  }();
  return design;
}

TEST(DesignOf, LawsThatMirrorEachOtherAlarmAndResumeAlike) {
  for (const TradeOff& one : mirrored().table) {
    EXPECT_NEAR(one.alpha, one.reverse_alpha, 1e-6);
    EXPECT_NEAR(one.delay_s, one.reverse_delay_s, 1e-6);
  }
}

/// Wald: at the alarm the sum is alpha and an overshoot, and each sample adds the mean ratio, which
/// for equal spreads is (difference / spread)^2 / 2.
TEST(DesignOf, TheDelayIsThresholdOverMeanStep) {
  ASSERT_GE(mirrored().table.size(), 3U);
  for (const TradeOff& one : mirrored().table) {
    const double samples = one.delay_s / 600;
    EXPECT_GT(samples, one.alpha / 0.5 - 3) << "W starts at 0 and may return there";
    EXPECT_LT(samples, one.alpha / 0.5 + 4);
  }
}

TEST(DesignOf, TheWantedLineIsTheRowOfTheTableWithThatTime) {
  const auto json = to_json(mirrored());
  for (const auto& row : json["table"]) {
    if (row["false_alarm_s"] != 604800) continue;
    EXPECT_EQ(row["alpha"], json["alpha"]);
    EXPECT_EQ(row["reverse_delay_s"], json["reverse_delay_s"]);
    return;
  }
  FAIL() << "the table has no row of a week";
}

TEST(DesignOf, AShiftTellsTheDelayOfAQualityBelowTheGoodMeanOnly) {
  const std::vector<ShiftDelay>& sut = mirrored().shifts;
  ASSERT_EQ(sut.size(), 3U);  // 40, 50, 55
  EXPECT_EQ(sut.back().mean, 55);
  for (std::size_t i = 1; i < sut.size(); ++i) {
    EXPECT_GT(sut[i].delay_s, sut[i - 1].delay_s) << sut[i].mean;
  }
  EXPECT_NEAR(sut.front().delay_s, mirrored().wanted.delay_s, 1e-9) << "40 is the bad law itself";
  Design other = mirrored();
  other.shifts.clear();
  EXPECT_THAT(to_text(other), Not(HasSubstr("quality settles at")));
}

TEST(DesignOf, ThresholdsAreOfSamplesAndDelaysOfSeconds) {
  const decision::PolicyParams& params = slow().request.params;
  const auto law = step_law_of(params, good_law_of(params));
  EXPECT_NEAR(slow().wanted.alpha, alpha_for_run_length(law, 3600), 1e-9);
  const auto bad = step_law_of(params, bad_law_of(params));
  EXPECT_NEAR(slow().wanted.delay_s, 3600 * mean_run_length(bad, slow().wanted.alpha), 1e-6);
}

TEST(DesignOf, TheTableLeavesOutWhatNoThresholdGives) {
  ASSERT_EQ(slow().table.size(), 1U);
  EXPECT_EQ(slow().table.front().false_alarm_s, 30 * 86400);
  EXPECT_THAT(to_text(slow()), Not(HasSubstr("\n       10 min")));
  EXPECT_THAT(to_text(slow()), HasSubstr("\n         30 d"));
  EXPECT_EQ(to_json(slow())["table"].size(), slow().table.size());
}

TEST(DurationText, ChangesItsUnitWhereTheNextIsTwoOfIt) {
  EXPECT_EQ(duration_text(0.5), "0.5 s");
  EXPECT_EQ(duration_text(119), "119 s");
  EXPECT_EQ(duration_text(120), "2 min");
  EXPECT_EQ(duration_text(7199), "120 min");
  EXPECT_EQ(duration_text(7200), "2 h");
  EXPECT_EQ(duration_text(172799), "48 h");
  EXPECT_EQ(duration_text(172800), "2 d");
}

std::string calibration_error(const QualityTrace& recording, double block_s) {
  try {
    (void)calibrate_on(recording, {{}, 600, block_s, 1, 5, 50});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CalibrateOn, RefusesBlocksThatAreNoSampleOrMoreThanTheRecording) {
  QualityTrace recording = normal_trace(81, 10, 100);
  for (std::size_t i = 0; i < 100; ++i) recording.time_s[i] = 2.0 * static_cast<double>(i);
  EXPECT_EQ(calibration_error(recording, 0.9),
            "--block: 0.9 s must be at least one sample, 2 s, and at most the recording, 200 s");
  EXPECT_THAT(calibration_error(recording, 201.1), HasSubstr("--block: 201.1 s must be"));
  EXPECT_THAT(calibration_error(recording, 1e300), HasSubstr("--block: 1e+300 s must be"));
  EXPECT_EQ(calibration_error(recording, 200), "no error");
}

TEST(CalibrateOn, ItsPeriodIsTheMedianStepOfTime) {
  QualityTrace recording = normal_trace(81, 10, 101);
  double time_s = 0;
  for (std::size_t i = 0; i < recording.time_s.size(); ++i) {
    recording.time_s[i] = time_s;
    time_s += i % 4 == 0 ? 30 : 0.5;  // a pause in the recording each 4 samples
  }
  EXPECT_EQ(calibrate_on(recording, {{}, 60, 0, 1, 5, 50}).period_s, 0.5);
}

TEST(CalibrateOn, NamesTheRecordingWhoseTimeStandsStill) {
  QualityTrace recording = normal_trace(81, 10, 100);
  recording.time_s.assign(100, 5);
  EXPECT_EQ(calibration_error(recording, 0), "x.csv: its time does not advance");
  EXPECT_EQ(calibration_error(normal_trace(81, 10, 1), 0), "x.csv: its time does not advance");
}

/// A result as it might be, so that what is said of it can be seen without simulating it.
RecordingCalibration result_with(const decision::LinkModel& model) {
  RecordingCalibration one{"g.csv", "alpha", 2, 3600, {}};
  one.found.threshold = 7.25;
  one.found.true_samples = {900, 3600};
  one.found.needed_samples = 43200;
  one.found.held_samples = 3600;
  one.found.wanted_samples = 1800;
  one.found.alarms_seen = 3;
  one.found.fit.model = model;
  return one;
}

TEST(CalibrationText, NamesTheModelThatWasSimulated) {
  EXPECT_THAT(to_text(result_with(decision::Ar1Link{{81, 9}, 0.5})),
              HasSubstr("a normal law 81 +-9 with correlation 0.5 of neighbours"));
  EXPECT_THAT(to_text(result_with(decision::TwoStateLink{{85, 5}, {60, 8}, 0.01, 0.25})),
              HasSubstr("two states, 85 +-5 for 100 samples and 60 +-8 for 4\n"));
  EXPECT_THAT(to_text(result_with(decision::BlockLink{{}, 70})),
              HasSubstr("its own blocks of 70 samples"));
}

TEST(CalibrationText, TellsTimesInSecondsOfTheRecording) {
  const RecordingCalibration sut = result_with(decision::Ar1Link{{81, 9}, 0.5});
  const std::string text = to_text(sut);
  EXPECT_THAT(text, HasSubstr("calibrated on g.csv (2 h at 2 s)"));
  EXPECT_THAT(text, HasSubstr("alpha 7.25: a false alarm per 60 min; with 95 % confidence the "
                              "link's own time is 30 min to 2 h\n"));
  EXPECT_THAT(text, HasSubstr("3 alarms at it, of 2 to be expected"));
  EXPECT_THAT(text, HasSubstr("extrapolated"));
  EXPECT_THAT(text, HasSubstr("about 24 h (this one: 2 h)"));
  const auto json = to_json(sut);
  EXPECT_EQ(json["alpha"], 7.25);
  EXPECT_EQ(json["recording_s"], 7200);
  EXPECT_EQ(json["true_low_s"], 1800);
  EXPECT_EQ(json["needed_s"], 86400);
}

TEST(CalibrationText, SaysThatNothingInTheRecordingLooksBad) {
  RecordingCalibration sut = result_with(decision::Ar1Link{{95, 1}, 0});
  sut.found.any_threshold = true;
  const std::string text = to_text(sut);
  EXPECT_THAT(text, HasSubstr("any alpha has fewer false alarms than wanted, one in 30 min"));
  EXPECT_THAT(text, Not(HasSubstr("7.25"))) << "no threshold is recommended";
}

}  // namespace
}  // namespace tocsin::tools
