// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/velocity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tocsin::kobuki {
namespace {

struct Row {
  double v;
  double w;
  int speed;
  int radius;
};

// Reference page 1.5, with rounding where the reference truncates.
TEST(Velocity, EncodesTheTable) {
  const Row rows[]{{0, 1.0, 115, 1},
                   {0, -1.0, -115, 1},
                   {0.1, 0.5, 158, 200},
                   {-0.1, -0.5, -158, 200},
                   {0, 0.001, 0, 1},
                   {0.3, -0.5, 358, -600},
                   {-0.3, 0.5, -358, -600},
                   {0.1, 0.0001, 100, 32767},
                   {40, 0, 32767, 0},
                   {0, 0, 0, 0},
                   {0.1, 0, 100, 0},
                   {-0.7, 0, -700, 0},
                   // The reference truncates to 118 and so drives every slow arc too slow.
                   {0.1, 0.165, 119, 606},
                   {0.0019, 0, 2, 0}};
  for (const Row& row : rows) {
    const BaseControl got = encode_velocity({row.v, row.w});
    EXPECT_NEAR(got.speed_mm_s, row.speed, 0.5) << row.v << " " << row.w;
    EXPECT_EQ(got.radius_mm, row.radius) << row.v << " " << row.w;
  }
}

TEST(Velocity, NeverSendsRadiusMinusOne) {
  EXPECT_EQ(encode_velocity({0.0011, -1.0}).radius_mm, 1);  // the reference sends 116, -1
  EXPECT_EQ(encode_velocity({0.0011, -1.0}).speed_mm_s, -115);
  for (double v = -0.02; v <= 0.02; v += 0.00005) {
    for (double w = -4; w <= 4; w += 0.05) {
      const BaseControl got = encode_velocity({v, w});
      ASSERT_NE(got.radius_mm, -1) << v << " " << w;
      ASSERT_TRUE(got.radius_mm != 0 || std::abs(w) < 1e-4) << v << " " << w;
    }
  }
}

TEST(Velocity, KeepsTheDirectionOfTurn) {
  for (double v = -0.5; v <= 0.5; v += 0.013) {
    for (double w = -3; w <= 3; w += 0.031) {
      const geometry::Twist got = body_velocity(decode_velocity(encode_velocity({v, w})));
      ASSERT_NEAR(got.linear_mps, v, 0.0025) << v << " " << w;
      ASSERT_NEAR(got.angular_rad_s, w, 0.011 + 0.08 * std::abs(w)) << v << " " << w;
    }
  }
}

TEST(Velocity, ClampsInsteadOfOverflowing) {
  // An overflowing 16-bit radius drove older drivers backwards.
  EXPECT_EQ(encode_velocity({0.1, 0.0002}).radius_mm, 32767);
  EXPECT_EQ(encode_velocity({0.1, -0.0002}).radius_mm, -32768);
  EXPECT_EQ(encode_velocity({-40, 0}).speed_mm_s, -32768);
  EXPECT_GT(encode_velocity({0.1, 0.0002}).speed_mm_s, 0);
}

TEST(Velocity, StopsOnNumbersThatAreNone) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(encode_velocity({bad, 0}).speed_mm_s, 0);
    EXPECT_EQ(encode_velocity({0.5, bad}).speed_mm_s, 0);
    EXPECT_EQ(encode_velocity({0.5, bad}).radius_mm, 0);
  }
}

TEST(Velocity, DecodesAsTheFirmwareDoes) {
  const auto spin = decode_velocity({115, 1});
  EXPECT_DOUBLE_EQ(spin.left_mps, -0.115);
  EXPECT_DOUBLE_EQ(spin.right_mps, 0.115);
  const auto minus_one = decode_velocity({115, -1});
  EXPECT_DOUBLE_EQ(minus_one.left_mps, 0.115);
  const auto left = decode_velocity({345, 345});
  EXPECT_DOUBLE_EQ(left.right_mps, 0.345);
  EXPECT_DOUBLE_EQ(left.left_mps, 0.1725);
  const auto right = decode_velocity({345, -345});
  EXPECT_DOUBLE_EQ(right.left_mps, 0.345);
  EXPECT_DOUBLE_EQ(right.right_mps, 0.1725);
  EXPECT_DOUBLE_EQ(decode_velocity({-200, 0}).left_mps, -0.2);
}

}  // namespace
}  // namespace tocsin::kobuki
