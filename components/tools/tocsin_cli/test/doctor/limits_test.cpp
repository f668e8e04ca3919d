// SPDX-License-Identifier: Apache-2.0
#include "limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
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
  EXPECT_EQ(judged("net.core.rmem_max", "1048576\n", 0).fitness, Fitness::good);
  const Advice less = judged("net.core.rmem_max", "1048575\n", 0);
  EXPECT_EQ(less.fitness, Fitness::bad);
  EXPECT_EQ(less.remedy, "sysctl -w net.core.rmem_max=1048576");
}

TEST(Limits, AnEmptyPingRangeIsBad) {
  EXPECT_EQ(judged("net.ipv4.ping_group_range", "1\t0\n", 2).fitness, Fitness::bad);
  EXPECT_EQ(judged("net.ipv4.ping_group_range", "0\t2147483647\n", 2).fitness, Fitness::good);
}

TEST(Limits, WhatCannotBeReadIsUnknown) {
  const auto read = [](const std::string&) { return std::nullopt; };
  for (const Advice& advice : judge_limits(read, false)) {
    EXPECT_EQ(advice.fitness, Fitness::unknown);
    EXPECT_THAT(advice.text, HasSubstr("cannot be read"));
  }
}

std::optional<std::string> nothing(const std::string&) { return std::nullopt; }

TEST(Radio, NeedsTheTunDevice) {
  EXPECT_EQ(judge_radio(nothing, true, 0)[0].fitness, Fitness::good);
  const Advice absent = judge_radio(nothing, true, ENOENT)[0];
  EXPECT_EQ(absent.fitness, Fitness::bad);
  EXPECT_THAT(absent.text, HasSubstr("/dev/net/tun (emulated radio): No such file"));
  EXPECT_THAT(absent.remedy, HasSubstr("modprobe tun"));
  EXPECT_THAT(judge_radio(nothing, false, EACCES)[0].remedy, HasSubstr("chmod"));
}

TEST(Radio, NeedsUserNamespacesForWhoIsNotRoot) {
  for (const auto& setting : std::map<std::string, std::string>{
           {"kernel.unprivileged_userns_clone", "0\n"},
           {"user.max_user_namespaces", "0\n"},
           {"kernel.apparmor_restrict_unprivileged_userns", "1\n"}}) {
    const std::string& name = setting.first;
    const auto read = [&](const std::string& wanted) {
      return wanted == name ? std::optional<std::string>(setting.second) : std::nullopt;
    };
    EXPECT_EQ(judge_radio(read, false, 0)[1].fitness, Fitness::bad) << name;
    EXPECT_THAT(judge_radio(read, false, 0)[1].remedy, HasSubstr("sysctl -w " + name + "="));
    EXPECT_EQ(judge_radio(read, true, 0)[1].fitness, Fitness::good) << name;
  }
  EXPECT_EQ(judge_radio(nothing, false, 0)[1].fitness, Fitness::good);
}

}  // namespace
}  // namespace tocsin::doctor
