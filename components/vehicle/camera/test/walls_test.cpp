// SPDX-License-Identifier: Apache-2.0
#include "camera/walls.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "foundation/error.hpp"

namespace tocsin::camera {
namespace {

using ::testing::HasSubstr;

class WallsTest : public ::testing::Test {
 protected:
  WallsTest() : path_("walls_test_" + std::to_string(getpid()) + ".yaml") {}
  ~WallsTest() override { std::remove(path_.c_str()); }
  std::vector<Wall> load(const std::string& yaml) const {
    std::ofstream(path_) << yaml;
    return load_walls(path_);
  }
  std::string error_of(const std::string& yaml) const {
    try {
      (void)load(yaml);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  std::string path_;
};

TEST_F(WallsTest, AreSegmentsInTheOrderOfTheFile) {
  const auto sut = load("walls:\n  - [1, 2, 3, 4, 6.9]\n  - [-1.5, 0, 0, 0, 3.4]\n");
  ASSERT_EQ(sut.size(), 2U);
  EXPECT_EQ(sut[0].x1_m, 1);
  EXPECT_EQ(sut[0].y1_m, 2);
  EXPECT_EQ(sut[0].x2_m, 3);
  EXPECT_EQ(sut[0].y2_m, 4);
  EXPECT_EQ(sut[1].x1_m, -1.5);
}

TEST_F(WallsTest, WithoutLossAreFurniture) {
  const auto sut = load("walls: [[0, 0, 1, 0, 0.0], [0, 0, 1, 0, 0.1]]");
  EXPECT_TRUE(sut[0].is_furniture);
  EXPECT_FALSE(sut[1].is_furniture);
}

TEST_F(WallsTest, NeedFiveNumbersEach) {
  EXPECT_THAT(error_of("walls:\n  - [0, 0, 1, 0, 1]\n  - [0, 0, 1, 0]\n"),
              HasSubstr("a wall is five numbers"));
  EXPECT_THAT(error_of("walls:\n  - [0, 0, 1, 0, 1]\n  - [0, 0, 1, 0]\n"), HasSubstr(path_ + ":3"));
  EXPECT_THAT(error_of("walls: [[0, 0, 1, x, 1]]"), HasSubstr("a wall is five numbers"));
  EXPECT_THAT(error_of("walls: [[0, 0, 1, .nan, 1]]"), HasSubstr("a wall is five numbers"));
  EXPECT_THAT(error_of("walls: [[0, 0, 1, [1], 1]]"), HasSubstr("a wall is five numbers"));
  EXPECT_THAT(error_of("walls: [3]"), HasSubstr("a wall is five numbers"));
}

TEST_F(WallsTest, HaveNoNegativeLoss) {
  EXPECT_THAT(error_of("walls: [[0, 0, 1, 0, -1]]"), HasSubstr("not negative"));
}

TEST_F(WallsTest, MustBeAList) {
  EXPECT_THAT(error_of("fences: []"), HasSubstr("must hold a list `walls`"));
  EXPECT_THAT(error_of("walls: []"), HasSubstr("must hold a list `walls`"));
  EXPECT_THAT(error_of("walls: 3"), HasSubstr("must hold a list `walls`"));
  EXPECT_THAT(error_of("[1, 2]"), HasSubstr("must hold a list `walls`"));
}

TEST(Walls, AreAnErrorWhenTheFileIsMissing) {
  EXPECT_THROW((void)load_walls("no_such_file.yaml"), ConfigError);
}

}  // namespace
}  // namespace tocsin::camera
