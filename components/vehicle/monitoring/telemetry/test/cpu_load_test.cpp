// SPDX-License-Identifier: Apache-2.0
#include "telemetry/cpu_load.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace tocsin::telemetry {
namespace {

using ::testing::ElementsAre;

//                        user nice system idle iowait irq softirq steal guest guest_nice
const std::string text =
    "cpu  100 10 30 700 50 1 2 7 90 0\n"
    "cpu0 60 5 15 300 20 1 1 3 90 0\n"
    "cpu2 40 5 15 400 30 0 1 4 0 0\n"
    "intr 1 2 3\nctxt 437511\n";

CpuSnapshot snapshot(CpuTimes all, std::map<int, CpuTimes> cores = {}) {
  return {all, std::move(cores)};
}

TEST(ProcStat, SumsBusyAndIdleTimeOfAllAndOfEachCore) {
  const auto sut = parse_proc_stat(text);
  ASSERT_TRUE(sut);
  EXPECT_EQ(sut->all.busy, 150U);  // guest time is in user time already
  EXPECT_EQ(sut->all.idle, 750U);
  ASSERT_EQ(sut->cores.size(), 2U);
  EXPECT_EQ(sut->cores.at(0).busy, 85U);
  EXPECT_EQ(sut->cores.at(2).idle, 430U);
  const auto damaged = parse_proc_stat("cpu 6 5 1 3 2 1 1 3\ncpu0 1 2\ncpux 6 5 1 3 2 1 1 3\n");
  ASSERT_TRUE(damaged);
  EXPECT_TRUE(damaged->cores.empty());
}

TEST(ProcStat, NeedsTheLineOfAllCpus) {
  EXPECT_FALSE(parse_proc_stat(""));
  EXPECT_FALSE(parse_proc_stat("cpu0 60 5 15 300 20 1 1 3\n"));
  EXPECT_FALSE(parse_proc_stat("cpu 60 5 15 300 20 1 1\n"));
  EXPECT_FALSE(parse_proc_stat("cpu 60 5 15 x 20 1 1 3\n"));
  EXPECT_FALSE(parse_proc_stat("cpu 60 5 15 -1 20 1 1 3\n"));
  EXPECT_TRUE(parse_proc_stat("cpu 60 5 15 300 20 1 1 3\n"));
}

TEST(CpuLoadMeter, GivesTheShareOfBusyTimeSinceTheLastLook) {
  CpuLoadMeter sut;
  EXPECT_FALSE(sut.update(snapshot({1000, 1000}))) << "the first look";
  EXPECT_FALSE(sut.update(snapshot({1000, 1000}))) << "no time has passed";
  for (const auto& [times, percent] : {std::pair(CpuTimes{1025, 1075}, 25.0),
                                       {CpuTimes{1125, 1075}, 100.0},
                                       {CpuTimes{1125, 1175}, 0.0},
                                       {CpuTimes{1135, 1174}, 100.0}}) {  // idle stepped back
    const auto load = sut.update(snapshot(times));
    ASSERT_TRUE(load);
    EXPECT_DOUBLE_EQ(load->all_percent, percent);
  }
}

TEST(CpuLoadMeter, LeavesOutACoreThatHasJustComeOn) {
  CpuLoadMeter sut;
  (void)sut.update(snapshot({0, 0}, {{0, {0, 0}}}));
  EXPECT_THAT(sut.update(snapshot({10, 10}, {{0, {5, 5}}, {1, {9, 9}}}))->cores_percent,
              ElementsAre(50.0));
  EXPECT_THAT(sut.update(snapshot({20, 20}, {{0, {5, 15}}, {1, {19, 9}}}))->cores_percent,
              ElementsAre(0.0, 100.0));
}

TEST(ProcStat, SurvivesAnyText) {
  std::mt19937 random(6);
  for (int i = 0; i < 5000; ++i) {
    std::string damaged = text;
    for (int k = 0; k < 6; ++k) {
      damaged[random() % damaged.size()] = static_cast<char>(random() % 128);
    }
    (void)parse_proc_stat(damaged);
  }
}

}  // namespace
}  // namespace tocsin::telemetry
