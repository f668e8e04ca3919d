// SPDX-License-Identifier: Apache-2.0
#include "network_monitor/reported_loss.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tocsin::network {
namespace {

using Side = ReportedLoss::Side;
constexpr Time t0{std::chrono::hours(1)};

TEST(ReportedLoss, IsWhatAProbeMeetsThereAndBack) {
  ReportedLoss sut;
  sut.on_report(Side::own, 0.5, t0);
  sut.on_report(Side::other, 0.2, t0);
  EXPECT_DOUBLE_EQ(sut.per_percent(t0).value(), 60);
  sut.on_report(Side::own, 0, t0);
  EXPECT_DOUBLE_EQ(sut.per_percent(t0).value(), 20);
  sut.on_report(Side::other, 1, t0);
  EXPECT_DOUBLE_EQ(sut.per_percent(t0).value(), 100);
}

TEST(ReportedLoss, IsTheOwnOneWhileNothingIsReceivedOfTheOther) {
  ReportedLoss sut;
  sut.on_report(Side::other, 0.2, t0);
  EXPECT_FALSE(sut.per_percent(t0)) << "the own router has said nothing";
  sut.on_report(Side::own, 0.5, t0 + ReportedLoss::lasts);
  EXPECT_DOUBLE_EQ(sut.per_percent(t0 + ReportedLoss::lasts).value(), 60);
  const Time later = t0 + ReportedLoss::lasts + Duration(1);
  EXPECT_DOUBLE_EQ(sut.per_percent(later).value(), 50);
}

TEST(ReportedLoss, IsNotKnownWhenTheOwnRouterFallsSilent) {
  ReportedLoss sut;
  sut.on_report(Side::own, 0.5, t0);
  EXPECT_TRUE(sut.per_percent(t0 + ReportedLoss::lasts));
  EXPECT_FALSE(sut.per_percent(t0 + ReportedLoss::lasts + Duration(1)));
}

TEST(ReportedLoss, TakesNoShareThatIsNone) {
  ReportedLoss sut;
  sut.on_report(Side::own, 0.25, t0);
  for (const double none : {-0.01, 1.01, std::numeric_limits<double>::quiet_NaN()}) {
    sut.on_report(Side::own, none, t0);
    EXPECT_DOUBLE_EQ(sut.per_percent(t0).value(), 25);
  }
}

}  // namespace
}  // namespace tocsin::network
