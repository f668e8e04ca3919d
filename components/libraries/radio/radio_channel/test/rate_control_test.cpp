// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/rate_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::radio {
namespace {

TEST(SignalTracker, KeepsTheLastAndAMeanOfWeightOneEighth) {
  SignalTracker sut;
  EXPECT_TRUE(std::isnan(sut.last_dbm()));
  EXPECT_TRUE(std::isnan(sut.mean_dbm()));
  sut.on_frame(-80);
  EXPECT_EQ(sut.mean_dbm(), -80);
  sut.on_frame(-72);
  EXPECT_EQ(sut.last_dbm(), -72);
  EXPECT_EQ(sut.mean_dbm(), -79);
}

TEST(RateControl, StartsAtTheLowestRateWhenNothingWasHeard) {
  EXPECT_EQ(RateControl().rate(std::nan(""), 0, 7), 0);
}

TEST(RateControl, TakesTheRateThatTheSnrMinusMarginCarries) {
  const RateControl sut;
  const double needed_db = snr_for_error_db(7, 1500, 0.1) + sut.margin_db();
  EXPECT_EQ(sut.rate(needed_db + 0.01, 0, 7), 7);
  EXPECT_EQ(sut.rate(needed_db - 0.01, 0, 7), 6);
}

TEST(RateControl, NeverUsesNineMbits) {
  const RateControl sut;
  for (double snr_db = 0; snr_db < 40; snr_db += 0.1) {
    for (int attempt = 0; attempt < 7; ++attempt) EXPECT_NE(sut.rate(snr_db, attempt, 7), 1);
  }
}

TEST(RateControl, FallsBackAfterTwoAttemptsAndEndsAtTheLowest) {
  const RateControl sut;
  const int expected[] = {7, 7, 6, 5, 4, 0, 0};
  for (int attempt = 0; attempt < 7; ++attempt) {
    EXPECT_EQ(sut.rate(40, attempt, 7), expected[attempt]) << attempt;
  }
  EXPECT_EQ(sut.rate(40, 0, 1), 7);  // with one attempt there is no fall-back
}

TEST(RateControl, BacksOffAfterALossAndCreepsUpAfterNineSuccesses) {
  RateControl sut;
  sut.on_result(7, 0, false);
  EXPECT_NEAR(sut.margin_db(), 4, 1e-9);
  for (int i = 0; i < 9; ++i) sut.on_result(7, 0, true);
  EXPECT_NEAR(sut.margin_db(), 3, 1e-9);
}

TEST(RateControl, LearnsFromFirstAttemptsOnly) {
  RateControl sut;
  sut.on_result(5, 1, false);
  sut.on_result(0, 6, true);
  EXPECT_EQ(sut.margin_db(), 3);
}

TEST(RateControl, DoesNotBlameTheRateWhenItIsTheLowest) {
  RateControl sut;
  for (int i = 0; i < 100; ++i) sut.on_result(0, 0, false);
  EXPECT_EQ(sut.margin_db(), 3);
}

TEST(RateControl, KeepsItsMarginBetweenZeroAndTwelve) {
  RateControl sut;
  for (int i = 0; i < 100; ++i) sut.on_result(3, 0, false);
  EXPECT_EQ(sut.margin_db(), 12);
  for (int i = 0; i < 1000; ++i) sut.on_result(3, 0, true);
  EXPECT_EQ(sut.margin_db(), 0);
}

}  // namespace
}  // namespace tocsin::radio
