// SPDX-License-Identifier: Apache-2.0
#include "scan_input/pose_history.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

constexpr std::int64_t ms = 1'000'000;

TEST(PoseHistory, LiesBetweenPosesAndTurnsTheShortWay) {
  PoseHistory sut;
  sut.add(1000 * ms, {1, 0, 3.1});
  sut.add(1020 * ms, {2, 4, -3.1});
  const auto at = sut.at(1005 * ms);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->x_m, 1.25, 1e-9);
  EXPECT_NEAR(at->y_m, 1, 1e-9);
  EXPECT_NEAR(at->heading_rad, 3.1 + 0.25 * (2 * 3.14159265358979 - 6.2), 1e-9);
  EXPECT_EQ(sut.at(1000 * ms)->x_m, 1);
  EXPECT_EQ(sut.at(1020 * ms)->x_m, 2);
}

TEST(PoseHistory, KnowsNothingOfWhatIsTooOldOrTooNew) {
  PoseHistory sut;
  EXPECT_FALSE(sut.at(0));
  for (int i = 0; i <= 300; ++i) sut.add(i * 20 * ms, {i * 0.01, 0, 0});
  EXPECT_FALSE(sut.at(3900 * ms)) << "2.1 s";
  EXPECT_NEAR(sut.at(4100 * ms)->x_m, 2.05, 1e-9);
  EXPECT_EQ(sut.at(6100 * ms)->x_m, 3) << "the newest";
  EXPECT_FALSE(sut.at(6300 * ms));
}

TEST(PoseHistory, BeginsAnewWhenTheClockWasPutBack) {
  PoseHistory sut;
  sut.add(5000 * ms, {1, 0, 0});
  sut.add(3000 * ms, {2, 0, 0});
  EXPECT_FALSE(sut.at(5000 * ms));
  EXPECT_EQ(sut.at(3000 * ms)->x_m, 2);
}

TEST(PoseHistory, TellsTheMeanVelocityBetweenTwoTimes) {
  PoseHistory sut;
  for (int i = 0; i <= 10; ++i) sut.add(i * 20 * ms, {0.01 * i, 1, i <= 5 ? 0.0 : 0.02 * (i - 5)});
  const auto straight = sut.velocity(0, 100 * ms);
  ASSERT_TRUE(straight);
  EXPECT_NEAR(straight->linear_mps, 0.5, 1e-9);
  EXPECT_NEAR(straight->angular_rad_s, 0, 1e-9);
  const auto both = sut.velocity(0, 200 * ms);
  ASSERT_TRUE(both);
  EXPECT_NEAR(both->angular_rad_s, 0.5, 1e-9) << "it began to turn half way";
  EXPECT_FALSE(sut.velocity(0, 10 * ms));
  EXPECT_FALSE(sut.velocity(-50 * ms, 100 * ms));
  EXPECT_FALSE(sut.velocity(100 * ms, 900 * ms));
}

}  // namespace
}  // namespace tocsin
