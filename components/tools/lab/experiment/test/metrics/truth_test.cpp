// SPDX-License-Identifier: Apache-2.0
#include "metrics/truth.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::experiment {
namespace {

using report::Interval;

/// One state a second with these SNRs.
std::vector<report::LinkState> link(const std::vector<double>& snrs) {
  std::vector<report::LinkState> states;
  for (std::size_t i = 0; i < snrs.size(); ++i) {
    states.push_back({static_cast<double>(i), snrs[i], 0, 0, 0, 0});
  }
  return states;
}

TEST(TrulyPoor, EndsWithTheWindow) {
  const auto sut = truly_poor(link({5, 5, 5, 5, 5, 5}), {10, 2}, 1, 4);
  ASSERT_EQ(sut.size(), 1U);
  EXPECT_EQ(sut[0].begin_s, 1);
  EXPECT_EQ(sut[0].end_s, 4);
}

TEST(TrulyPoor, IgnoresWhatIsUnknown) {
  EXPECT_TRUE(truly_poor(link({std::nan(""), std::nan("")}), {10, 0.5}, 0, 9).empty());
}

TEST(AgainstTruth, TheClairvoyantIsPerfect) {
  const std::vector<Interval> poor{{10, 20}, {50, 60}};
  const AgainstTruth sut = compare(poor, poor, 0, 100);
  EXPECT_EQ(sut.intervals, 2);
  EXPECT_EQ(sut.missed, 0);
  EXPECT_EQ(sut.detect_s, 0);
  EXPECT_EQ(sut.resume_s, 0);
  EXPECT_EQ(sut.sent_in_poor, 0);
  EXPECT_EQ(sut.silent_in_good, 0);
}

TEST(AgainstTruth, PauseFromBeforeIsDetectedAtOnce) {
  EXPECT_EQ(compare({{10, 20}}, {{5, 15}}, 0, 100).detect_s, 0);
}

TEST(AgainstTruth, NobodyWhoNeverPausesDetects) {
  const AgainstTruth sut = compare({{10, 20}}, {}, 0, 100);
  EXPECT_EQ(sut.missed, 1);
  EXPECT_TRUE(std::isnan(sut.detect_s));
  EXPECT_EQ(sut.resume_s, 0);
  EXPECT_EQ(sut.sent_in_poor, 100);
}

TEST(AgainstTruth, DoesNotAskToResumeAfterTheEnd) {
  EXPECT_TRUE(std::isnan(compare({{90, 100}}, {{92, 100}}, 0, 100).resume_s));
}

TEST(Intervals, HaveInCommonWhatOverlaps) {
  EXPECT_EQ(common_s({{0, 10}, {20, 30}}, {{5, 25}}), 10);
  EXPECT_EQ(common_s({{0, 10}}, {{10, 20}}), 0);
  EXPECT_EQ(length_s({{0, 10}, {20, 30}}), 20);
}

}  // namespace
}  // namespace tocsin::experiment
