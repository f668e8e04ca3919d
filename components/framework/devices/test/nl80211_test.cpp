// SPDX-License-Identifier: Apache-2.0
#include "nl80211.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/nl80211.h>
#include <netlink/attr.h>
#include <netlink/genl/genl.h>
#include <netlink/msg.h>

#include <cstring>
#include <functional>
#include <memory>
#include <random>

namespace tocsin::network {
namespace {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Optional;

struct Free {
  void operator()(nl_msg* message) const { nlmsg_free(message); }
};
using Message = std::unique_ptr<nl_msg, Free>;

/// A message as the kernel would send it: `fill` adds what is nested in `attribute`.
Message build(std::uint8_t command, int attribute, const std::function<void(nl_msg*)>& fill) {
  Message message(nlmsg_alloc());
  genlmsg_put(message.get(), 0, 0, 25, 0, 0, command, 0);
  nla_put_u32(message.get(), NL80211_ATTR_IFINDEX, 3);
  nlattr* nest = nla_nest_start(message.get(), attribute);
  fill(message.get());
  nla_nest_end(message.get(), nest);
  return message;
}

Message station(const std::function<void(nl_msg*)>& fill) {
  return build(NL80211_CMD_NEW_STATION, NL80211_ATTR_STA_INFO, fill);
}

Message survey(const std::function<void(nl_msg*)>& fill) {
  return build(NL80211_CMD_NEW_SURVEY_RESULTS, NL80211_ATTR_SURVEY_INFO, fill);
}

void put_dbm(nl_msg* message, int attribute, int dbm) {
  nla_put_u8(message, attribute, static_cast<std::uint8_t>(dbm));
}

/// The values of a recorded `iw station dump` (mac80211_hwsim at the edge of its range).
void fill_recorded_station(nl_msg* m) {
  put_dbm(m, NL80211_STA_INFO_SIGNAL, -88);
  put_dbm(m, NL80211_STA_INFO_SIGNAL_AVG, -81);
  nla_put_u32(m, NL80211_STA_INFO_TX_PACKETS, 23);
  nla_put_u32(m, NL80211_STA_INFO_TX_RETRIES, 5);
  nla_put_u32(m, NL80211_STA_INFO_TX_FAILED, 1);
  nla_put_u32(m, NL80211_STA_INFO_BEACON_LOSS, 2);
  nla_put_u32(m, NL80211_STA_INFO_EXPECTED_THROUGHPUT, 18126);
  nlattr* rate = nla_nest_start(m, NL80211_STA_INFO_TX_BITRATE);
  nla_put_u16(m, NL80211_RATE_INFO_BITRATE, 540);
  nla_put_u32(m, NL80211_RATE_INFO_BITRATE32, 540);
  nla_nest_end(m, rate);
}

TEST(Nl80211Station, ReadsEveryField) {
  const auto sut = parse_station(station(fill_recorded_station).get());
  ASSERT_TRUE(sut);
  EXPECT_EQ(sut->source, WirelessSource::nl80211);
  EXPECT_TRUE(sut->associated);
  EXPECT_THAT(sut->signal_dbm, Optional(-88.0));
  EXPECT_THAT(sut->signal_avg_dbm, Optional(-81.0));
  EXPECT_THAT(sut->quality, Optional(22.0));  // as iwconfig prints it at -88 dBm
  EXPECT_THAT(sut->tx_packets, Optional(23U));
  EXPECT_THAT(sut->tx_retries, Optional(5U));
  EXPECT_THAT(sut->tx_failed, Optional(1U));
  EXPECT_THAT(sut->beacon_loss, Optional(2U));
  EXPECT_THAT(sut->tx_bitrate_mbps, Optional(DoubleNear(54.0, 1e-9)));
  EXPECT_THAT(sut->expected_throughput_mbps, Optional(DoubleNear(18.126, 1e-9)));
}

TEST(Nl80211Station, LeavesEmptyWhatTheDriverDoesNotTell) {
  const auto sut =
      parse_station(station([](nl_msg* m) { put_dbm(m, NL80211_STA_INFO_SIGNAL, -60); }).get());
  ASSERT_TRUE(sut);
  EXPECT_THAT(sut->signal_dbm, Optional(-60.0));
  EXPECT_EQ(sut->signal_avg_dbm, std::nullopt);
  EXPECT_EQ(sut->noise_dbm, std::nullopt);
  EXPECT_EQ(sut->tx_packets, std::nullopt);
  EXPECT_EQ(sut->tx_retries, std::nullopt);
  EXPECT_EQ(sut->tx_failed, std::nullopt);
  EXPECT_EQ(sut->beacon_loss, std::nullopt);
  EXPECT_EQ(sut->tx_bitrate_mbps, std::nullopt);
  EXPECT_EQ(sut->expected_throughput_mbps, std::nullopt);
  const auto without = parse_station(
      station([](nl_msg* m) { nla_put_u32(m, NL80211_STA_INFO_TX_PACKETS, 1); }).get());
  ASSERT_TRUE(without);
  EXPECT_EQ(without->quality, std::nullopt);
}

TEST(Nl80211Station, FallsBackToTheOldRateAttribute) {
  const auto sut = parse_station(station([](nl_msg* m) {
                                   nlattr* rate = nla_nest_start(m, NL80211_STA_INFO_TX_BITRATE);
                                   nla_put_u16(m, NL80211_RATE_INFO_BITRATE, 55);
                                   nla_nest_end(m, rate);
                                 }).get());
  ASSERT_TRUE(sut);
  EXPECT_THAT(sut->tx_bitrate_mbps, Optional(DoubleNear(5.5, 1e-9)));
}

TEST(Nl80211Station, IsRejectedWhenAValueIsTooShort) {
  const auto sut =
      parse_station(station([](nl_msg* m) { put_dbm(m, NL80211_STA_INFO_TX_PACKETS, 1); }).get());
  EXPECT_FALSE(sut);
}

TEST(Nl80211Station, IsNotReadFromAnotherMessage) {
  EXPECT_FALSE(parse_station(
      build(NL80211_CMD_NEW_INTERFACE, NL80211_ATTR_STA_INFO, fill_recorded_station).get()));
  EXPECT_FALSE(
      parse_station(build(NL80211_CMD_NEW_STATION, NL80211_ATTR_BSS, fill_recorded_station).get()));
  const Message empty(nlmsg_alloc());
  EXPECT_FALSE(parse_station(empty.get()));
}

void fill_survey(nl_msg* m, bool in_use) {
  nla_put_u32(m, NL80211_SURVEY_INFO_FREQUENCY, 2437);
  put_dbm(m, NL80211_SURVEY_INFO_NOISE, -92);
  if (in_use) nla_put_flag(m, NL80211_SURVEY_INFO_IN_USE);
  nla_put_u64(m, NL80211_SURVEY_INFO_TIME, 80);
  nla_put_u64(m, NL80211_SURVEY_INFO_TIME_BUSY, 10);
}

TEST(Nl80211Survey, AddsNoiseAndBusyTimeOfTheChannelInUse) {
  const auto sut = parse_survey(survey([](nl_msg* m) { fill_survey(m, true); }).get());
  ASSERT_TRUE(sut);
  WirelessReading reading;
  add_survey(*sut, reading);
  EXPECT_THAT(reading.noise_dbm, Optional(-92.0));
  EXPECT_THAT(reading.channel_time_ms, Optional(80.0));
  EXPECT_THAT(reading.channel_busy_ms, Optional(10.0));
}

TEST(Nl80211Survey, OfAnotherChannelAddsNothing) {
  // mac80211_hwsim reports every channel and marks none: nothing may be taken from it.
  const auto sut = parse_survey(survey([](nl_msg* m) { fill_survey(m, false); }).get());
  ASSERT_TRUE(sut);
  WirelessReading reading;
  add_survey(*sut, reading);
  EXPECT_EQ(reading.noise_dbm, std::nullopt);
  EXPECT_EQ(reading.channel_time_ms, std::nullopt);
}

TEST(Nl80211Survey, LeavesEmptyWhatTheDriverDoesNotTell) {
  const auto sut =
      parse_survey(survey([](nl_msg* m) { nla_put_flag(m, NL80211_SURVEY_INFO_IN_USE); }).get());
  ASSERT_TRUE(sut);
  EXPECT_TRUE(sut->in_use);
  EXPECT_EQ(sut->noise_dbm, std::nullopt);
  EXPECT_EQ(sut->busy_ms, std::nullopt);
}

TEST(Nl80211Survey, IsNotReadFromAStationMessage) {
  EXPECT_FALSE(parse_survey(station(fill_recorded_station).get()));
}

TEST(Nl80211Station, SurvivesDamagedMessages) {
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i) {
    const Message message = station(fill_recorded_station);
    nlmsghdr* header = nlmsg_hdr(message.get());
    auto* bytes = reinterpret_cast<std::uint8_t*>(header);
    for (int k = 0; k < 4; ++k) {
      const std::size_t at = NLMSG_HDRLEN + random() % (header->nlmsg_len - NLMSG_HDRLEN);
      bytes[at] = static_cast<std::uint8_t>(random());
    }
    (void)parse_station(message.get());
    (void)parse_survey(message.get());
  }
}

TEST(Nl80211Reader, SaysWhyALoopbackHasNoReading) {
  Nl80211Reader sut;
  const WirelessReading reading = sut.read("lo");
  EXPECT_EQ(reading.source, WirelessSource::absent);
  EXPECT_NE(reading.note, "");
}

}  // namespace
}  // namespace tocsin::network
