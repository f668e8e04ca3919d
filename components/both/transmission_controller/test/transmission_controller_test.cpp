// SPDX-License-Identifier: Apache-2.0
#include "transmission_controller/transmission_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

using decision::Reason;
using decision::State;

const Time t0{std::chrono::hours(1)};
const decision::QniInput good{0.0, -45.0, 70.0};
const decision::QniInput dead{100.0, -99.0, 0.0};

TransmissionController make(bool silence_is_poor = false) {
  TransmissionController::Params params;
  params.policy.policy = decision::PolicyKind::tocp_dsp;
  params.silence_is_poor = silence_is_poor;
  return TransmissionController(params);
}

TEST(TransmissionController, IsActiveOnAGoodLink) {
  TransmissionController sut = make();
  const TransmissionDecision decision = sut.on_quality(good, t0);
  EXPECT_EQ(decision.evidence.state, State::active);
  EXPECT_DOUBLE_EQ(decision.evidence.sample, 100.0);
  EXPECT_EQ(decision.changes, 0U);
}

TEST(TransmissionController, PausesOnADeadLink) {
  TransmissionController sut = make();
  const TransmissionDecision decision = sut.on_quality(dead, t0);
  EXPECT_EQ(decision.evidence.state, State::passive);
  EXPECT_EQ(decision.evidence.reason, Reason::cusum_alarm);
  EXPECT_EQ(decision.changes, 1U);
}

TEST(TransmissionController, DecidesByTheIndexAsItIsPublished) {
  TransmissionController::Params params;
  params.policy.policy = decision::PolicyKind::threshold;
  params.policy.pause_below_qni = 40;
  params.quality.weight_per = 1;
  params.quality.weight_signal = params.quality.weight_quality = 0;
  TransmissionController sut(params);
  const auto decision = sut.on_quality({60.0000001, std::nullopt, std::nullopt}, t0);
  EXPECT_EQ(decision.evidence.sample, 40.0);  // as a float; a recording has no more digits
  EXPECT_EQ(decision.evidence.state, State::active);
  EXPECT_EQ(sut.on_quality({60.0001, std::nullopt, std::nullopt}, t0 + seconds(1)).evidence.state,
            State::passive);
}

TEST(TransmissionController, ForcesTheResumeAtTheDeadlineWithoutSamples) {
  TransmissionController::Params params;
  params.policy.policy = decision::PolicyKind::tocp_dsp;
  params.quality_timeout_s = 600;
  TransmissionController sut(params);
  const auto pause = sut.on_quality(dead, t0).evidence;
  ASSERT_EQ(pause.state, State::passive);
  EXPECT_EQ(sut.deadline(), *pause.deadline);
  EXPECT_FALSE(sut.on_time(sut.deadline() - Duration{1}));
  const auto resumed = sut.on_time(sut.deadline());
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->evidence.state, State::active);
  EXPECT_EQ(resumed->evidence.reason, Reason::forced_resume_time);
  EXPECT_EQ(resumed->changes, 2U);
}

TEST(TransmissionController, SilenceOfTheReportIsADeadLinkForTheGroundStation) {
  TransmissionController sut = make(true);
  EXPECT_EQ(sut.on_quality(good, t0).evidence.state, State::active);
  EXPECT_FALSE(sut.on_time(t0 + seconds(3) - Duration{1}));
  const auto decision = sut.on_time(t0 + seconds(3));
  ASSERT_TRUE(decision);
  EXPECT_EQ(decision->evidence.sample, 0.0);
  EXPECT_EQ(decision->evidence.state, State::passive);
  EXPECT_DOUBLE_EQ(decision->quality_age_s, 3.0);
}

TEST(TransmissionController, SilenceOfTheMonitorIsUnknownForTheVehicle) {
  TransmissionController sut = make(false);
  EXPECT_EQ(sut.on_quality(good, t0).evidence.state, State::active);
  const auto decision = sut.on_time(t0 + seconds(3));
  ASSERT_TRUE(decision);
  EXPECT_TRUE(std::isnan(decision->evidence.sample));
  EXPECT_EQ(decision->evidence.state, State::active);
}

TEST(TransmissionController, SilenceBeforeTheFirstReportSaysNothing) {
  TransmissionController sut = make(true);
  EXPECT_EQ(sut.deadline(), never);
  EXPECT_FALSE(sut.on_time(t0 + seconds(100)));
}

TEST(TransmissionController, SilenceIsRepeatedOnceEachTimeout) {
  TransmissionController sut = make(true);
  (void)sut.on_quality(good, t0);
  EXPECT_TRUE(sut.on_time(t0 + seconds(3)));
  EXPECT_FALSE(sut.on_time(t0 + seconds(3)));
  EXPECT_EQ(sut.deadline(), t0 + seconds(6));
}

TEST(TransmissionController, RefusesWeightsThatDoNotSumToOne) {
  TransmissionController::Params params;
  params.quality.weight_per = 0.5;
  EXPECT_THROW(TransmissionController{params}, ConfigError);
}

TEST(TransmissionController, PolicyNoneNeverPauses) {
  TransmissionController::Params params;
  params.policy.policy = decision::PolicyKind::none;
  TransmissionController sut(params);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(sut.on_quality(dead, t0 + seconds(i)).evidence.state, State::active);
  }
}

}  // namespace
}  // namespace tocsin
