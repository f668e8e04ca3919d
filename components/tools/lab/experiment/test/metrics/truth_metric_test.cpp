// SPDX-License-Identifier: Apache-2.0
// Each metric of pauses, truth, cost and mission, and each part of an observation, on runs that
// are short enough to compute it by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "metrics/hand.hpp"
#include "metrics/messages.hpp"

namespace tocsin::experiment {
namespace {

/// Poor from 30 to 50 s and from 60 to 90 s; silent from 35 to 56 s.
Hand half_found() {
  return Hand()
      .link({{0, 20}, {30, 5}, {50, 20}, {60, 5}, {90, 20}})
      .decides(0, true, 80)
      .decides(35, false, 30)
      .decides(56, true, 80);
}

TEST(TruthMetrics, ShareAndCountWhatWasPoor) {
  const auto sut = Hand().link({{0, 20}, {20, 9.9}, {50, 10}, {75, 5}, {99, 20}});
  EXPECT_NEAR(sut.value(Metric::poor_share), 30 + 24, 1e-9);
  EXPECT_EQ(sut.value(Metric::poor_intervals), 2);
}

TEST(TruthMetrics, LeaveOutWhatIsShorterThanTwoObservations) {
  EXPECT_EQ(Hand().link({{0, 20}, {20, 5}, {39, 20}}).value(Metric::poor_intervals), 0);
  EXPECT_EQ(Hand().link({{0, 20}, {20, 5}, {40, 20}}).value(Metric::poor_intervals), 1);
}

TEST(TruthMetrics, JoinIntervalsOverAGapShorterThanTwoObservations) {
  EXPECT_EQ(half_found().value(Metric::poor_intervals), 1) << "10 s between them";
  EXPECT_EQ(
      Hand().link({{0, 20}, {20, 5}, {40, 20}, {60, 5}, {80, 20}}).value(Metric::poor_intervals),
      2);
}

TEST(TruthMetrics, TellWhenAPolicyFoundItAndSpokeAgain) {
  const auto sut = Hand()
                       .link({{0, 20}, {20, 5}, {50, 20}})
                       .decides(0, true, 80)
                       .decides(26, false, 30)
                       .decides(58, true, 80);
  EXPECT_NEAR(sut.value(Metric::detect), 6, 1e-9);
  EXPECT_NEAR(sut.value(Metric::resume), 8, 1e-9);
  EXPECT_EQ(sut.value(Metric::missed), 0);
  EXPECT_NEAR(sut.value(Metric::sent_in_poor), 100.0 * 6 / 30, 1e-9);
  EXPECT_NEAR(sut.value(Metric::silent_in_good), 100.0 * 8 / 70, 1e-9);
}

TEST(TruthMetrics, TellWhatAPolicyMissed) {
  const auto sut = Hand()
                       .link({{0, 20}, {10, 5}, {30, 20}, {60, 5}, {80, 20}})
                       .decides(0, true, 80)
                       .decides(64, false, 30)
                       .decides(80, true, 80);
  EXPECT_EQ(sut.value(Metric::missed), 1);
  EXPECT_NEAR(sut.value(Metric::detect), 4, 1e-9) << "of the one that was found";
  EXPECT_NEAR(sut.value(Metric::resume), 0, 1e-9);
  EXPECT_NEAR(sut.value(Metric::sent_in_poor), 100.0 * (20 + 4) / 40, 1e-9);
}

TEST(TruthMetrics, HaveNoAnswerWhereNothingWasPoor) {
  const auto sut = Hand().link({{0, 20}}).decides(0, true, 80);
  EXPECT_EQ(sut.value(Metric::poor_share), 0);
  EXPECT_TRUE(std::isnan(sut.value(Metric::detect)));
  EXPECT_TRUE(std::isnan(sut.value(Metric::resume)));
  EXPECT_TRUE(std::isnan(sut.value(Metric::sent_in_poor)));
  EXPECT_EQ(sut.value(Metric::silent_in_good), 0);
}

TEST(SilenceMetrics, AreCountMeanAndLongest) {
  const auto sut = Hand()
                       .decides(10, false, 30)
                       .decides(14, true, 80)
                       .decides(40, false, 30)
                       .decides(50, true, 80);
  EXPECT_EQ(sut.value(Metric::pauses), 2);
  EXPECT_NEAR(sut.value(Metric::silence_mean), 7, 1e-9);
  EXPECT_NEAR(sut.value(Metric::silence_max), 10, 1e-9);
}

TEST(SilenceMetrics, EndWithTheRun) {
  const auto sut = Hand().decides(0, true, 80).decides(85, false, 30);
  EXPECT_EQ(sut.value(Metric::pauses), 1);
  EXPECT_NEAR(sut.value(Metric::silence_max), 15, 1e-9);
}

TEST(SilenceMetrics, BeginWithTheWindow) {
  auto sut = Hand().decides(5, false, 30).decides(25, true, 80);
  sut.warm_up(20);
  EXPECT_NEAR(sut.value(Metric::silence_max), 5, 1e-9);
}

TEST(SilenceMetrics, OfWhoNeverPausesAreNoneAndZero) {
  const auto sut = Hand().decides(0, true, 80);
  EXPECT_EQ(sut.value(Metric::pauses), 0);
  EXPECT_TRUE(std::isnan(sut.value(Metric::silence_mean)));
  EXPECT_EQ(sut.value(Metric::silence_max), 0);
}

TEST(SlotMetrics, CostOnePerPoorSlotSpokenIn) {
  // Three of ten slots are poor and none is silent. The clairvoyant's silence: 3 x 0.1 + 2 x 0.5.
  const auto sut = Hand().link({{0, 20}, {30, 5}, {60, 20}}).decides(0, true, 80);
  EXPECT_NEAR(sut.value(Metric::slot_cost), 100 * 3, 1e-6);
  EXPECT_NEAR(sut.value(Metric::slot_regret), 100 * (3 - 1.3), 1e-6);
}

TEST(MissionMetrics, AreOfAMissionThatWasDone) {
  EXPECT_EQ(Hand().done_after(71.5).value(Metric::completion), 71.5);
  EXPECT_EQ(Hand().done_after(71.5).value(Metric::completed), 1);
  EXPECT_EQ(Hand().value(Metric::completed), 0);
  EXPECT_TRUE(std::isnan(Hand().value(Metric::completion)));
}

TEST(ObservationTest, KeepsTheLastDecisionAndMeasurementInIt) {
  const auto sut = Hand()
                       .decides(20, true, 70)
                       .decides(29.9, true, 60)
                       .decides(30, true, 50)
                       .probes(21, 10)
                       .probes(28, 15);
  EXPECT_EQ(sut.observation(2).qni, 60);
  EXPECT_EQ(sut.observation(2).probe_per, 15);
  EXPECT_EQ(sut.observation(3).qni, 50);
  EXPECT_TRUE(std::isnan(sut.observation(3).probe_per));
}

TEST(ObservationTest, KeepsAQniWhenTheNextDecisionHasNone) {
  EXPECT_EQ(Hand().decides(20, true, 70).decides(25, true, NAN).observation(2).qni, 70);
}

TEST(ObservationTest, AveragesTheSnrOfItsSeconds) {
  // Five seconds of 20 dB and five of 10 dB.
  EXPECT_DOUBLE_EQ(Hand().link({{0, 20}, {25, 10}}).observation(2).snr_db, 15);
}

TEST(ObservationTest, TellsTheShareInWhichTheGateWasOpen) {
  const auto sut = Hand().decides(0, true, 80).decides(22, false, 30).decides(25, true, 80);
  EXPECT_NEAR(sut.observation(2).active, 0.7, 1e-9);
  EXPECT_EQ(sut.observation(1).active, 1);
}

TEST(ObservationTest, TellsTheShareThatWasPoor) {
  const auto sut = Hand().link({{0, 20}, {24, 5}, {60, 20}});
  EXPECT_NEAR(sut.observation(2).poor, 0.6, 1e-9);
  EXPECT_EQ(sut.observation(3).poor, 1);
  EXPECT_EQ(sut.observation(6).poor, 0);
}

TEST(ObservationTest, HasTheMedianLatencyOfWhatWasSentInIt) {
  const auto sut = Hand()
                       .arrives(uxv_high, "location", 1, 20, 0.010)
                       .arrives(uxv_high, "location", 2, 21, 0.500)
                       .arrives(uxv_critical, "heartbeat", 1, 29, 0.030)
                       .arrives(uxv_low, camera_topic, 1, 25, 0.9);
  EXPECT_NEAR(sut.observation(2).latency_ms, 30, 1e-6);
  EXPECT_EQ(sut.observation(2).sent, 3);
  EXPECT_TRUE(std::isnan(sut.observation(3).latency_ms));
}

}  // namespace
}  // namespace tocsin::experiment
