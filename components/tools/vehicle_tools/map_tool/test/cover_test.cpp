// SPDX-License-Identifier: Apache-2.0
#include "cover.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::map_tool {
namespace {

TEST(PlaceOption, IsTwoNumbers) {
  const auto sut = point_in("1.5,-2", "--start");
  EXPECT_EQ(sut.x_m, 1.5);
  EXPECT_EQ(sut.y_m, -2);
  for (const char* text : {"", "1", "1,", ",1", "1;2", "1,2,3", "1,x", "nan,1", "1,inf", " 1,2"}) {
    EXPECT_THROW((void)point_in(text, "--start"), ConfigError) << text;
  }
}

TEST(Picture, ShowsTheDriveOnTheMapUpsideUp) {
  const navigation::Grid grid{3, 2, 1, {0, 0}};
  std::vector<navigation::Cell> cells(6, navigation::Cell::free);
  cells[5] = navigation::Cell::occupied;  // the top right one
  coverage::CoveragePlan plan{
      {}, {{0.5, 0.5}, {1.5, 0.5}}, coverage::Mask(grid), coverage::Mask(grid)};
  plan.left_out.cells[3] = 1;  // the top left one
  EXPECT_EQ(picture_of({grid, cells}, plan),
            std::string("P5\n3 2\n255\n\xa0\xfe", 13) + std::string("\0PP\xfe", 4));
}

}  // namespace
}  // namespace tocsin::map_tool
