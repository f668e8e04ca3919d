// SPDX-License-Identifier: Apache-2.0
#include "navigator/pose_goal.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

constexpr Time t0 = Time{std::chrono::hours(1)};
constexpr std::uint64_t mission = 7;

Navigator::Output doing(Navigator::State state, double speed_mps = 0, std::uint64_t its = mission) {
  Navigator::Output output;
  output.velocity.linear_mps = speed_mps;
  output.status.mission = its;
  output.status.state = state;
  return output;
}

class PoseGoalTest : public ::testing::Test {
 protected:
  PoseGoal sut_{mission, t0, t0 + seconds(60)};
};

TEST_F(PoseGoalTest, HasNotEndedWhileItIsDrivenTo) {
  EXPECT_EQ(sut_.end(doing(Navigator::State::driving, 0.3), t0), std::nullopt);
  EXPECT_EQ(sut_.end(doing(Navigator::State::blocked), t0), std::nullopt);
  EXPECT_EQ(sut_.end(doing(Navigator::State::held), t0 + seconds(59.9)), std::nullopt);
}

TEST_F(PoseGoalTest, IsCanceledWhenTheVehicleStandsUnlessItIsReached) {
  EXPECT_EQ(sut_.end(doing(Navigator::State::reached), t0), PoseGoalEnd::reached);
  sut_.cancel();
  EXPECT_EQ(sut_.end(doing(Navigator::State::held, 0.01), t0), std::nullopt);
  EXPECT_EQ(sut_.end(doing(Navigator::State::held), t0), PoseGoalEnd::canceled);
  EXPECT_EQ(sut_.end(doing(Navigator::State::reached), t0), PoseGoalEnd::reached);
}

TEST_F(PoseGoalTest, TimesOutWhenTheVehicleStandsAfterItsTime) {
  EXPECT_EQ(sut_.end(doing(Navigator::State::held, 0.2), t0 + seconds(60)), std::nullopt);
  EXPECT_EQ(sut_.end(doing(Navigator::State::held), t0 + seconds(60)), PoseGoalEnd::timed_out);
}

TEST_F(PoseGoalTest, IsSupersededByAnotherMissionWhateverItDoes) {
  EXPECT_EQ(sut_.end(doing(Navigator::State::reached, 0, 8), t0), PoseGoalEnd::superseded);
  EXPECT_EQ(sut_.end(doing(Navigator::State::driving, 0.3, 8), t0), PoseGoalEnd::superseded);
}

}  // namespace
}  // namespace tocsin
