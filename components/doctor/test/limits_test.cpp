// SPDX-License-Identifier: Apache-2.0
#include "limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace tocsin::doctor {
namespace {

using ::testing::HasSubstr;

/// The advice on one setting, all others unreadable.
Advice judged(const std::string& name, const std::string& value, std::size_t index) {
  const auto read = [&](const std::string& wanted) {
    return wanted == name ? std::optional<std::string>(value) : std::nullopt;
  };
  return judge_limits(read, false)[index];
}

TEST(Limits, ABufferOfAMebibyteIsEnough) {
  EXPECT_EQ(judged("net.core.rmem_max", "1048576\n", 0).verdict, Verdict::good);
  const Advice less = judged("net.core.rmem_max", "1048575\n", 0);
  EXPECT_EQ(less.verdict, Verdict::bad);
  EXPECT_EQ(less.remedy, "sysctl -w net.core.rmem_max=1048576");
}

TEST(Limits, TheSendBufferIsJudgedAlike) {
  EXPECT_EQ(judged("net.core.wmem_max", "212992\n", 1).verdict, Verdict::bad);
}

TEST(Limits, AnEmptyPingRangeIsBad) {
  EXPECT_EQ(judged("net.ipv4.ping_group_range", "1\t0\n", 2).verdict, Verdict::bad);
  EXPECT_EQ(judged("net.ipv4.ping_group_range", "0\t2147483647\n", 2).verdict, Verdict::good);
}

TEST(Limits, RootNeedsNoPingRange) {
  const auto read = [](const std::string&) { return std::nullopt; };
  EXPECT_EQ(judge_limits(read, true)[2].verdict, Verdict::good);
}

TEST(Limits, WhatCannotBeReadIsUnknown) {
  const auto read = [](const std::string&) { return std::nullopt; };
  for (const Advice& advice : judge_limits(read, false)) {
    EXPECT_EQ(advice.verdict, Verdict::unknown);
    EXPECT_THAT(advice.text, HasSubstr("cannot be read"));
  }
}

}  // namespace
}  // namespace tocsin::doctor
