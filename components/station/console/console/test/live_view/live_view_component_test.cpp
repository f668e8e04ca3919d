// SPDX-License-Identifier: Apache-2.0
#include "live_view/live_view_component.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

class LiveViewTest : public ::testing::Test {
 protected:
  LiveViewTest() { bus_.add(sut_); }
  SimBus bus_;
  Context context_{bus_, "live_view", Role::gcs};
  LiveViewComponent sut_{context_, {}};
};

TEST_F(LiveViewTest, KeepsWhatItHeard) {
  geometry_msgs::msg::PoseWithCovarianceStamped location;
  location.pose().pose().position().x(2);
  bus_.publish<topic::Location>(location);
  bus_.run_for(seconds(3));
  const ViewState state = sut_.state(bus_.now());
  ASSERT_TRUE(state.location.has_value());
  EXPECT_DOUBLE_EQ(state.location->value.x_m, 2.0);
  EXPECT_EQ(bus_.now() - state.location->at, seconds(3));
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

TEST_F(LiveViewTest, KnowsTheRoomOnTheDiskFromTheContainersOfItsHost) {
  EXPECT_FALSE(sut_.state(bus_.now()).disk);
  diagnostic_msgs::msg::DiagnosticArray health;
  health.status().resize(2);
  health.status()[1].values().resize(1);
  health.status()[1].values()[0].key("disk_free_mib");
  health.status()[1].values()[0].value("0.3");
  bus_.publish<topic::Diagnostics>(health);
  bus_.run_for(seconds(0.1));
  ASSERT_TRUE(sut_.state(bus_.now()).disk);
  EXPECT_TRUE(sut_.state(bus_.now()).disk->value.is_full());
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

tocsin_msgs::msg::TrafficReport report_of(const std::string& topic) {
  tocsin_msgs::msg::TrafficReport report;
  report.role("uxv");
  report.topics().resize(1);
  report.topics()[0].topic(topic);
  report.topics()[0].sent(58);
  return report;
}

TEST_F(LiveViewTest, AStateOnChangeHoldsWhileItsWriterTellsThatItLives) {
  tocsin_msgs::msg::SafetyStatus status;
  status.emergency_stop(true);
  bus_.publish<topic::SafetyStatus>(status);
  bus_.run_for(seconds(60));
  bus_.publish<topic::TrafficReport>(report_of("camera/image_raw/compressed"));
  bus_.run_for(seconds(1));
  EXPECT_EQ(bus_.now() - sut_.state(bus_.now()).safety->at, seconds(61));
  bus_.publish<topic::TrafficReport>(report_of("safety_status"));
  bus_.run_for(seconds(1));
  EXPECT_EQ(bus_.now() - sut_.state(bus_.now()).safety->at, seconds(1));
}

template <class Message>
auto set_role(Message& message, int) -> decltype(message.role(std::string()), void()) {
  message.role("uxv");
}
template <class Message>
void set_role(Message&, ...) {}

/// A report of every topic, then a sample of each.
template <class... Topics>
void publish_all(SimBus& bus, topic::List<Topics...>) {
  for (const char* name : {Topics::info.name...}) {
    bus.publish<topic::TrafficReport>(report_of(name));
  }
  bus.run_for(seconds(0.1));
  const auto publish = [&bus](auto message, auto topic) {
    set_role(message, 0);
    bus.publish<decltype(topic)>(std::move(message));
  };
  (publish(typename Topics::Message{}, Topics{}), ...);
  bus.run_for(seconds(0.1));
}

TEST_F(LiveViewTest, CountsEveryTopicThatTheVehicleSends) {
  publish_all(
      bus_,
      topic::List<topic::Location, topic::NetworkQuality, topic::NavigationStatus,
                  topic::BatteryState, topic::MemoryUsage, topic::CpuLoad, topic::CpuTemperature,
                  topic::CameraImage, topic::SafetyStatus, topic::DockingStatus, topic::Heartbeat,
                  topic::TransmissionState, topic::TrafficReport>{});
  const auto rows = sut_.state(bus_.now()).traffic;
  EXPECT_EQ(rows.size(), 13U);
  for (const TrafficRow& row : rows) {
    EXPECT_EQ(row.counting, Counting::counted) << row.topic;
    EXPECT_GT(row.received, 0U) << row.topic;
  }
}

TEST(LiveView, RefusesLimitsThatContradictEachOther) {
  SimBus bus;
  Context context{bus, "live_view", Role::gcs};
  LiveViewComponent::Params params;
  params.limits = {10, 5};
  EXPECT_THROW(LiveViewComponent(context, params), ConfigError);
}

}  // namespace
}  // namespace tocsin
