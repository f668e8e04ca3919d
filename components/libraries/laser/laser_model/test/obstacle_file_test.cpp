// SPDX-License-Identifier: Apache-2.0
#include "laser_model/obstacle_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::laser {
namespace {

class ObstacleFileTest : public ::testing::Test {
 protected:
  Obstacles load(const std::string& text) {
    const std::string path = folder_.path("a.obstacles.yaml");
    std::ofstream(path) << text;
    return load_obstacles(path);
  }
  std::string error_of(const std::string& text) {
    try {
      (void)load(text);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  TemporaryFolder folder_;
};

TEST_F(ObstacleFileTest, HoldsBoxesDiscsAndWalkers) {
  const Obstacles sut = load(
      "boxes: [[1, 2, 0.4, 0.3, 0.5]]\ndiscs: [[3, 4, 0.02]]\n"
      "walkers:\n  - {way: [[0, 0], [1, 0]], speed_mps: 1.2, pause_s: 3, radius_m: 0.25}\n"
      "  - way: [[0, 0], [0, 2], [2, 2]]\n");
  ASSERT_EQ(sut.boxes.size(), 1U);
  EXPECT_EQ(sut.boxes[0].middle.heading_rad, 0.5);
  EXPECT_EQ(sut.boxes[0].length_m, 0.4);
  ASSERT_EQ(sut.discs.size(), 1U);
  EXPECT_EQ(sut.discs[0].radius_m, 0.02);
  ASSERT_EQ(sut.walkers.size(), 2U);
  EXPECT_EQ(sut.walkers[0].pause_s, 3);
  EXPECT_EQ(sut.walkers[1].way.size(), 3U);
  EXPECT_EQ(sut.walkers[1].speed_mps, 0.8);
  EXPECT_TRUE(load("discs: []").boxes.empty());
}

TEST_F(ObstacleFileTest, RefusesEachBadValueWithItsPlace) {
  using ::testing::AllOf;
  using ::testing::HasSubstr;
  const std::vector<std::pair<const char*, const char*>> rows{
      {"[1]", "must hold boxes, discs, walkers"},
      {"crates: []", "'crates' is not one of: boxes, discs, walkers"},
      {"boxes: 3", "boxes must be a list"},
      {"boxes: [[1, 2, 3]]", "a box is [x, y, length, width, heading_rad]"},
      {"boxes: [[1, 2, 0.3, zero, 0]]", "a box is"},
      {"boxes: [[.nan, 2, 0.3, 0.3, 0]]", "a box is"},
      {"boxes: [[1, 2, 0.3, 0.001, 0]]", "a size of 0.001 m is outside [0.005, 100]"},
      {"discs: [[1, 2, -1]]", "a size of -1 m"},
      {"walkers: [7]", "a walker is {way:"},
      {"walkers: [{way: [[0, 0]]}]", "a walker is {way:"},
      {"walkers: [{way: [[0, 0], [0, 0]]}]", "must be longer than 0.01 m"},
      {"walkers: [{way: [[0, 0], [1, 0]], speed: 1}]", "'speed' is not one of: way, speed_mps"},
      {"walkers: [{way: [[0, 0], [1, 0]], speed_mps: 0}]", "speed_mps: 0 is outside [0.05, 5]"},
      {"walkers: [{way: [[0, 0], [1, 0]], radius_m: 2}]", "radius_m: 2 is outside [0.05, 1]"}};
  for (const auto& [text, what] : rows) {
    EXPECT_THAT(error_of(text), AllOf(HasSubstr(what), HasSubstr("a.obstacles.yaml"))) << text;
  }
}

}  // namespace
}  // namespace tocsin::laser
