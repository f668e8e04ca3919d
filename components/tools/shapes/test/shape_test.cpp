// SPDX-License-Identifier: Apache-2.0
#include "shapes/shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::shapes {
namespace {

ShapeOptions options(int size, int modulo = 0, int instances = 1) {
  ShapeOptions options;
  options.color = "BLUE";
  options.shapesize = size;
  options.size_modulo = modulo;
  options.instances = instances;
  return options;
}

TEST(ShapeMotion, StaysWithinTheWallsAndMoves) {
  ShapeMotion sut(options(20), 7);
  Shape before = sut.next().front();
  for (int i = 0; i < 1000; ++i) {
    const Shape shape = sut.next().front();
    EXPECT_GE(shape.x, 0);
    EXPECT_LE(shape.x, 240);
    EXPECT_GE(shape.y, 0);
    EXPECT_LE(shape.y, 270);
    EXPECT_TRUE(shape.x != before.x || shape.y != before.y);
    EXPECT_EQ(shape.size, 20);
    before = shape;
  }
}

TEST(ShapeMotion, ASizeOfZeroGrowsFromOneUpToTheModulo) {
  ShapeMotion grows(options(0), 7);
  ShapeMotion starts_again(options(0, 3), 7);
  for (const int size : {1, 2, 3, 1, 2}) EXPECT_EQ(starts_again.next().front().size, size);
  for (const int size : {1, 2, 3, 4, 5}) EXPECT_EQ(grows.next().front().size, size);
}

TEST(ShapeMotion, InstancesDifferInTheColourOnly) {
  ShapeMotion sut(options(20, 0, 3), 7);
  const auto round = sut.next();
  ASSERT_EQ(round.size(), 3U);
  EXPECT_EQ(round[0].color, "BLUE");
  EXPECT_EQ(round[2].color, "BLUE2");
  EXPECT_EQ(round[0].x, round[2].x);
}

TEST(ShapeMotion, CarriesBallast) {
  ShapeOptions heavy = options(20);
  heavy.payload_bytes = 3;
  ShapeMotion sut(heavy, 7);
  EXPECT_EQ(sut.next().front().payload, (std::vector<std::uint8_t>{255, 255, 255}));
}

/// The suite's script looks for these with regular expressions.
TEST(ShapeLines, AreThoseOfShapeMain) {
  Shape shape{"RED", 5, 123, 20, {}};
  EXPECT_EQ(sample_line("Square", shape), "Square     RED        005 123 [20]");
  shape.payload = {1, 255};
  EXPECT_EQ(sample_line("Square", shape), "Square     RED        005 123 [20] {255}");
  EXPECT_EQ(instance_line("Square", "RED", "NOT_ALIVE_DISPOSED_INSTANCE_STATE"),
            "Square     RED        NOT_ALIVE_DISPOSED_INSTANCE_STATE");
}

TEST(ShapeFilter, PassesEverythingUnlessItIsTold) { EXPECT_TRUE(ShapeFilter().passes({})); }

TEST(ShapeFilter, ComparesNumbersAndColours) {
  const Shape shape{"RED", 10, 20, 30, {}};
  for (const char* passes : {"shapesize <= 30", "x = 10", "y <> 21", "y > 19", "x >= 10", "x < 11",
                             "color = 'RED'", "color <> 'BLUE'"}) {
    EXPECT_TRUE(ShapeFilter(passes).passes(shape)) << passes;
  }
  for (const char* drops :
       {"shapesize <= 29", "x <> 10", "y = 21", "y > 20", "x >= 11", "x < 10", "color = 'BLUE'"}) {
    EXPECT_FALSE(ShapeFilter(drops).passes(shape)) << drops;
  }
}

TEST(ShapeFilter, IsWhatASubscriberAsksFor) {
  Shape red;
  red.color = "RED";
  ShapeOptions options;
  EXPECT_TRUE(ShapeFilter::of(options).passes(red));
  options.color = "RED";
  EXPECT_TRUE(ShapeFilter::of(options).passes(red));
  options.color = "BLUE";
  EXPECT_FALSE(ShapeFilter::of(options).passes(red));
  options.filter = "color <> 'BLUE'";
  EXPECT_TRUE(ShapeFilter::of(options).passes(red));
}

TEST(ShapeFilter, RefusesWhatIsNotOfItsForm) {
  for (const char* wrong : {"", "x", "x =", "z = 1", "x == 1", "x = 1a", "x = 1 AND y = 2",
                            "color = RED", "color = 'RED", "color = '"}) {
    EXPECT_THROW(ShapeFilter{wrong}, ConfigError) << wrong;
  }
}

}  // namespace
}  // namespace tocsin::shapes
