// SPDX-License-Identifier: Apache-2.0
#include "geometry/wall_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::geometry {
namespace {

using ::testing::HasSubstr;

class WallFileTest : public ::testing::Test {
 protected:
  std::vector<Wall> load(const std::string& yaml) const {
    return load_walls(folder_.write("room.walls.yaml", yaml));
  }
  std::string error_of(const std::string& yaml) const {
    try {
      (void)load(yaml);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  TemporaryFolder folder_;
};

TEST_F(WallFileTest, HoldsSegmentsInTheirOrder) {
  const auto sut = load("# c\nwalls:\n  - [1, 2, 3, 4, 6.9]\n  - [-1.5, 0, 0, 0, 3.4]\n");
  ASSERT_EQ(sut.size(), 2U);
  EXPECT_EQ(sut[0].x1_m, 1);
  EXPECT_EQ(sut[0].y1_m, 2);
  EXPECT_EQ(sut[0].x2_m, 3);
  EXPECT_EQ(sut[0].y2_m, 4);
  EXPECT_EQ(sut[0].loss_db, 6.9);
  EXPECT_EQ(sut[1].x1_m, -1.5);
}

TEST_F(WallFileTest, IsReadAgainWhenItHasChanged) {
  EXPECT_EQ(load("walls: [[0, 0, 1, 0, 1]]").size(), 1U);
  EXPECT_EQ(load("walls: [[0, 0, 1, 0, 1], [0, 0, 1, 0, 22]]").size(), 2U);
}

TEST_F(WallFileTest, NeedsFiveNumbersForEach) {
  EXPECT_THAT(error_of("walls:\n  - [0, 0, 1, 0, 1]\n  - [0, 0, 1, 0]\n"), HasSubstr("five"));
  EXPECT_THAT(error_of("walls:\n  - [0, 0, 1, 0, 1]\n  - [0, 0, 1, 0]\n"),
              HasSubstr("room.walls.yaml:3"));
  for (const char* entry : {"[0, 0, 1, x, 1]", "[0, 0, 1, .nan, 1]", "[0, 0, 1, .inf, 1]",
                            "[0, 0, 1, [1], 1]", "[0, 0, 1, 0, 1, 2]", "3"}) {
    EXPECT_THAT(error_of("walls: [" + std::string(entry) + "]"), HasSubstr("five finite numbers"))
        << entry;
  }
}

TEST_F(WallFileTest, RefusesALossOutsideItsRange) {
  EXPECT_EQ(load("walls: [[0, 0, 1, 0, 0], [0, 0, 1, 0, 100]]").size(), 2U);
  EXPECT_THAT(error_of("walls: [[0, 0, 1, 0, -1]]"), HasSubstr("-1 is outside [0, 100]"));
  EXPECT_THAT(error_of("walls: [[0, 0, 1, 0, 100.5]]"), HasSubstr("100.5 is outside [0, 100]"));
}

TEST_F(WallFileTest, MustHoldAList) {
  EXPECT_TRUE(load("walls: []").empty());
  EXPECT_THROW((void)load_walls(folder_.path("none.yaml")), ConfigError);
  for (const char* text : {"fences: []", "walls: 3", "[1, 2]"}) {
    EXPECT_THAT(error_of(text), HasSubstr("walls: the file must hold a list")) << text;
  }
}

}  // namespace
}  // namespace tocsin::geometry
