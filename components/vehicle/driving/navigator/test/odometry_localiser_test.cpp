// SPDX-License-Identifier: Apache-2.0
#include "navigator/odometry_localiser.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tocsin {
namespace {

constexpr Time t0{std::chrono::hours(1)};

void expect_pose(const std::optional<geometry::Pose>& pose, const geometry::Pose& expected) {
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->x_m, expected.x_m, 1e-9);
  EXPECT_NEAR(pose->y_m, expected.y_m, 1e-9);
  EXPECT_NEAR(pose->heading_rad, expected.heading_rad, 1e-9);
}

TEST(OdometryLocaliser, AddsOdometryToTheStart) {
  OdometryLocaliser sut(geometry::Pose{1, 2, pi / 2});
  expect_pose(sut.update({0, 0, 0}, t0), {1, 2, pi / 2});
  expect_pose(sut.update({0.5, 0, 0.1}, t0 + seconds(1)), {1, 2.5, pi / 2 + 0.1});
}

TEST(OdometryLocaliser, StaysWhereItIsWhenOdometryJumps) {
  OdometryLocaliser sut(geometry::Pose{0, 0, 0});
  (void)sut.update({5, 1, 1}, t0);
  expect_pose(sut.update({2, 2, 2}, t0 + seconds(0.02)), {5, 1, 1});
  expect_pose(sut.update({2, 2, 2.1}, t0 + seconds(0.04)), {5, 1, 1.1});
}

TEST(OdometryLocaliser, BelievesWhatTheVehicleCanDriveInTheTime) {
  OdometryLocaliser sut(geometry::Pose{0, 0, 0});
  (void)sut.update({5, 0, 0}, t0);
  expect_pose(sut.update({5.99, 0, 0}, t0 + seconds(1)), {5.99, 0, 0});
  expect_pose(sut.update({7.00, 0, 0}, t0 + seconds(2)), {5.99, 0, 0});
}

TEST(OdometryLocaliser, BelievesABurstOfWhatWasDrivenWhileNoPoseCame) {
  OdometryLocaliser sut(geometry::Pose{0, 0, 0});
  (void)sut.update({5, 0, 0}, t0);
  (void)sut.update({5.01, 0, 0}, t0 + seconds(0.7));
  expect_pose(sut.update({5.5, 0, 0}, t0 + seconds(0.702)), {5.5, 0, 0});
  expect_pose(sut.update({6.0, 0, 0}, t0 + seconds(0.704)), {5.5, 0, 0});
}

TEST(OdometryLocaliser, ABurstIsOverAfterASecond) {
  OdometryLocaliser sut(geometry::Pose{0, 0, 0});
  (void)sut.update({5, 0, 0}, t0);
  for (int i = 0; i <= 55; ++i) (void)sut.update({5.01, 0, 0}, t0 + seconds(0.7 + 0.02 * i));
  expect_pose(sut.update({5.5, 0, 0}, t0 + seconds(1.82)), {5.01, 0, 0});
}

TEST(OdometryLocaliser, KnowsADriverThatBeganAtZeroAgainNearby) {
  OdometryLocaliser sut(geometry::Pose{0, 0, 0});
  (void)sut.update({0.5, 0, 0.3}, t0);
  expect_pose(sut.update({0, 0, 0}, t0 + seconds(2)), {0.5, 0, 0.3});
}

TEST(OdometryLocaliser, GoesOnFromAMemoryWithOdometryThatWentOnOrBeganAnew) {
  OdometryLocaliser on(OdometryLocaliser::Memory{{1, 0, 0}, {5, 0, 0}});
  expect_pose(on.update({6, 0, 0}, t0), {7, 0, 0});
  OdometryLocaliser anew(OdometryLocaliser::Memory{{1, 0, 0}, {9, 0, 0}});
  expect_pose(anew.update({0, 0, 0}, t0), {10, 0, 0});
}

TEST(OdometryLocaliser, IgnoresWhatIsNotFinite) {
  OdometryLocaliser sut(geometry::Pose{1, 0, 0});
  EXPECT_FALSE(sut.update({std::numeric_limits<double>::quiet_NaN(), 0, 0}, t0));
  expect_pose(sut.update({0, 0, 0}, t0), {1, 0, 0});
}

}  // namespace
}  // namespace tocsin
