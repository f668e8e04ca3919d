// SPDX-License-Identifier: Apache-2.0
#include "engine/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace tocsin::experiment {
namespace {

TEST(ClockText, HasHoursOnlyWhenNeeded) {
  EXPECT_EQ(clock_text(0), "0:00");
  EXPECT_EQ(clock_text(65), "1:05");
  EXPECT_EQ(clock_text(3599), "59:59");
  EXPECT_EQ(clock_text(3600), "1:00:00");
}

TEST(ClockText, AdmitsThatItDoesNotKnow) {
  EXPECT_EQ(clock_text(std::nan("")), "-:--");
  EXPECT_EQ(clock_text(-1), "-:--");
}

TEST(ProgressText, TellsShareAndTimeLeft) {
  EXPECT_EQ(progress_text(200, 800, 10, 20),
            "200 of 800 runs [#####...............] 25 %, 0:10, 0:30 left");
}

TEST(ProgressText, KnowsNoTimeLeftWithoutARate) {
  EXPECT_EQ(progress_text(0, 800, 0, 0),
            "0 of 800 runs [....................] 0 %, 0:00, -:-- left");
}

TEST(Progress, TellsEachTenthOnceWithoutATerminal) {
  ::testing::internal::CaptureStdout();
  Progress sut(40, 0, false);
  for (int i = 0; i < 40; ++i) sut.advance();
  sut.finish();
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
}

TEST(Progress, SaysWhatWasThereAlready) {
  ::testing::internal::CaptureStdout();
  Progress sut(10, 4, false);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "4 of 10 runs are there already\n");
}

TEST(Progress, RewritesOneLineOnATerminal) {
  ::testing::internal::CaptureStdout();
  Progress sut(2, 0, true);
  sut.advance();
  sut.advance();
  sut.finish();
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 2);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST(ClockText, RoundsToWholeSeconds) {
  EXPECT_EQ(clock_text(59.4), "0:59");
  EXPECT_EQ(clock_text(59.6), "1:00");
  EXPECT_EQ(clock_text(3599.6), "1:00:00");
  EXPECT_EQ(clock_text(HUGE_VAL), "-:--");
}

TEST(ProgressText, IsFullAtTheEndAndOfNothing) {
  EXPECT_EQ(progress_text(800, 800, 40, 20),
            "800 of 800 runs [####################] 100 %, 0:40, 0:00 left");
  EXPECT_EQ(progress_text(0, 0, 0, 0), "0 of 0 runs [####################] 100 %, 0:00, -:-- left");
}

TEST(ProgressText, FillsTheBarByWholeTwentieths) {
  EXPECT_NE(progress_text(39, 800, 1, 1).find("[....................]"), std::string::npos);
  EXPECT_NE(progress_text(40, 800, 1, 1).find("[#...................]"), std::string::npos);
}

TEST(Progress, TellsNoTenthAgainThatWasThereAlready) {
  ::testing::internal::CaptureStdout();
  Progress sut(10, 9, false);
  sut.advance();
  sut.finish();
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
}

}  // namespace
}  // namespace tocsin::experiment
