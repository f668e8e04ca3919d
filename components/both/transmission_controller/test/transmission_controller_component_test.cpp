// SPDX-License-Identifier: Apache-2.0
#include "transmission_controller/transmission_controller_component.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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
    params.controller.policy.policy = "tocp_dsp";
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

TEST_F(TransmissionControllerComponentTest, WeighsTheChannelWhenThatIndexIsChosen) {
  TransmissionControllerComponent::Params params;
  params.controller.quality.quality_index = "channel";
  params.controller.policy.policy = "tocp_dsp";
  params.controller.policy.detector = "focus";
  SimBus bus;
  Context context{bus, "transmission_controller", Role::uxv};
  TransmissionControllerComponent sut{context, params};
  bus.add(sut);
  SimReader<topic::TransmissionState> states{bus};
  auto message = quality(0, -45, 10);
  message.busy_percent(60);
  message.retry_percent(50);  // one retry for each frame, a third of retries_worst
  bus.publish<topic::NetworkQuality>(message);
  bus.run_for(Duration::zero());
  EXPECT_FLOAT_EQ(states.take().at(0).qni(), 40 + 30 + 0.3F * 40);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  message.busy_percent(nan);
  message.retry_percent(nan);
  bus.publish<topic::NetworkQuality>(message);
  bus.run_for(Duration::zero());
  EXPECT_FLOAT_EQ(states.take().at(0).qni(), 100);
  bus.publish<topic::NetworkQuality>(quality(100, -99, nan));
  bus.run_for(Duration::zero());
  EXPECT_EQ(states.take().at(0).reason(), "focus_alarm");
}

TEST_F(TransmissionControllerComponentTest, WeighsTheRoundTripTimeWhenTheJointIndexIsChosen) {
  TransmissionControllerComponent::Params params;
  params.controller.quality.quality_index = "joint";
  SimBus bus;
  Context context{bus, "transmission_controller", Role::uxv};
  TransmissionControllerComponent sut{context, params};
  bus.add(sut);
  SimReader<topic::TransmissionState> states{bus};
  auto message = quality(0, -70, 60);
  message.retry_percent(10);
  message.busy_percent(21);
  message.rtt_mean_ms(1.3F);
  bus.publish<topic::NetworkQuality>(message);
  bus.run_for(Duration::zero());
  const float quick = states.take().at(0).qni();
  message.rtt_mean_ms(200);
  bus.publish<topic::NetworkQuality>(message);
  bus.run_for(Duration::zero());
  EXPECT_LT(states.take().at(0).qni(), quick - 5);
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

std::string value_of(const diagnostic_msgs::msg::DiagnosticStatus& status, const char* key) {
  for (const auto& pair : status.values()) {
    if (pair.key() == key) return pair.value();
  }
  return "absent";
}

/// A controller with laws of that kind after half an hour on a link of QNI 70, samples once a
/// second, half of them 4 above and half of them 4 below; its last status, or "none".
diagnostic_msgs::msg::DiagnosticStatus status_after_half_an_hour(const char* laws) {
  TransmissionControllerComponent::Params params;
  params.controller.policy.policy = "tocp_reverse";
  params.controller.policy.laws = laws;
  params.controller.policy.learn_memory_samples = 300;
  SimBus bus;
  Context context{bus, "transmission_controller", Role::uxv};
  TransmissionControllerComponent sut{context, params};
  bus.add(sut);
  SimReader<topic::Diagnostics> reports{bus};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 1800; ++i) {
    bus.publish<topic::NetworkQuality>(quality(i % 4 < 2 ? 26.0F : 34.0F, nan, nan));
    bus.run_for(seconds(1));
  }
  diagnostic_msgs::msg::DiagnosticStatus last;
  last.name("none");
  for (const auto& report : reports.take()) last = report.status().at(0);
  return last;
}

TEST(LearnedLaws, AreProposedWithTheirEvidence) {
  const auto sut = status_after_half_an_hour("propose");
  EXPECT_EQ(sut.name(), "transmission_controller: laws");
  EXPECT_EQ(sut.level(), diagnostic_msgs::msg::DiagnosticStatus_Constants::OK);
  EXPECT_EQ(sut.message().rfind("proposes good_mean 70.", 0), 0U) << sut.message();
  EXPECT_EQ(value_of(sut, "configured_mean"), "81.57");
  EXPECT_EQ(value_of(sut, "in_force_mean"), "81.57");
  EXPECT_EQ(value_of(sut, "applied"), "0");
  EXPECT_LT(std::stod(value_of(sut, "evidence")), -3);
}

TEST(LearnedLaws, AreInForceWhenTheyAreApplied) {
  const auto sut = status_after_half_an_hour("apply");
  EXPECT_NEAR(std::stod(value_of(sut, "in_force_mean")), 70, 2.5);
  EXPECT_GT(std::stoi(value_of(sut, "applied")), 0);
}

TEST(LearnedLaws, AreNotToldWhenTheyAreFixed) {
  EXPECT_EQ(status_after_half_an_hour("fixed").name(), "none");
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
