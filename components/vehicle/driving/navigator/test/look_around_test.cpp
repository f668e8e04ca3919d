// SPDX-License-Identifier: Apache-2.0
#include "navigator/look_around.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

constexpr Time t0{std::chrono::hours(1)};

Time at(double s) { return t0 + seconds(s); }

/// A wall all around, and so far ahead of the vehicle's middle.
laser::Scan wall_ahead(double m) {
  laser::Scan scan;
  scan.hits = {{m, 0}, {-0.3, 0}, {0, 0.4}, {0, -0.4}};
  return scan;
}

geometry::Twist next(LookAround& sut, double s, double ahead_m) {
  sut.on_scan(wall_ahead(ahead_m), at(s));
  return sut.next(at(s));
}

TEST(LookAround, StandsThenTurnsThenDrivesAndBeginsAgain) {
  LookAround sut;
  EXPECT_EQ(next(sut, 0, 3).angular_rad_s, 0);
  EXPECT_EQ(next(sut, 2.9, 3).angular_rad_s, 0);
  EXPECT_EQ(next(sut, 3.1, 3).angular_rad_s, 0.5);
  EXPECT_EQ(next(sut, 32.9, 3).linear_mps, 0) << "two turns and more";
  EXPECT_EQ(next(sut, 33.1, 3).linear_mps, 0.2);
  EXPECT_EQ(next(sut, 42.9, 3).linear_mps, 0.2);
  EXPECT_EQ(next(sut, 43.1, 3).linear_mps, 0) << "stands again";
  EXPECT_EQ(next(sut, 46.5, 3).angular_rad_s, 0.5);
}

TEST(LookAround, TurnsWhereTheWayIsNotFreeAndGoesOnNearerThanItBegins) {
  LookAround sut;
  (void)next(sut, 0, 3);
  EXPECT_EQ(next(sut, 34, 0.9).linear_mps, 0);
  EXPECT_EQ(next(sut, 34.1, 0.9).angular_rad_s, 0.5);
  EXPECT_EQ(next(sut, 35, 1.1).linear_mps, 0.2);
  EXPECT_EQ(next(sut, 36, 0.6).linear_mps, 0.2) << "has begun";
  EXPECT_EQ(next(sut, 37, 0.4).linear_mps, 0);
  EXPECT_EQ(next(sut, 37.1, 0.6).linear_mps, 0);
}

TEST(LookAround, DoesNotDriveWithoutAScan) {
  LookAround sut;
  (void)sut.next(at(0));
  EXPECT_EQ(sut.next(at(35)).linear_mps, 0);
  sut.on_scan(wall_ahead(3), at(35));
  EXPECT_EQ(sut.next(at(35.4)).linear_mps, 0.2);
  EXPECT_EQ(sut.next(at(35.6)).linear_mps, 0) << "too old";
  sut.on_scan({}, at(36));
  EXPECT_EQ(sut.next(at(36)).linear_mps, 0) << "sees nothing at all";
}

TEST(LookAround, WhatStandsBesideTheWayOrBehindIsNotAhead) {
  LookAround sut;
  (void)sut.next(at(0));
  laser::Scan scan = wall_ahead(3);
  scan.hits.push_back({0.3, 0.26});
  scan.hits.push_back({-0.4, 0.1});
  sut.on_scan(scan, at(35));
  EXPECT_EQ(sut.next(at(35)).linear_mps, 0.2);
  scan.hits.push_back({0.45, 0.24});
  sut.on_scan(scan, at(35.1));
  EXPECT_EQ(sut.next(at(35.1)).linear_mps, 0);
}

TEST(LookAround, BeginsAnewWhenItWasOver) {
  LookAround sut;
  (void)sut.next(at(0));
  EXPECT_EQ(sut.next(at(10)).angular_rad_s, 0.5);
  sut.end();
  EXPECT_EQ(sut.next(at(11)).angular_rad_s, 0) << "stands first";
}

}  // namespace
}  // namespace tocsin
