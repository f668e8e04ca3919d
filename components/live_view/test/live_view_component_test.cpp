// SPDX-License-Identifier: Apache-2.0
#include "live_view/live_view_component.hpp"

#include <gtest/gtest.h>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class LiveViewTest : public ::testing::Test {
 protected:
  LiveViewTest() { bus_.add(sut_); }
  SimBus bus_;
  Context context_{bus_, "live_view", "gcs", ""};
  LiveViewComponent sut_{context_, {}};
};

TEST_F(LiveViewTest, KeepsWhatItHeard) {
  geometry_msgs::msg::PoseWithCovarianceStamped location;
  location.pose().pose().position().x(2);
  bus_.publish<topic::Location>(location);
  bus_.run_for(seconds(3));
  const ViewState state = sut_.state(bus_.now());
  EXPECT_TRUE(state.located);
  EXPECT_DOUBLE_EQ(state.x_m, 2.0);
  EXPECT_DOUBLE_EQ(state.location_age_s, 3.0);
}

TEST_F(LiveViewTest, TellsTheTwoRolesApart) {
  tocsin_msgs::msg::TransmissionState decision;
  decision.role("gcs");
  decision.active(true);
  bus_.publish<topic::TransmissionState>(decision);
  bus_.run_for(seconds(0.1));
  EXPECT_FALSE(sut_.state(bus_.now()).uxv.has_value());
  ASSERT_TRUE(sut_.state(bus_.now()).gcs.has_value());
}

TEST_F(LiveViewTest, IgnoresTheReportsOfItsOwnSide) {
  tocsin_msgs::msg::TrafficReport report;
  report.role("gcs");
  report.topics().resize(1);
  report.topics()[0].topic("goal");
  bus_.publish<topic::TrafficReport>(report);
  bus_.run_for(seconds(0.1));
  EXPECT_TRUE(sut_.state(bus_.now()).traffic.empty());
  report.role("uxv");
  bus_.publish<topic::TrafficReport>(report);
  bus_.run_for(seconds(0.1));
  EXPECT_EQ(sut_.state(bus_.now()).traffic.size(), 1U);
}

TEST_F(LiveViewTest, CountsTopicsWhoseContentItDoesNotShow) {
  tocsin_msgs::msg::TrafficReport report;
  report.role("uxv");
  report.topics().resize(1);
  report.topics()[0].topic("battery_state");
  bus_.publish<topic::TrafficReport>(report);
  bus_.publish<topic::BatteryState>({});
  bus_.run_for(seconds(0.1));
  EXPECT_GT(sut_.state(bus_.now()).traffic.at(0).rate_hz, 0.0);
}

}  // namespace
}  // namespace tocsin
