// SPDX-License-Identifier: Apache-2.0
// Each metric of quality, loss, latency, age and link on samples that are few enough to compute
// it by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "metrics/hand.hpp"
#include "metrics/messages.hpp"

namespace tocsin::experiment {
namespace {

TEST(QniMetrics, AreMeanAndLeastOfTheDecisionsThatHaveOne) {
  const auto sut = Hand().decides(1, true, 80).decides(2, true, NAN).decides(3, true, 50);
  EXPECT_DOUBLE_EQ(sut.value(Metric::qni_mean), (80.0 + 50) / 2);
  EXPECT_EQ(sut.value(Metric::qni_min), 50);
}

TEST(QniMetrics, CountFromTheWarmUpOn) {
  auto sut = Hand().decides(9.9, true, 20).decides(10, true, 60).decides(11, true, 70);
  sut.warm_up(10);
  EXPECT_DOUBLE_EQ(sut.value(Metric::qni_mean), 65);
  EXPECT_EQ(sut.value(Metric::qni_min), 60);
}

TEST(ProbeMetrics, AreMeanAndMostOfTheMeasurements) {
  const auto sut = Hand().probes(1, 0).probes(2, 25).probes(3, 5);
  EXPECT_DOUBLE_EQ(sut.value(Metric::probe_per_mean), 10);
  EXPECT_EQ(sut.value(Metric::probe_per_max), 25);
}

TEST(ProbeMetrics, HaveNoAnswerWithoutMeasurements) {
  EXPECT_TRUE(std::isnan(Hand().value(Metric::probe_per_mean)));
  EXPECT_TRUE(std::isnan(Hand().value(Metric::probe_per_max)));
}

/// Of class critical one of four is lost, of high one of two, of low none of two, of the camera two
/// of four; telemetry is all but the camera: two of eight.
Hand every_class() {
  return Hand()
      .arrives(uxv_critical, "heartbeat", 1, 20, 0.010)
      .arrives(uxv_critical, "heartbeat", 2, 21, 0.020)
      .arrives(uxv_critical, "heartbeat", 4, 23, 0.030)
      .arrives(uxv_high, "location", 1, 20, 0.040)
      .arrives(uxv_high, "location", 3, 22, 0.060)
      .arrives(uxv_low, "cpu_load", 7, 20, 0.070)
      .arrives(uxv_low, "cpu_load", 8, 21, 0.090)
      .arrives(uxv_low, camera_topic, 1, 20, 0.5)
      .arrives(uxv_low, camera_topic, 4, 23, 0.5);
}

TEST(LossMetrics, AreGapsInTheSequenceOfEachClass) {
  const auto sut = every_class();
  EXPECT_DOUBLE_EQ(sut.value(Metric::critical_lost), 100.0 / 4);
  EXPECT_DOUBLE_EQ(sut.value(Metric::high_lost), 100.0 / 3);
  EXPECT_DOUBLE_EQ(sut.value(Metric::low_lost), 0);
  EXPECT_DOUBLE_EQ(sut.value(Metric::camera_lost), 100.0 * 2 / 4);
}

TEST(LossMetrics, OfTelemetryLeaveOutTheCameraAndTheGoals) {
  const auto sut =
      every_class().arrives(gcs_high, "goal", 1, 20, 1).arrives(gcs_high, "goal", 9, 40, 1);
  EXPECT_DOUBLE_EQ(sut.value(Metric::telemetry_per), 100.0 * 2 / 9);
  EXPECT_DOUBLE_EQ(sut.value(Metric::goals_lost), 100.0 * 7 / 9);
}

TEST(LossMetrics, CountAGapInTheWarmUpNot) {
  auto sut = Hand()
                 .arrives(uxv_high, "location", 1, 0, 0.1)
                 .arrives(uxv_high, "location", 3, 2, 0.1)
                 .arrives(uxv_high, "location", 10, 30, 0.1)
                 .arrives(uxv_high, "location", 11, 31, 0.1);
  EXPECT_DOUBLE_EQ(sut.value(Metric::high_lost), 100.0 * 7 / 11);
  sut.warm_up(30);
  EXPECT_DOUBLE_EQ(sut.value(Metric::high_lost), 0);
}

TEST(LossMetrics, DoNotSeeWhatIsLostAtTheEnds) {
  // The definition: gaps only. Sample 1 and all after 4 may have been sent and lost.
  const auto sut =
      Hand().arrives(uxv_high, "location", 2, 10, 0.1).arrives(uxv_high, "location", 4, 60, 0.1);
  EXPECT_DOUBLE_EQ(sut.value(Metric::high_lost), 100.0 / 3);
}

TEST(WorstObservation, IsTheGreatestShareOfAtLeastTenSamples) {
  Hand sut;
  std::uint64_t sequence = 0;
  for (int i = 0; i < 10; ++i) {
    ++sequence;
    if (i != 3 && i != 6) sut.arrives(uxv_high, "location", sequence, 20 + i, 0.1);
  }
  for (int i = 0; i < 9; ++i) {
    ++sequence;
    if (i == 0 || i == 8) sut.arrives(uxv_high, "location", sequence, 41 + i, 0.1);
  }
  EXPECT_EQ(sut.observation(4).sent, 9);
  EXPECT_EQ(sut.observation(4).lost, 7);
  EXPECT_DOUBLE_EQ(sut.value(Metric::telemetry_per_max), 100.0 * 2 / 10);
}

TEST(DeliveredMetrics, AreOfWhatWasWrittenHeldBackOrNot) {
  const auto sut = every_class().written(uxv_high, 8).written(uxv_low, 16);
  EXPECT_DOUBLE_EQ(sut.value(Metric::high_delivered), 100.0 * 2 / 8);
  EXPECT_DOUBLE_EQ(sut.value(Metric::low_delivered), 100.0 * 4 / 16);
}

TEST(DeliveredMetrics, OfAClassOfWhichNothingArrivedAreZero) {
  EXPECT_EQ(Hand().written(uxv_high, 8).value(Metric::high_delivered), 0);
}

TEST(DeliveredMetrics, HaveNoAnswerWhenNothingWasWritten) {
  EXPECT_TRUE(std::isnan(every_class().value(Metric::high_delivered)));
  EXPECT_TRUE(std::isnan(every_class().written(uxv_low, 0).value(Metric::low_delivered)));
}

TEST(LatencyMetrics, AreOfWhatArrivedByNearestRank) {
  const auto sut = every_class();
  EXPECT_NEAR(sut.value(Metric::high_latency_median), 40, 1e-6);
  EXPECT_NEAR(sut.value(Metric::high_latency_p99), 60, 1e-6);
  EXPECT_NEAR(sut.value(Metric::critical_latency_p99), 30, 1e-6);
  EXPECT_NEAR(sut.value(Metric::low_latency_p99), 90, 1e-6) << "the camera's 500 ms are not in it";
  EXPECT_NEAR(sut.value(Metric::picture_latency_p99), 500, 1e-6);
  EXPECT_NEAR(sut.value(Metric::critical_latency_median), 20, 1e-6);
}

TEST(LatencyMetrics, OfGoalsGoTheOtherWay) {
  const auto sut =
      Hand().arrives(gcs_high, "goal", 1, 20, 0.2).arrives(gcs_high, "goal", 2, 40, 1.5);
  EXPECT_NEAR(sut.value(Metric::goal_latency_p99), 1500, 1e-6);
  EXPECT_TRUE(std::isnan(sut.value(Metric::high_latency_p99)));
}

TEST(LatencyMetrics, TakeTheNinetyNinthOfAHundred) {
  Hand sut;
  for (int i = 0; i < 100; ++i) {
    sut.arrives(uxv_high, "location", static_cast<std::uint64_t>(i + 1), 0.9 * i, 0.001 * (i + 1));
  }
  EXPECT_NEAR(sut.value(Metric::high_latency_median), 50, 1e-6);
  EXPECT_NEAR(sut.value(Metric::high_latency_p99), 99, 1e-6);
}

/// Class critical: on time, at 250 ms, a little later, at 1 s, later, and one that never came.
Hand late_ones() {
  return Hand()
      .arrives(uxv_critical, "heartbeat", 1, 20, 0.010)
      .arrives(uxv_critical, "heartbeat", 2, 21, 0.2499)
      .arrives(uxv_critical, "heartbeat", 3, 22, 0.2502)
      .arrives(uxv_critical, "heartbeat", 4, 23, 0.9999)
      .arrives(uxv_critical, "heartbeat", 5, 24, 1.0002)
      .arrives(uxv_critical, "heartbeat", 7, 26, 0.010)
      .arrives(uxv_critical, "heartbeat", 8, 27, 0.010)
      .arrives(uxv_critical, "heartbeat", 9, 28, 0.010);
}

TEST(LateMetrics, CountWhatIsLaterThanTheLimitOrNeverCame) {
  const auto sut = late_ones();
  EXPECT_NEAR(sut.value(Metric::critical_late), 100.0 * 4 / 9, 1e-9);
  EXPECT_NEAR(sut.value(Metric::critical_very_late), 100.0 * 2 / 9, 1e-9);
  EXPECT_NEAR(sut.value(Metric::critical_lost), 100.0 / 9, 1e-9);
}

TEST(LateMetrics, AreOfEachClassAlone) {
  const auto sut = late_ones().arrives(uxv_high, "location", 1, 20, 0.3);
  EXPECT_EQ(sut.value(Metric::high_late), 100);
  EXPECT_EQ(sut.value(Metric::high_very_late), 0);
}

TEST(LateMetrics, AreAllOfAClassThatWasWrittenAndNeverArrived) {
  EXPECT_EQ(Hand().written(uxv_high, 8).value(Metric::high_late), 100);
  EXPECT_EQ(Hand().written(uxv_high, 8).value(Metric::high_very_late), 100);
  EXPECT_TRUE(std::isnan(Hand().value(Metric::high_late)));
  EXPECT_TRUE(std::isnan(Hand().written(uxv_high, 0).value(Metric::high_late)));
}

TEST(UserCost, IsTheWeightedSumOfTheRunsFigures) {
  const auto sut = late_ones().written(uxv_low, 4).arrives(uxv_low, camera_topic, 1, 99, 0.8);
  const double expected = 10 * 100.0 * 4 / 9 + 20 * 100.0 * 2 / 9 + 1 * 75 + 5 * 0.8;
  EXPECT_NEAR(sut.value(Metric::user_cost), expected, 1e-6);
}

TEST(AgeMetrics, GrowFromOneArrivalToTheNext) {
  // Looked at each half second from 98 s on: 0, 0.5, 1 (the next came with the age 0), 0.5, 1.
  const auto sut =
      Hand().arrives(uxv_high, "location", 1, 98, 0).arrives(uxv_high, "location", 2, 99, 0);
  EXPECT_NEAR(sut.value(Metric::location_age_mean), (0 + 0.5 + 0 + 0.5 + 1) / 5, 1e-9);
  EXPECT_NEAR(sut.value(Metric::location_age_p95), 1, 1e-9);
  EXPECT_NEAR(sut.value(Metric::location_age_p99), 1, 1e-9);
}

TEST(AgeMetrics, CountTheWayOfASample) {
  const auto sut = Hand().arrives(uxv_high, "location", 1, 99, 0.75);
  EXPECT_NEAR(sut.value(Metric::location_age_mean), 0.75, 1e-9);
}

TEST(AgeMetrics, AreOfTheNewestThatIsThereNotOfTheLastThatCame) {
  // At 99.5 s comes what was sent at 97 s, after what was sent at 99 s.
  const auto sut =
      Hand().arrives(uxv_high, "location", 2, 99, 0).arrives(uxv_high, "location", 1, 97, 2.5);
  EXPECT_NEAR(sut.value(Metric::location_age_mean), (0 + 0.5 + 1) / 3, 1e-9);
}

TEST(AgeMetrics, AreOfOneTopicEach) {
  struct Age {
    const char* topic;
    Metric mean;
    Metric p95;
  };
  const Age all[] = {{"location", Metric::location_age_mean, Metric::location_age_p95},
                     {"network_quality", Metric::quality_age_mean, Metric::quality_age_p95},
                     {"battery_state", Metric::battery_age_mean, Metric::battery_age_p95},
                     {camera_topic, Metric::camera_age_mean, Metric::camera_age_p95},
                     {"heartbeat", Metric::heartbeat_age_mean, Metric::heartbeat_age_p95},
                     {"cpu_load", Metric::cpu_age_mean, Metric::cpu_age_p95},
                     {"transmission_state", Metric::state_age_mean, Metric::state_age_p95}};
  for (const Age& sent : all) {
    const auto sut = Hand().arrives(uxv_low, sent.topic, 1, 98, 0);
    for (const Age& other : all) {
      const double mean_s = sut.value(other.mean);
      const double p95_s = sut.value(other.p95);
      if (other.mean == sent.mean) {
        EXPECT_NEAR(mean_s, (0 + 0.5 + 1 + 1.5 + 2) / 5, 1e-9) << sent.topic;
        EXPECT_NEAR(p95_s, 2, 1e-9) << sent.topic;
      } else {
        EXPECT_TRUE(std::isnan(mean_s)) << other.topic << " of " << sent.topic;
        EXPECT_TRUE(std::isnan(p95_s)) << other.topic << " of " << sent.topic;
      }
    }
  }
}

TEST(LinkMetrics, AreDifferencesOverTheWindow) {
  auto sut = Hand().link({{0, 20}});
  EXPECT_NEAR(sut.value(Metric::link_bytes), 25'000e-6 * 99, 1e-9);
  EXPECT_NEAR(sut.value(Metric::airtime), 20, 1e-9);
  sut.warm_up(50);
  EXPECT_NEAR(sut.value(Metric::link_bytes), 25'000e-6 * 49, 1e-9);
}

TEST(LinkMetrics, HaveNoAnswerWithoutTwoReports) {
  EXPECT_TRUE(std::isnan(Hand().value(Metric::link_bytes)));
  EXPECT_TRUE(std::isnan(Hand().value(Metric::airtime)));
}

}  // namespace
}  // namespace tocsin::experiment
