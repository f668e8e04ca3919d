// SPDX-License-Identifier: Apache-2.0
#include "navigator/localiser_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>

namespace tocsin {
namespace {

class LocaliserFileTest : public ::testing::Test {
 protected:
  ~LocaliserFileTest() override { std::remove(path_.c_str()); }
  void write(const std::string& text) const { ASSERT_TRUE(StateFile(path_).save(text)); }

  const std::string path_ = "localiser_file_test_" + std::to_string(::getpid());
  LocaliserFile sut_{path_};
};

TEST_F(LocaliserFileTest, GivesBackWhatItSaved) {
  ASSERT_TRUE(sut_.save({{0.1, -2, 3}, {4, 5, -0.6}}));
  const auto memory = sut_.load();
  ASSERT_TRUE(memory);
  EXPECT_EQ(memory->map_from_odom.x_m, 0.1);
  EXPECT_EQ(memory->map_from_odom.heading_rad, 3);
  EXPECT_EQ(memory->odom.heading_rad, -0.6);
}

TEST_F(LocaliserFileTest, IsEmptyWhenTheFileIsAbsentDamagedOrOfAnotherLaunch) {
  EXPECT_FALSE(sut_.load());
  const std::string parent = std::to_string(::getppid());
  write(parent + " 1 2 3 4 5 6\n");
  EXPECT_TRUE(sut_.load());
  for (const std::string& text : {parent + " 1 2 3 4 5\n", parent + " 1 2 x 4 5 6\n", std::string(),
                                  std::to_string(::getppid() + 1) + " 1 2 3 4 5 6\n"}) {
    write(text);
    EXPECT_FALSE(sut_.load()) << text;
  }
}

TEST_F(LocaliserFileTest, KeepsNothingWithoutAPathAndTellsOfOneThatIsNone) {
  EXPECT_TRUE(LocaliserFile("").save({}));
  EXPECT_FALSE(LocaliserFile("").load());
  EXPECT_FALSE(LocaliserFile("/nowhere/at/all").save({}));
}

}  // namespace
}  // namespace tocsin
