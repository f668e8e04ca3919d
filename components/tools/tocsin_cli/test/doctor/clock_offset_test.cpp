// SPDX-License-Identifier: Apache-2.0
#include "clock_offset.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::doctor {
namespace {

using ::testing::HasSubstr;

/// The reply of a kernel whose clock is at `there_ms` all the while.
IcmpTimestamp reply(std::uint16_t id, std::uint32_t sent_ms, std::uint32_t there_ms) {
  IcmpTimestamp bytes = timestamp_request(id, sent_ms);
  bytes[0] = 14;
  for (unsigned i = 0; i < 4; ++i) {
    bytes[12 + i] = bytes[16 + i] = static_cast<std::uint8_t>(there_ms >> (24U - 8U * i));
  }
  return bytes;
}

TEST(ClockOffset, TheRequestsChecksumIsRight) {
  const IcmpTimestamp bytes = timestamp_request(0x1234, 0x00ABCDEF);
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 2) sum += bytes[i] * 256U + bytes[i + 1];
  EXPECT_EQ((sum & 0xFFFF) + (sum >> 16U), 0xFFFFU);
}

TEST(ClockOffset, IsTheMeanOfBothWays) {
  const IcmpTimestamp bytes = reply(7, 1000, 1150);
  EXPECT_EQ(clock_ahead_ms(bytes.data(), bytes.size(), 7, 1100), 100.0);
}

TEST(ClockOffset, CountsAcrossMidnight) {
  const IcmpTimestamp bytes = reply(7, 86'399'990, 5);
  EXPECT_EQ(clock_ahead_ms(bytes.data(), bytes.size(), 7, 86'399'990), 15.0);
}

TEST(ClockOffset, RefusesOtherPackets) {
  IcmpTimestamp bytes = reply(7, 1000, 1150);
  EXPECT_FALSE(clock_ahead_ms(bytes.data(), bytes.size(), 8, 1100));      // another program's
  EXPECT_FALSE(clock_ahead_ms(bytes.data(), bytes.size() - 1, 7, 1100));  // cut
  bytes[12] |= 0x80U;
  EXPECT_FALSE(clock_ahead_ms(bytes.data(), bytes.size(), 7, 1100));  // no UTC there
  bytes[0] = 0;
  EXPECT_FALSE(clock_ahead_ms(bytes.data(), bytes.size(), 7, 1100));  // an echo reply
}

TEST(ClockOffset, TwentyMillisecondsAreTolerated) {
  EXPECT_EQ(judge_clock("10.0.0.2", -20).fitness, Fitness::good);
  const Advice advice = judge_clock("10.0.0.2", -21);
  EXPECT_EQ(advice.fitness, Fitness::bad);
  EXPECT_THAT(advice.text, HasSubstr("clock of 10.0.0.2 is 21 ms behind ours"));
}

TEST(ClockOffset, ThisComputersOwnClockAgreesWithItself) {
  const Advice advice = compare_clock("127.0.0.1");
  if (advice.fitness == Fitness::unknown) GTEST_SKIP() << advice.text;
  EXPECT_EQ(advice.fitness, Fitness::good) << advice.text;
}

}  // namespace
}  // namespace tocsin::doctor
