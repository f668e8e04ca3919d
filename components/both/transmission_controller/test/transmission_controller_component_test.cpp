// SPDX-License-Identifier: Apache-2.0
#include "transmission_controller/transmission_controller_component.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

tocsin_msgs::msg::NetworkQuality quality(float per_percent, float signal_dbm, float percent) {
  tocsin_msgs::msg::NetworkQuality message;
  message.per_percent(per_percent);
  message.signal_dbm(signal_dbm);
  message.quality_percent(percent);
  return message;
}

class TransmissionControllerComponentTest : public ::testing::Test {
 protected:
  TransmissionControllerComponentTest() { bus_.add(sut_); }
  SimBus bus_;
  Context context_{bus_, "transmission_controller", Role::uxv};
  static TransmissionControllerComponent::Params tocp_dsp() {
    TransmissionControllerComponent::Params params;
    params.controller.policy.policy = decision::PolicyKind::tocp_dsp;
    return params;
  }
  TransmissionControllerComponent sut_{context_, tocp_dsp()};
  SimReader<topic::TransmissionState> states_{bus_};
  SimReader<topic::Heartbeat> beats_{bus_};
};

TEST_F(TransmissionControllerComponentTest, PublishesEvidenceForEverySample) {
  bus_.publish<topic::NetworkQuality>(quality(0, -45, 100));
  bus_.run_for(seconds(1));
  const auto states = states_.take();
  ASSERT_EQ(states.size(), 1U);
  EXPECT_TRUE(states[0].active());
  EXPECT_EQ(states[0].role(), "uxv");
  EXPECT_EQ(states[0].policy(), "tocp_dsp");
  EXPECT_FLOAT_EQ(states[0].qni(), 100.0F);
  EXPECT_TRUE(std::isnan(states[0].deadline_s()));
}

TEST_F(TransmissionControllerComponentTest, AnAlarmCarriesReasonStatisticAndDeadline) {
  bus_.publish<topic::NetworkQuality>(quality(100, -99, 0));
  bus_.run_for(Duration::zero());
  const auto states = states_.take();
  ASSERT_EQ(states.size(), 1U);
  EXPECT_FALSE(states[0].active());
  EXPECT_EQ(states[0].reason(), "cusum_alarm");
  EXPECT_GE(states[0].statistic(), states[0].threshold());
  EXPECT_FLOAT_EQ(states[0].deadline_s(), 180.0F);
  EXPECT_EQ(states[0].decision(), 1U);
}

TEST_F(TransmissionControllerComponentTest, HardwareThatTellsNothingLeavesPerAlone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  bus_.publish<topic::NetworkQuality>(quality(25, nan, nan));
  bus_.run_for(Duration::zero());
  EXPECT_FLOAT_EQ(states_.take().at(0).qni(), 75.0F);
}

/// Drives along x at 0.5 m/s, from where the link is lost to x = 5, where it is good.
class ForesightComponentTest : public ::testing::Test {
 protected:
  ForesightComponentTest() {
    TransmissionControllerComponent::Params params;
    params.controller.policy.policy = decision::PolicyKind::foresight;
    sut_.emplace(context_, params);
    bus_.add(*sut_);
    topic::Plan::Message plan;
    for (const double x_m : {0.0, 20.0}) {
      geometry_msgs::msg::PoseStamped pose;
      pose.pose().position().x(x_m);
      plan.poses().push_back(pose);
    }
    bus_.publish<topic::Plan>(plan);
  }
  void tell_risk() {
    topic::LinkRisk::Message risk;
    risk.info().resolution(1);
    risk.info().width(20);
    risk.info().height(1);
    risk.info().origin().orientation().w(1);
    for (int x = 0; x < 20; ++x) risk.data().push_back(x < 5 ? 95 : 2);
    bus_.publish<topic::LinkRisk>(risk);
  }
  tocsin_msgs::msg::TransmissionState drive(double x_m, const tocsin_msgs::msg::NetworkQuality& q) {
    topic::Location::Message location;
    location.pose().pose().position().x(x_m);
    bus_.publish<topic::Location>(location);
    bus_.publish<topic::NetworkQuality>(q);
    bus_.run_for(seconds(1));
    return states_.take().at(0);
  }
  SimBus bus_;
  Context context_{bus_, "transmission_controller", Role::uxv};
  std::optional<TransmissionControllerComponent> sut_;
  SimReader<topic::TransmissionState> states_{bus_};
  const tocsin_msgs::msg::NetworkQuality bad_ = quality(100, -95, 10);
  const tocsin_msgs::msg::NetworkQuality good_ = quality(0, -50, 90);
};

TEST_F(ForesightComponentTest, WaitsForTheGoodPlaceOnItsPlanAndTellsWhatItForesaw) {
  tell_risk();
  const auto waits = drive(1, bad_);
  EXPECT_FALSE(waits.active());
  EXPECT_EQ(waits.reason(), "better_ahead");
  ASSERT_EQ(waits.outlook().size(), decision::Outlook::most);
  EXPECT_EQ(waits.outlook()[0], 95);
  EXPECT_EQ(waits.outlook()[8], 2);
  EXPECT_FALSE(drive(2, bad_).active());
  const auto sends = drive(5.5, good_);
  EXPECT_TRUE(sends.active());
  EXPECT_EQ(sends.reason(), "good_enough");
}

TEST_F(ForesightComponentTest, NeverPausesWithoutAMapOfTheLink) {
  for (int i = 0; i < 20; ++i) {
    const auto state = drive(0.5 * i, bad_);
    EXPECT_TRUE(state.active());
    EXPECT_TRUE(state.outlook().empty());
  }
}

TEST_F(TransmissionControllerComponentTest, DoesNotPauseUnlessAPolicyIsChosen) {
  SimBus bus;
  Context context{bus, "transmission_controller", Role::uxv};
  TransmissionControllerComponent sut{context, {}};
  bus.add(sut);
  SimReader<topic::TransmissionState> states{bus};
  bus.publish<topic::NetworkQuality>(quality(100, -99, 0));
  bus.run_for(Duration::zero());
  const auto state = states.take().at(0);
  EXPECT_TRUE(state.active());
  EXPECT_EQ(state.policy(), "none");
}

TEST_F(TransmissionControllerComponentTest, BeatsOnceASecondEvenWithoutMeasurements) {
  beats_.take();
  bus_.run_for(seconds(10.5));  // the first comes at its phase
  const auto beats = beats_.take();
  ASSERT_GE(beats.size(), 10U);
  EXPECT_EQ(beats[9].count() - beats[0].count(), 9U);
  for (std::size_t i = 1; i < beats.size(); ++i) {
    EXPECT_EQ(beats[i].stamp().sec() - beats[i - 1].stamp().sec(), 1);
    EXPECT_EQ(beats[i].stamp().nanosec(), beats[0].stamp().nanosec());
  }
  EXPECT_EQ(beats[0].role(), "uxv");
}

}  // namespace
}  // namespace tocsin
