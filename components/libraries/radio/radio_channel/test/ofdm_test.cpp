// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/ofdm.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::radio {
namespace {

using std::chrono::microseconds;

struct Golden {
  int rate;
  double snr_db;
  double error;
};

// NIST model of a frame of 1544 bytes, computed apart from this code in double precision.
constexpr Golden golden[] = {{0, 3.0, 0.951088187},  {1, 6.5, 0.297174326},  {2, 6.5, 0.432068028},
                             {3, 9.5, 0.305647811},  {4, 13.0, 0.419320374}, {5, 16.0, 0.519865720},
                             {6, 21.0, 0.283482537}, {7, 22.0, 0.497142268}};

TEST(FrameError, EqualsTheNistModelAtEveryRate) {
  for (const Golden& g : golden) {
    EXPECT_NEAR(frame_error_probability(g.rate, g.snr_db, 1544), g.error, 1e-8) << g.rate;
  }
}

// Attempt loss at 6 Mbit/s that a prototype agreeing with ns-3's NistErrorRateModel to 6e-14 gave.
TEST(FrameError, EqualsThePrototypeThatAgreesWithNs3) {
  EXPECT_NEAR(frame_error_probability(0, 2.7, 178), 0.625, 0.001);
  EXPECT_NEAR(frame_error_probability(0, 2.9, 178), 0.388, 0.001);
  EXPECT_NEAR(frame_error_probability(0, 3.1, 178), 0.219, 0.001);
}

TEST(FrameError, ReachesTenPercentAtTheKnownThresholds) {
  EXPECT_NEAR(snr_for_error_db(0, 136, 0.1), 3.3, 0.05);
  EXPECT_NEAR(snr_for_error_db(2, 136, 0.1), 6.3, 0.05);
  EXPECT_NEAR(snr_for_error_db(4, 136, 0.1), 12.8, 0.1);
  EXPECT_NEAR(snr_for_error_db(7, 136, 0.1), 21.9, 0.1);
}

TEST(FrameError, NeverGrowsWithSnrAndNeverShrinksWithSize) {
  for (int rate = 0; rate < rate_count; ++rate) {
    for (double snr_db = -9.5; snr_db < 39; snr_db += 0.01) {
      const double here = frame_errors().error(rate, snr_db, 1000);
      ASSERT_LE(frame_errors().error(rate, snr_db + 0.01, 1000), here + 1e-12);
      ASSERT_GE(frame_errors().error(rate, snr_db, 1001), here);
    }
  }
}

TEST(FrameErrorTable, IsWithinHalfAPercentOfTheModel) {
  for (int rate = 0; rate < rate_count; ++rate) {
    for (double snr_db = -9.97; snr_db < 39; snr_db += 0.013) {
      ASSERT_NEAR(frame_errors().error(rate, snr_db, 500),
                  frame_error_probability(rate, snr_db, 500), 0.005);
    }
  }
}

TEST(FrameErrorTable, HoldsItsEnds) {
  EXPECT_EQ(frame_errors().error(0, -10.0, 1), 1);
  EXPECT_EQ(frame_errors().error(0, -HUGE_VAL, 1), 1);
  EXPECT_EQ(frame_errors().error(0, std::nan(""), 1), 1);
  EXPECT_EQ(frame_errors().error(7, 40.0, 5000), 0);
}

TEST(FrameErrorTable, LosesTheDrawsBelowTheError) {
  for (double snr_db = -9.9; snr_db < 41; snr_db += 0.37) {
    for (int rate = 0; rate < rate_count; ++rate) {
      const double error = frame_errors().error(rate, snr_db, 500);
      for (double draw = 0; draw < 1; draw += 0.01) {
        ASSERT_EQ(frame_errors().lost(rate, snr_db, 500, draw), draw < error) << snr_db;
      }
      ASSERT_EQ(frame_errors().lost(rate, snr_db, 500, error * 0.999), error > 0) << snr_db;
      ASSERT_FALSE(frame_errors().lost(rate, snr_db, 500, error * 1.001)) << snr_db;
    }
  }
}

TEST(FrameErrorTable, LosesAllOrNothingBeyondItsEnds) {
  EXPECT_TRUE(frame_errors().lost(0, -10.0, 1, 0.999));
  EXPECT_TRUE(frame_errors().lost(0, std::nan(""), 1, 0.999));
  EXPECT_FALSE(frame_errors().lost(7, 40.0, 5000, 0));
}

TEST(FrameDuration, CountsPreambleSymbolsAndSignalExtension) {
  EXPECT_EQ(frame_duration(4, ack_bytes), microseconds{34});  // 134 bits in 2 symbols
  EXPECT_EQ(frame_duration(0, ack_bytes), microseconds{50});  // 6 symbols
  EXPECT_EQ(frame_duration(7, 1544), microseconds{258});      // 12374 bits in 58 symbols
}

TEST(FrameDuration, GrowsByASymbolAtTheBoundary) {
  EXPECT_EQ(frame_duration(4, 9), microseconds{30});   // 94 of 96 bits
  EXPECT_EQ(frame_duration(4, 10), microseconds{34});  // 102
}

TEST(AckRate, IsTheHighestMandatoryRateNotAboveTheData) {
  EXPECT_EQ(ack_rate(0), 0);
  EXPECT_EQ(ack_rate(1), 0);
  EXPECT_EQ(ack_rate(2), 2);
  EXPECT_EQ(ack_rate(3), 2);
  EXPECT_EQ(ack_rate(4), 4);
  EXPECT_EQ(ack_rate(7), 4);
}

}  // namespace
}  // namespace tocsin::radio
