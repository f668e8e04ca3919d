// SPDX-License-Identifier: Apache-2.0
#include "link_map/signal_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"

namespace tocsin::link_map {
namespace {

TEST(SignalFile, ReadsWhatItWrites) {
  const std::vector<Reading> readings{{{1.25, -3}, -51.5}, {{0, 12.75}, -90, 0.25}};
  const auto again = signals_in(signal_text(readings), "a.csv", "");
  ASSERT_EQ(again.size(), 2U);
  EXPECT_DOUBLE_EQ(again[0].at.x_m, 1.25);
  EXPECT_DOUBLE_EQ(again[0].at.y_m, -3);
  EXPECT_DOUBLE_EQ(again[0].signal_dbm, -51.5);
  EXPECT_TRUE(std::isnan(again[0].lost_share));
  EXPECT_DOUBLE_EQ(again[1].at.y_m, 12.75);
  EXPECT_DOUBLE_EQ(again[1].lost_share, 0.25);
}

TEST(SignalFile, NeedNotTellLoss) {
  const auto of_three = signals_in("x_m,y_m,signal_dbm\n1,2,-60\n", "a.csv", "");
  ASSERT_EQ(of_three.size(), 1U);
  EXPECT_TRUE(std::isnan(of_three[0].lost_share));
  EXPECT_THROW((void)signals_in("x_m,y_m,signal_dbm,loss_percent\n1,2,-60,much\n", "a.csv", ""),
               ConfigError);
}

TEST(SignalFile, OfNothingIsAHeaderAlone) {
  EXPECT_TRUE(signals_in(signal_text({}), "a.csv", "").empty());
  EXPECT_THROW((void)signals_in("", "a.csv", ""), ConfigError);
}

}  // namespace
}  // namespace tocsin::link_map
