// SPDX-License-Identifier: Apache-2.0
#include "meters.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::topic_tool {
namespace {

const Time t0{std::chrono::hours(1)};

TEST(Window, KeepsTheNewestValues) {
  Window sut(3);
  for (const double value : {100.0, 1.0, 2.0, 6.0}) sut.add(value);
  EXPECT_EQ(sut.count(), 3U);
  EXPECT_DOUBLE_EQ(sut.least(), 1);
  EXPECT_DOUBLE_EQ(sut.most(), 6);
  EXPECT_DOUBLE_EQ(sut.mean(), 3);
  EXPECT_DOUBLE_EQ(sut.deviation(), std::sqrt(14.0 / 3));
}

TEST(RateMeter, PrintsWhatRos2Prints) {
  RateMeter sut(10);
  for (const double at_s : {0.0, 0.1, 0.3}) sut.add(t0 + seconds(at_s));
  EXPECT_EQ(sut.text(),
            "average rate: 6.667\n\tmin: 0.100s max: 0.200s std dev: 0.05000s window: 3\n");
}

TEST(BandwidthMeter, CountsFromTheOldestOfTheWindowUntilNow) {
  BandwidthMeter sut(2);
  EXPECT_EQ(sut.text(t0), "");
  sut.add(9999, t0);
  sut.add(100, t0 + seconds(1));
  sut.add(300, t0 + seconds(2));
  EXPECT_EQ(sut.text(t0 + seconds(3)),
            "200 B/s from 2 messages\n\tMessage size mean: 200 B min: 100 B max: 300 B\n");
}

TEST(DelayMeter, PrintsWhatRos2Prints) {
  DelayMeter sut(10);
  EXPECT_EQ(sut.text(), "");
  sut.add(0.001);
  sut.add(0.003);
  EXPECT_EQ(sut.text(),
            "average delay: 0.002\n\tmin: 0.001s max: 0.003s std dev: 0.00100s window: 2\n");
}

}  // namespace
}  // namespace tocsin::topic_tool
