// SPDX-License-Identifier: Apache-2.0
#include "transport/stop_bytes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tocsin {
namespace {

StopToken token(std::uint8_t first) {
  return {first, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
}

StopValue station_value() {
  StopValue value;
  value.role = Role::gcs;
  value.host = "gcs";
  value.instance = 0x0102030405060708;
  value.number = 1'795'000'000'000'000;
  value.stands = true;
  value.since_wall_ns = -5;
  value.locks = {token(1)};
  value.keys = {token(2), token(3)};
  value.by = {"station", "peer (17)"};
  return value;
}

TEST(StopBytesTest, ReadsWhatItHasWritten) {
  const StopValue value = station_value();
  const auto bytes = to_bytes(value);
  const auto read = stop_value_in(bytes.data(), bytes.size());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->first, value);
  EXPECT_EQ(read->second, bytes.size());
}

TEST(StopBytesTest, AVehiclesReportKeepsItsFlags) {
  StopValue value = station_value();
  value.role = Role::uxv;
  value.known = false;
  value.stands = false;
  const auto bytes = to_bytes(value);
  EXPECT_EQ(stop_value_in(bytes.data(), bytes.size())->first, value);
}

TEST(StopBytesTest, WhatFollowsIsNotRead) {
  auto bytes = to_bytes(station_value());
  const std::size_t size = bytes.size();
  bytes.resize(size + 9, 0xff);
  EXPECT_EQ(stop_value_in(bytes.data(), bytes.size())->second, size);
}

TEST(StopBytesTest, IsNothingWhenAByteIsMissing) {
  const auto bytes = to_bytes(station_value());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(stop_value_in(bytes.data(), size)) << size;
  }
}

TEST(StopBytesTest, TheBoundsOfListsAndNamesHoldForWriterAndReader) {
  StopValue value = station_value();
  value.locks.assign(5, token(7));
  value.by = {std::string(50, 'x'), "b", "c", "d", "e"};
  const auto bytes = to_bytes(value);
  const auto read = stop_value_in(bytes.data(), bytes.size());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->first.locks.size(), 4U);
  EXPECT_EQ(read->first.by.size(), 4U);
  EXPECT_EQ(read->first.by.front(), std::string(40, 'x'));
  auto more = to_bytes(station_value());
  constexpr std::size_t locks_at = 3 + 1 + 1 + 3 * 8;
  ASSERT_EQ(more[locks_at], 1);
  more[locks_at] = 5;
  more.resize(600);
  EXPECT_FALSE(stop_value_in(more.data(), more.size()));
}

TEST(StopBytesTest, AnotherLayoutOrRoleIsNothing) {
  auto bytes = to_bytes(station_value());
  bytes[2] = 2;
  EXPECT_FALSE(stop_value_in(bytes.data(), bytes.size()));
  bytes = to_bytes(station_value());
  bytes[4] = 2;
  EXPECT_FALSE(stop_value_in(bytes.data(), bytes.size()));
}

TEST(StopBytesTest, RandomBytesAreReadWithinTheirEnds) {
  std::mt19937 random(7);
  for (int i = 0; i < 20'000; ++i) {
    auto bytes = to_bytes(station_value());
    for (int j = 0; j < 4; ++j)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    bytes.resize(random() % bytes.size());
    bytes.shrink_to_fit();
    const auto read = stop_value_in(bytes.data(), bytes.size());
    if (read) {
      EXPECT_LE(read->second, bytes.size());
    }
  }
}

TEST(StopBytesTest, AVehicleNamesItsSiteAndOneWithoutSitesSaysWhatItAlwaysSaid) {
  StopValue value = station_value();
  const auto without = to_bytes(value);
  value.site = "south";
  auto bytes = to_bytes(value);
  EXPECT_EQ(bytes.size(), without.size() + 6);
  EXPECT_EQ(stop_value_in(bytes.data(), bytes.size())->first, value);
  EXPECT_FALSE(stop_value_in(bytes.data(), bytes.size() - 1));
  bytes[without.size()] = 41;
  bytes.resize(200);
  EXPECT_FALSE(stop_value_in(bytes.data(), bytes.size())) << "longer than a name may be";
}

}  // namespace
}  // namespace tocsin
