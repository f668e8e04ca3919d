// SPDX-License-Identifier: Apache-2.0
#include "files.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "foundation/error.hpp"
#include "options.hpp"

namespace tocsin::kobuki {
namespace {

std::string write(const std::string& text) {
  const std::string path = ::testing::TempDir() + "kobuki_files_test.yaml";
  std::ofstream(path) << text;
  return path;
}

TEST(Memory, SurvivesAFile) {
  const std::string path = ::testing::TempDir() + "kobuki_memory";
  ASSERT_TRUE(save_memory(path, {{1.25, -2, 0.3}, 70000, -5.5, 0.1, 12.5, 0.75}));
  const auto got = load_memory(path);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->pose.x_m, 1.25);
  EXPECT_EQ(got->right_ticks, -5.5);
  EXPECT_EQ(got->charge, 0.75);
  std::remove(path.c_str());
  EXPECT_FALSE(load_memory(path));
  EXPECT_THROW((void)load_memory(write("1 2 three")), ConfigError);
  EXPECT_FALSE(save_memory("/nonexistent/state", {}));
}

TEST(Options, ReadTheCommandLine) {
  const char* argv[]{"kobuki_simulator", "--link", "/tmp/x", "--start", "1,2,3", "--seed", "9"};
  int exit_code = -1;
  const auto got = parse_options(7, argv, exit_code);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->link, "/tmp/x");
  EXPECT_EQ(got->start.heading_rad, 3);
  EXPECT_EQ(got->seed, 9U);
}

std::string refusal_of(const std::vector<const char*>& words) {
  int exit_code = -1;
  try {
    (void)parse_options(static_cast<int>(words.size()), words.data(), exit_code);
    return "accepted";
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(Options, AMisspeltOneAndASeedBelowZeroAreRefused) {
  EXPECT_EQ(refusal_of({"kobuki_simulator", "--lnk", "/tmp/x"}),
            "--lnk: there is no such option; did you mean '--link'?");
  EXPECT_EQ(refusal_of({"kobuki_simulator", "--link", "/tmp/x", "--seed", "-1"}),
            "--seed: '-1' is not a whole number from 0 to 2147483647");
}

TEST(MakeModel, RefusesAStartInAWall) {
  Options options;
  options.walls = write("walls: [[0.1, -1, 0.1, 1, 3]]");
  EXPECT_THROW((void)make_model(options, make_room(options), Time{}), ConfigError);
  options.start.x_m = 1;
  EXPECT_EQ(make_model(options, make_room(options), Time{}).pose().x_m, 1);
}

TEST(MakeModel, StartsWhereAnEarlierRunEnded) {
  Options options;
  options.state = ::testing::TempDir() + "kobuki_earlier";
  ASSERT_TRUE(save_memory(options.state, {{7, 8, 0}, 0, 0, 0, 0, 1}));
  EXPECT_EQ(make_model(options, make_room(options), Time{}).pose().y_m, 8);
}

}  // namespace
}  // namespace tocsin::kobuki
