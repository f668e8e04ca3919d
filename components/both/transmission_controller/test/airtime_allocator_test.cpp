// SPDX-License-Identifier: Apache-2.0
#include "airtime_allocator/airtime_allocator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tocsin {
namespace {

constexpr Time t0{std::chrono::hours(1)};

double sum_of(const std::vector<AirtimeAllocator::Share>& shares) {
  double sum = 0;
  for (const auto& one : shares) sum += one.share;
  return sum;
}

TEST(AirtimeAllocator, AloneAVehicleHasAllOfTheAir) {
  AirtimeAllocator sut({0.6, 4}, 3);
  sut.on_use(1, {0.9, 1, false}, t0);
  EXPECT_EQ(sut.divide(t0).shares[1].share, 1);
  EXPECT_DOUBLE_EQ(sut.divide(t0).shares[1].fallback, 0.2);
}

TEST(AirtimeAllocator, CountsAllWhileTheyStartAndThenThoseThatAreHeard) {
  AirtimeAllocator sut({0.6, 4}, 3);
  EXPECT_EQ(sut.divide(t0).vehicles, 3U);
  const Time before_its_end = t0 + AirtimeAllocator::starting - std::chrono::milliseconds(1);
  sut.on_use(1, {0.1, 1, false}, before_its_end);
  EXPECT_EQ(sut.divide(before_its_end).vehicles, 3U);
  EXPECT_EQ(sut.divide(t0 + AirtimeAllocator::starting).vehicles, 1U);
}

TEST(AirtimeAllocator, AllThatWantMoreHaveTheSame) {
  AirtimeAllocator sut({0.6, 4}, 3);
  for (std::size_t i = 0; i < 3; ++i) sut.on_use(i, {0.2, 0.2, false}, t0);
  for (const auto& one : sut.divide(t0).shares) EXPECT_DOUBLE_EQ(one.share, 0.2);
}

TEST(AirtimeAllocator, WhatOneDoesNotUseTheOthersHave) {
  AirtimeAllocator sut({0.6, 4}, 3);
  sut.on_use(0, {0.02, 0.2, false}, t0);
  sut.on_use(1, {0.2, 0.2, false}, t0);
  sut.on_use(2, {0.2, 0.2, false}, t0);
  const auto shares = sut.divide(t0).shares;
  EXPECT_DOUBLE_EQ(shares[0].share, 0.05) << "a quarter of its part, to begin with";
  EXPECT_DOUBLE_EQ(shares[1].share, 0.275);
  EXPECT_DOUBLE_EQ(shares[2].share, 0.275);
}

TEST(AirtimeAllocator, WhereAllAreIdleEachHasItsPartReady) {
  AirtimeAllocator sut({0.6, 4}, 3);
  for (std::size_t i = 0; i < 3; ++i) sut.on_use(i, {0.001, 0.2, false}, t0);
  for (const auto& one : sut.divide(t0).shares) EXPECT_DOUBLE_EQ(one.share, 0.2);
}

TEST(AirtimeAllocator, WhoBeginsToSendHasItsPartTwoReportsLater) {
  AirtimeAllocator sut({0.6, 4}, 2);
  sut.on_use(0, {0, 0.3, false}, t0);
  sut.on_use(1, {0.5, 0.5, false}, t0);
  const double first = sut.divide(t0).shares[0].share;
  sut.on_use(0, {first, first, false}, t0);
  EXPECT_DOUBLE_EQ(sut.divide(t0).shares[0].share, 0.3);
}

TEST(AirtimeAllocator, WhoSendsSeldomAndMuchHasItsPartToo) {
  AirtimeAllocator sut({0.6, 4}, 2);
  sut.on_use(0, {0.001, 0.075, true}, t0);  // its picture waited
  sut.on_use(1, {0.5, 0.5, false}, t0);
  EXPECT_DOUBLE_EQ(sut.divide(t0).shares[0].share, 0.3);
}

TEST(AirtimeAllocator, OneDrivenByHandHasMore) {
  AirtimeAllocator sut({0.6, 4}, 3);
  for (std::size_t i = 0; i < 3; ++i) sut.on_use(i, {0.5, 0.2, false}, t0);
  sut.set_driven(2, true);
  EXPECT_DOUBLE_EQ(sut.divide(t0).shares[0].share, 0.1);
  EXPECT_DOUBLE_EQ(sut.divide(t0).shares[2].share, 0.4);
  sut.set_driven(2, false);
  EXPECT_DOUBLE_EQ(sut.divide(t0).shares[2].share, 0.2);
}

TEST(AirtimeAllocator, WhatStrangersTakeIsLeftToThem) {
  AirtimeAllocator sut({0.6, 4}, 3);
  for (std::size_t i = 0; i < 3; ++i) sut.on_use(i, {0.1, 0.1, true}, t0);
  sut.on_busy(0, 0.7, t0);
  sut.on_busy(1, 0.8, t0);
  sut.on_busy(2, std::nan(""), t0);
  // The upper of two is their median here; 0.3 of it is of these three.
  EXPECT_DOUBLE_EQ(sut.divide(t0).shares[0].share, 0.6 * 0.5 / 3);
  for (std::size_t i = 0; i < 3; ++i) sut.on_busy(i, 1, t0);
  EXPECT_NEAR(sut.divide(t0).shares[0].share, 0.6 * 0.3 / 3, 1e-12);
  for (std::size_t i = 0; i < 3; ++i) sut.on_busy(i, 0.2, t0);
  EXPECT_DOUBLE_EQ(sut.divide(t0).shares[0].share, 0.2) << "less than they say to have used";
}

TEST(AirtimeAllocator, WhoIsSilentTakesNothingFromTheOthers) {
  AirtimeAllocator sut({0.6, 4}, 3);
  for (std::size_t i = 0; i < 3; ++i) sut.on_use(i, {0.2, 0.2, false}, t0);
  const Time later = t0 + AirtimeAllocator::silence_limit + Duration{1};
  sut.on_use(0, {0.2, 0.2, false}, later);
  sut.on_use(1, {0.2, 0.2, false}, later);
  EXPECT_DOUBLE_EQ(sut.divide(later).shares[0].share, 0.3);
  EXPECT_DOUBLE_EQ(sut.divide(later).shares[2].share, 0.2) << "what it goes by when it is back";
}

TEST(AirtimeAllocator, TakesNoReportThatIsNone) {
  AirtimeAllocator sut({0.6, 4}, 2);
  for (const double bad : {-1.0, 1.5, std::nan("")}) {
    sut.on_use(0, {bad, 0.2, false}, t0);
    sut.on_use(0, {0.2, bad, false}, t0);
  }
  sut.on_use(1, {0.2, 0.2, false}, t0);
  EXPECT_EQ(sut.divide(t0).shares[1].share, 1) << "nobody else is heard";
}

TEST(AirtimeAllocator, NeverGivesMoreThanThereIsNorNothing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (int round = 0; round < 1000; ++round) {
    const std::size_t vehicles = 2 + random() % 19;
    AirtimeAllocator sut({0.6, 4}, vehicles);
    for (std::size_t i = 0; i < vehicles; ++i) {
      sut.on_use(i, {part(random) * part(random), part(random), false}, t0);
      sut.set_driven(i, random() % 5 == 0);
    }
    const auto shares = sut.divide(t0).shares;
    ASSERT_LE(sum_of(shares), 0.6 + 1e-9);
    for (const auto& one : shares) {
      ASSERT_GE(one.share, 0.25 * 0.6 / (4 * static_cast<double>(vehicles)) - 1e-9);
    }
  }
}

}  // namespace
}  // namespace tocsin
