// SPDX-License-Identifier: Apache-2.0
/// When the navigator stands so that what is stored crosses the link.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "vehicle.hpp"

namespace tocsin {
namespace {

using navigation::LinkRisk;

/// A floor of 8 m x 4 m on which the link is lost from x = 4 on; a store of which samples cross
/// while the vehicle stands.
class NavigatorSendsTest : public ::testing::Test {
 protected:
  static Navigator::Params with(double send_stop_s) {
    Navigator::Params params;
    params.send_stop.send_stop_s = send_stop_s;
    return params;
  }
  void SetUp() override {
    std::vector<std::int8_t> percent;
    for (int cell = 0; cell < 8 * 4; ++cell) {
      percent.push_back(static_cast<std::int8_t>(cell % 8 < 4 ? 5 : 95));
    }
    vehicle_.sut.set_link(LinkRisk({8, 4, 1, {0, 0}}, percent));
  }
  /// Drives for so long; what it does is told with each second's report of the store.
  Navigator::Output run(int s) {
    Navigator::Output output;
    for (int i = 0; i < s; ++i) {
      const bool sends = std::string(output.status.reason) == "sending";
      const std::uint64_t crossed = sends ? std::min<std::uint64_t>(waiting_, 20) : 0;
      waiting_ -= crossed;
      crossed_ += crossed;
      vehicle_.sut.on_store({waiting_, crossed_}, vehicle_.now);
      output = vehicle_.run(1);
    }
    return output;
  }

  Vehicle vehicle_{with(60), 0};
  std::uint64_t waiting_ = 0;
  std::uint64_t crossed_ = 0;
};

TEST_F(NavigatorSendsTest, StandsBeforeTheLinkIsLostUntilWhatIsStoredHasCrossed) {
  waiting_ = 100;
  (void)vehicle_.send(1, {7, 1, 0});
  const auto output = run(4);
  EXPECT_EQ(output.status.state, Navigator::State::held);
  EXPECT_STREQ(output.status.reason, "sending");
  EXPECT_EQ(vehicle_.driven.linear_mps, 0);
  EXPECT_LT(vehicle_.pose.x_m, 4);
  EXPECT_EQ(run(20).status.state, Navigator::State::reached);
}

TEST_F(NavigatorSendsTest, DrivesPastWhenNothingWaits) {
  (void)vehicle_.send(1, {7, 1, 0});
  EXPECT_EQ(run(4).status.state, Navigator::State::driving);
}

TEST_F(NavigatorSendsTest, AGoalThatSaysSoIsReachedWhenWhatIsStoredHasCrossed) {
  Goal goal{7, 1, {{2, 1, 0}, 30}, 0.15, vehicle_.now + seconds(1000), {{{3, 1, 0}}}};
  (void)vehicle_.sut.on_goal(goal, vehicle_.now);
  waiting_ = 200;
  const auto output = run(8);
  EXPECT_EQ(output.status.state, Navigator::State::held);
  EXPECT_STREQ(output.status.reason, "sending");
  EXPECT_EQ(output.status.goal_id, 1U);
  EXPECT_LT(vehicle_.distance_to({2, 1, 0}), 0.15);
  EXPECT_EQ(run(15).status.goal_id, 2U);
}

TEST_F(NavigatorSendsTest, TheLastGoalIsReachedWhenItsTimeIsOver) {
  Goal goal{7, 1, {{2, 1, 0}, 5}, 0.15, vehicle_.now + seconds(1000), {}};
  (void)vehicle_.sut.on_goal(goal, vehicle_.now);
  waiting_ = 10000;
  EXPECT_STREQ(run(6).status.reason, "sending");
  EXPECT_EQ(run(6).status.state, Navigator::State::reached);
}

TEST_F(NavigatorSendsTest, AnEmergencyStopComesFirst) {
  waiting_ = 100;
  (void)vehicle_.send(1, {7, 1, 0});
  (void)run(4);
  vehicle_.sut.on_emergency_stop(true);
  EXPECT_STREQ(run(1).status.reason, "emergency_stop");
}

}  // namespace
}  // namespace tocsin
