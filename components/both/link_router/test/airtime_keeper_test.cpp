// SPDX-License-Identifier: Apache-2.0
#include "link_router/airtime_keeper.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::router {
namespace {

constexpr Time t0{std::chrono::hours(1)};

TEST(AirtimeKeeper, WithoutASiteAllOfTheAirIsIts) {
  const AirtimeKeeper sut;
  EXPECT_FALSE(sut.has_site());
  EXPECT_EQ(sut.share(t0), std::nullopt);
  EXPECT_EQ(sut.deadline(t0), never);
}

TEST(AirtimeKeeper, FallsBackWhenTheSiteIsSilent) {
  AirtimeKeeper sut;
  sut.on_share(0.4, 0.1, t0);
  const Time last = t0 + AirtimeKeeper::silence_limit;
  EXPECT_EQ(sut.share(last), 0.4);
  EXPECT_EQ(sut.deadline(last), last + Duration{1});
  EXPECT_EQ(sut.share(sut.deadline(last)), 0.1);
  EXPECT_EQ(sut.deadline(sut.deadline(last)), never);
  sut.on_share(0.3, 0.1, last + Duration{1});
  EXPECT_EQ(sut.share(last + Duration{1}), 0.3);
}

TEST(AirtimeKeeper, AWholeShareIsNoBound) {
  AirtimeKeeper sut;
  sut.on_share(1, 0.1, t0);
  EXPECT_EQ(sut.share(t0), std::nullopt);
  EXPECT_TRUE(sut.has_site());
}

TEST(AirtimeKeeper, TakesNoShareThatIsNone) {
  AirtimeKeeper sut;
  sut.on_share(0.4, 0.1, t0);
  for (const double bad : {-0.1, 1.1, std::nan(""), double(INFINITY)}) {
    sut.on_share(bad, 0.2, t0);
    sut.on_share(0.2, bad, t0);
  }
  EXPECT_EQ(sut.share(t0), 0.4);
}

TEST(AirtimeKeeper, NobodyIsMutedByAShareOfNothing) {
  AirtimeKeeper sut;
  sut.on_share(0, 0, t0);
  EXPECT_GT(sut.share(t0), 0);
}

}  // namespace
}  // namespace tocsin::router
