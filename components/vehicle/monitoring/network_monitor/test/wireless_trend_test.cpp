// SPDX-License-Identifier: Apache-2.0
#include "network_monitor/wireless_trend.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::network {
namespace {

using ::testing::Optional;

WirelessReading sent(std::uint64_t packets, std::uint64_t retries) {
  WirelessReading reading;
  reading.tx_packets = packets;
  reading.tx_retries = retries;
  return reading;
}

WirelessReading channel(double time_ms, double busy_ms) {
  WirelessReading reading;
  reading.channel_time_ms = time_ms;
  reading.channel_busy_ms = busy_ms;
  return reading;
}

TEST(WirelessTrend, SaysNothingFromOneReading) {
  WirelessTrend sut;
  EXPECT_EQ(sut.update(sent(100, 50)).retry_percent, std::nullopt);
}

TEST(WirelessTrend, GivesTheShareOfRetriesSinceTheLastReading) {
  WirelessTrend sut;
  (void)sut.update(sent(100, 50));
  EXPECT_THAT(sut.update(sent(160, 90)).retry_percent, Optional(40.0));
  EXPECT_THAT(sut.update(sent(170, 90)).retry_percent, Optional(0.0));
}

TEST(WirelessTrend, ReachesAHundredWhenOnlyRetriesWereCounted) {
  WirelessTrend sut;
  (void)sut.update(sent(100, 50));
  EXPECT_THAT(sut.update(sent(100, 57)).retry_percent, Optional(100.0));
}

TEST(WirelessTrend, SaysNothingWhenNothingWasSent) {
  WirelessTrend sut;
  (void)sut.update(sent(100, 50));
  EXPECT_EQ(sut.update(sent(100, 50)).retry_percent, std::nullopt);
}

TEST(WirelessTrend, SaysNothingAcrossAReset) {
  WirelessTrend sut;
  (void)sut.update(sent(100, 50));
  EXPECT_EQ(sut.update(sent(3, 1)).retry_percent, std::nullopt);
  EXPECT_THAT(sut.update(sent(6, 2)).retry_percent, Optional(25.0));
}

TEST(WirelessTrend, SaysNothingAboutWhatIsNotCounted) {
  WirelessTrend sut;
  (void)sut.update(sent(100, 50));
  EXPECT_EQ(sut.update(WirelessReading{}).retry_percent, std::nullopt);
  EXPECT_EQ(sut.update(sent(200, 90)).retry_percent, std::nullopt);
}

TEST(WirelessTrend, GivesTheUtilisationOfTheChannel) {
  WirelessTrend sut;
  EXPECT_EQ(sut.update(channel(1000, 100)).busy_percent, std::nullopt);
  EXPECT_THAT(sut.update(channel(2000, 350)).busy_percent, Optional(25.0));
  EXPECT_EQ(sut.update(channel(2000, 350)).busy_percent, std::nullopt);
}

TEST(WirelessTrend, StaysWithinAHundredPercent) {
  WirelessTrend sut;
  (void)sut.update(channel(1000, 100));
  EXPECT_THAT(sut.update(channel(1010, 150)).busy_percent, Optional(100.0));
}

}  // namespace
}  // namespace tocsin::network
