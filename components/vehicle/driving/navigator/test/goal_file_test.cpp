// SPDX-License-Identifier: Apache-2.0
#include "navigator/goal_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

class GoalFileTest : public ::testing::Test {
 protected:
  static Goal goal(std::size_t ahead) {
    Goal goal{0xFFFFFFFF12345678ULL,
              4294967297ULL,
              {{-123.4567, 0.0004, 3.1}, 3600},
              0.15,
              Time{} + seconds(1e6),
              {}};
    for (std::size_t i = 0; i < ahead; ++i) {
      goal.ahead.push_back({{-99999.123, 99999.5, -3.1}, static_cast<double>(i)});
    }
    return goal;
  }
  TemporaryFolder folder_;
  std::string path_ = folder_.path("navigator.goal");
  GoalFile sut_{path_};
};

TEST_F(GoalFileTest, GivesBackWhatAnEarlierProcessHasKept) {
  ASSERT_TRUE(sut_.save(goal(3)));
  const auto back = GoalFile(path_).load();
  ASSERT_TRUE(back);
  EXPECT_EQ(back->mission, goal(3).mission);
  EXPECT_EQ(back->id, goal(3).id);
  EXPECT_NEAR(back->pose.x_m, -123.4567, 1e-3);
  EXPECT_NEAR(back->pose.heading_rad, 3.1, 1e-3);
  EXPECT_EQ(back->pose.send_s, 3600);
  EXPECT_EQ(back->tolerance_m, 0.15);
  EXPECT_EQ(back->expires, goal(3).expires);
  ASSERT_EQ(back->ahead.size(), 3U);
  EXPECT_EQ(back->ahead[2].send_s, 2);
}

TEST_F(GoalFileTest, KeepsTheFirstOfMany) {
  ASSERT_TRUE(sut_.save(goal(Goal::most_ahead)));
  EXPECT_EQ(GoalFile(path_).load()->ahead.size(), GoalFile::most_ahead);
}

TEST_F(GoalFileTest, KnowsNothingOfAnotherLaunchOrADamagedFile) {
  EXPECT_FALSE(sut_.load());
  const std::string parent = std::to_string(::getppid());
  for (const std::string& text :
       {std::string("1 7 5 0.15 1000 0 1 2 0 0"), parent + " 7 5 0.15 1000 2 1 2 0 0",
        parent + " 7 5 0.15 1000 9 1 2 0 0", parent + " 7", std::string("nonsense")}) {
    StateFile file(path_);
    ASSERT_TRUE(file.save(text));
    EXPECT_FALSE(GoalFile(path_).load()) << text;
  }
  StateFile file(path_);
  ASSERT_TRUE(file.save(parent + " 7 5 0.15 1000 0 1 2 0 0"));
  EXPECT_TRUE(GoalFile(path_).load());
}

TEST_F(GoalFileTest, WhatIsClearedIsGone) {
  ASSERT_TRUE(sut_.save(goal(1)));
  ASSERT_TRUE(sut_.clear());
  EXPECT_FALSE(GoalFile(path_).load());
  ASSERT_TRUE(sut_.save(goal(1)));
  EXPECT_TRUE(GoalFile(path_).load());
}

TEST_F(GoalFileTest, WithoutAPathItKeepsNothing) {
  GoalFile sut("");
  EXPECT_TRUE(sut.save(goal(0)));
  EXPECT_FALSE(sut.load());
}

}  // namespace
}  // namespace tocsin
