// SPDX-License-Identifier: Apache-2.0
#include "shapes/shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::shapes {
namespace {

/// The suite's script looks for these with regular expressions.
TEST(ShapeLines, AreThoseOfShapeMain) {
  Shape shape{"RED", 5, 123, 20, {}};
  EXPECT_EQ(sample_line("Square", shape), "Square     RED        005 123 [20]");
  shape.payload = {1, 255};
  EXPECT_EQ(sample_line("Square", shape), "Square     RED        005 123 [20] {255}");
  EXPECT_EQ(instance_line("Square", "RED", "NOT_ALIVE_DISPOSED_INSTANCE_STATE"),
            "Square     RED        NOT_ALIVE_DISPOSED_INSTANCE_STATE");
}

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
