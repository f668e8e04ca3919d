// SPDX-License-Identifier: Apache-2.0
#include "telemetry/memory.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tocsin::telemetry {
namespace {

const std::string text =
    "MemTotal:        4000 kB\nMemFree:          500 kB\nMemAvailable:    1000 kB\n"
    "Buffers:            10 kB\nHugePages_Total:       0\n";

TEST(Meminfo, TellsTotalAndAvailable) {
  const auto sut = parse_meminfo(text);
  ASSERT_TRUE(sut);
  EXPECT_EQ(sut->total_bytes, 4000U * 1024);
  EXPECT_EQ(sut->available_bytes, 1000U * 1024);
  EXPECT_DOUBLE_EQ(sut->used_percent(), 75.0);
}

TEST(Meminfo, IsRejectedWhenItIsNotWholeOrDamaged) {
  for (const char* bad :
       {"", "MemTotal: 4000 kB\n", "MemAvailable: 4000 kB\n",
        "MemTotal: x kB\nMemAvailable: 1 kB\n", "MemTotal: -4 kB\nMemAvailable: 1 kB\n",
        "MemTotal: 4\nMemAvailable: 1 kB\n", "MemTotal: 4kB\nMemAvailable: 1 kB\n",
        "MemTotal: 0 kB\nMemAvailable: 0 kB\n",
        "MemTotal: 18014398509481985 kB\nMemAvailable: 1 kB\n"}) {
    EXPECT_FALSE(parse_meminfo(bad)) << bad;
  }
}

TEST(Memory, StaysWithinItsRange) {
  EXPECT_DOUBLE_EQ((Memory{100, 0}.used_percent()), 100.0);
  EXPECT_DOUBLE_EQ((Memory{100, 100}.used_percent()), 0.0);
  EXPECT_DOUBLE_EQ((Memory{100, 101}.used_percent()), 0.0);
}

TEST(Meminfo, SurvivesAnyText) {
  std::mt19937 random(5);
  for (int i = 0; i < 5000; ++i) {
    std::string damaged = text;
    for (int k = 0; k < 6; ++k) {
      damaged[random() % damaged.size()] = static_cast<char>(random() % 128);
    }
    const auto memory = parse_meminfo(damaged);
    if (!memory) continue;
    EXPECT_GE(memory->used_percent(), 0.0);
    EXPECT_LE(memory->used_percent(), 100.0);
  }
}

}  // namespace
}  // namespace tocsin::telemetry
