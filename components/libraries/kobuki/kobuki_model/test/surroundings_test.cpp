// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/surroundings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::kobuki {
namespace {

TEST(Walls, TouchOnlyCloserThanTheRadius) {
  const Surroundings sut = walled({{1, -5, 1, 5, 3}});
  EXPECT_TRUE(sut(0.5, 0, 0.5).empty());
  EXPECT_EQ(sut(0.501, 0, 0.5).size(), 1U);
  EXPECT_EQ(walled({{1, 1, 1, 1, 0}})(1, 0.9, 0.2).size(), 1U) << "a point";
  EXPECT_TRUE(open_floor()(0, 0, 1e9).empty());
}

TEST(Walls, TellTheBearingOfTheNearestPoint) {
  const Surroundings sut = walled({{1, -5, 1, 5, 0}, {-5, 1, 5, 1, 0}});
  const auto bearings = sut(0.9, 0.9, 0.3);
  ASSERT_EQ(bearings.size(), 2U);
  EXPECT_NEAR(bearings[0], 0, 1e-12);
  EXPECT_NEAR(bearings[1], M_PI / 2, 1e-12);
}

TEST(Walls, EndWhereTheyEnd) {
  const Surroundings sut = walled({{0, 0, 1, 0, 0}});
  EXPECT_TRUE(sut(1.5, 0, 0.5).empty());
  const auto bearings = sut(1.2, 0.2, 0.5);
  ASSERT_EQ(bearings.size(), 1U);
  EXPECT_NEAR(bearings[0], -3 * M_PI / 4, 1e-12);
}

}  // namespace
}  // namespace tocsin::kobuki
