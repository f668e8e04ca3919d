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
  EXPECT_DOUBLE_EQ(sut.value("qni_mean"), (80.0 + 50) / 2);
  EXPECT_EQ(sut.value("qni_min"), 50);
}

TEST(QniMetrics, CountFromTheWarmUpOn) {
  auto sut = Hand().decides(9.9, true, 20).decides(10, true, 60).decides(11, true, 70);
  sut.warm_up(10);
  EXPECT_DOUBLE_EQ(sut.value("qni_mean"), 65);
  EXPECT_EQ(sut.value("qni_min"), 60);
}

TEST(ProbeMetrics, AreMeanAndMostOfTheMeasurements) {
  const auto sut = Hand().probes(1, 0).probes(2, 25).probes(3, 5);
  EXPECT_DOUBLE_EQ(sut.value("probe_per_mean"), 10);
  EXPECT_EQ(sut.value("probe_per_max"), 25);
}

TEST(ProbeMetrics, HaveNoAnswerWithoutMeasurements) {
  EXPECT_TRUE(std::isnan(Hand().value("probe_per_mean")));
  EXPECT_TRUE(std::isnan(Hand().value("probe_per_max")));
}

/// Of class critical one of four is lost, of high one of two, of low none of two, of the camera two
/// of four; telemetry is all but the camera: two of eight.
Hand every_class() {
  return Hand()
      .arrives("uxv critical", "heartbeat", 1, 20, 0.010)
      .arrives("uxv critical", "heartbeat", 2, 21, 0.020)
      .arrives("uxv critical", "heartbeat", 4, 23, 0.030)
      .arrives("uxv high", "location", 1, 20, 0.040)
      .arrives("uxv high", "location", 3, 22, 0.060)
      .arrives("uxv low", "cpu_load", 7, 20, 0.070)
      .arrives("uxv low", "cpu_load", 8, 21, 0.090)
      .arrives("uxv low", camera_topic, 1, 20, 0.5)
      .arrives("uxv low", camera_topic, 4, 23, 0.5);
}

TEST(LossMetrics, AreGapsInTheSequenceOfEachClass) {
  const auto sut = every_class();
  EXPECT_DOUBLE_EQ(sut.value("critical_lost"), 100.0 / 4);
  EXPECT_DOUBLE_EQ(sut.value("high_lost"), 100.0 / 3);
  EXPECT_DOUBLE_EQ(sut.value("low_lost"), 0);
  EXPECT_DOUBLE_EQ(sut.value("camera_lost"), 100.0 * 2 / 4);
}

TEST(LossMetrics, OfTelemetryLeaveOutTheCameraAndTheGoals) {
  const auto sut =
      every_class().arrives("gcs high", "goal", 1, 20, 1).arrives("gcs high", "goal", 9, 40, 1);
  EXPECT_DOUBLE_EQ(sut.value("telemetry_per"), 100.0 * 2 / 9);
  EXPECT_DOUBLE_EQ(sut.value("goals_lost"), 100.0 * 7 / 9);
}

TEST(LossMetrics, CountAGapInTheWarmUpNot) {
  auto sut = Hand()
                 .arrives("uxv high", "location", 1, 0, 0.1)
                 .arrives("uxv high", "location", 3, 2, 0.1)
                 .arrives("uxv high", "location", 10, 30, 0.1)
                 .arrives("uxv high", "location", 11, 31, 0.1);
  EXPECT_DOUBLE_EQ(sut.value("high_lost"), 100.0 * 7 / 11);
  sut.warm_up(30);
  EXPECT_DOUBLE_EQ(sut.value("high_lost"), 0);
}

TEST(LossMetrics, PlaceWhatIsMissingBetweenItsNeighbours) {
  // Samples 2 to 5 are missing between 10 s and 60 s: at 20, 30, 40 and 50 s.
  const auto sut = Hand()
                       .arrives("uxv high", "location", 1, 10, 0.1)
                       .arrives("uxv high", "location", 6, 60, 0.1);
  EXPECT_EQ(sut.observation(1).sent, 1);
  EXPECT_EQ(sut.observation(1).lost, 0);
  for (std::size_t i = 2; i <= 5; ++i) {
    EXPECT_EQ(sut.observation(i).sent, 1) << i;
    EXPECT_EQ(sut.observation(i).lost, 1) << i;
  }
  EXPECT_EQ(sut.observation(7).sent, 0);
}

TEST(LossMetrics, DoNotSeeWhatIsLostAtTheEnds) {
  // The definition: gaps only. Sample 1 and all after 4 may have been sent and lost.
  const auto sut = Hand()
                       .arrives("uxv high", "location", 2, 10, 0.1)
                       .arrives("uxv high", "location", 4, 60, 0.1);
  EXPECT_DOUBLE_EQ(sut.value("high_lost"), 100.0 / 3);
}

TEST(WorstObservation, IsTheGreatestShareOfAtLeastTenSamples) {
  Hand sut;
  std::uint64_t sequence = 0;
  for (int i = 0; i < 10; ++i) {
    ++sequence;
    if (i != 3 && i != 6) sut.arrives("uxv high", "location", sequence, 20 + i, 0.1);
  }
  for (int i = 0; i < 9; ++i) {
    ++sequence;
    if (i == 0 || i == 8) sut.arrives("uxv high", "location", sequence, 41 + i, 0.1);
  }
  EXPECT_EQ(sut.observation(4).sent, 9);
  EXPECT_EQ(sut.observation(4).lost, 7);
  EXPECT_DOUBLE_EQ(sut.value("telemetry_per_max"), 100.0 * 2 / 10);
}

TEST(DeliveredMetrics, AreOfWhatWasWrittenHeldBackOrNot) {
  const auto sut = every_class().written("uxv high", 8).written("uxv low", 16);
  EXPECT_DOUBLE_EQ(sut.value("high_delivered"), 100.0 * 2 / 8);
  EXPECT_DOUBLE_EQ(sut.value("low_delivered"), 100.0 * 4 / 16);
}

TEST(DeliveredMetrics, OfAClassOfWhichNothingArrivedAreZero) {
  EXPECT_EQ(Hand().written("uxv high", 8).value("high_delivered"), 0);
}

TEST(DeliveredMetrics, HaveNoAnswerWhenNothingWasWritten) {
  EXPECT_TRUE(std::isnan(every_class().value("high_delivered")));
  EXPECT_TRUE(std::isnan(every_class().written("uxv low", 0).value("low_delivered")));
}

TEST(LatencyMetrics, AreOfWhatArrivedByNearestRank) {
  const auto sut = every_class();
  EXPECT_NEAR(sut.value("high_latency_median"), 40, 1e-6);
  EXPECT_NEAR(sut.value("high_latency_p99"), 60, 1e-6);
  EXPECT_NEAR(sut.value("critical_latency_p99"), 30, 1e-6);
  EXPECT_NEAR(sut.value("low_latency_p99"), 90, 1e-6) << "the camera's 500 ms are not in it";
}

TEST(LatencyMetrics, OfGoalsGoTheOtherWay) {
  const auto sut =
      Hand().arrives("gcs high", "goal", 1, 20, 0.2).arrives("gcs high", "goal", 2, 40, 1.5);
  EXPECT_NEAR(sut.value("goal_latency_p99"), 1500, 1e-6);
  EXPECT_TRUE(std::isnan(sut.value("high_latency_p99")));
}

TEST(LatencyMetrics, TakeTheNinetyNinthOfAHundred) {
  Hand sut;
  for (int i = 0; i < 100; ++i) {
    sut.arrives("uxv high", "location", static_cast<std::uint64_t>(i + 1), 0.9 * i,
                0.001 * (i + 1));
  }
  EXPECT_NEAR(sut.value("high_latency_median"), 50, 1e-6);
  EXPECT_NEAR(sut.value("high_latency_p99"), 99, 1e-6);
}

TEST(LatencyMetrics, OfPicturesAreTheirOwn) {
  const auto sut = every_class();
  EXPECT_NEAR(sut.value("picture_latency_p99"), 500, 1e-6);
  EXPECT_NEAR(sut.value("critical_latency_median"), 20, 1e-6);
}

/// Class critical: on time, at 250 ms, a little later, at 1 s, later, and one that never came.
Hand late_ones() {
  return Hand()
      .arrives("uxv critical", "heartbeat", 1, 20, 0.010)
      .arrives("uxv critical", "heartbeat", 2, 21, 0.2499)
      .arrives("uxv critical", "heartbeat", 3, 22, 0.2502)
      .arrives("uxv critical", "heartbeat", 4, 23, 0.9999)
      .arrives("uxv critical", "heartbeat", 5, 24, 1.0002)
      .arrives("uxv critical", "heartbeat", 7, 26, 0.010)
      .arrives("uxv critical", "heartbeat", 8, 27, 0.010)
      .arrives("uxv critical", "heartbeat", 9, 28, 0.010);
}

TEST(LateMetrics, CountWhatIsLaterThanTheLimitOrNeverCame) {
  const auto sut = late_ones();
  EXPECT_NEAR(sut.value("critical_late"), 100.0 * 4 / 9, 1e-9);
  EXPECT_NEAR(sut.value("critical_very_late"), 100.0 * 2 / 9, 1e-9);
  EXPECT_NEAR(sut.value("critical_lost"), 100.0 / 9, 1e-9);
}

TEST(LateMetrics, AreOfEachClassAlone) {
  const auto sut = late_ones().arrives("uxv high", "location", 1, 20, 0.3);
  EXPECT_EQ(sut.value("high_late"), 100);
  EXPECT_EQ(sut.value("high_very_late"), 0);
}

TEST(LateMetrics, AreAllOfAClassThatWasWrittenAndNeverArrived) {
  EXPECT_EQ(Hand().written("uxv high", 8).value("high_late"), 100);
  EXPECT_EQ(Hand().written("uxv high", 8).value("high_very_late"), 100);
  EXPECT_TRUE(std::isnan(Hand().value("high_late")));
  EXPECT_TRUE(std::isnan(Hand().written("uxv high", 0).value("high_late")));
}

TEST(UserCost, IsTheWeightedSumOfTheRunsFigures) {
  const auto sut = late_ones().written("uxv low", 4).arrives("uxv low", camera_topic, 1, 99, 0.8);
  const double expected = 10 * 100.0 * 4 / 9 + 20 * 100.0 * 2 / 9 + 1 * 75 + 5 * 0.8;
  EXPECT_NEAR(sut.value("user_cost"), expected, 1e-6);
}

TEST(AgeMetrics, GrowFromOneArrivalToTheNext) {
  // Looked at each half second from 98 s on: 0, 0.5, 1 (the next came with the age 0), 0.5, 1.
  const auto sut =
      Hand().arrives("uxv high", "location", 1, 98, 0).arrives("uxv high", "location", 2, 99, 0);
  EXPECT_NEAR(sut.value("location_age_mean"), (0 + 0.5 + 0 + 0.5 + 1) / 5, 1e-9);
  EXPECT_NEAR(sut.value("location_age_p95"), 1, 1e-9);
  EXPECT_NEAR(sut.value("location_age_p99"), 1, 1e-9);
}

TEST(AgeMetrics, CountTheWayOfASample) {
  const auto sut = Hand().arrives("uxv high", "location", 1, 99, 0.75);
  EXPECT_NEAR(sut.value("location_age_mean"), 0.75, 1e-9);
}

TEST(AgeMetrics, AreOfTheNewestThatIsThereNotOfTheLastThatCame) {
  // At 99.5 s comes what was sent at 97 s, after what was sent at 99 s.
  const auto sut =
      Hand().arrives("uxv high", "location", 2, 99, 0).arrives("uxv high", "location", 1, 97, 2.5);
  EXPECT_NEAR(sut.value("location_age_mean"), (0 + 0.5 + 1) / 3, 1e-9);
}

TEST(AgeMetrics, AreOfOneTopicEach) {
  const std::pair<const char*, const char*> topics[] = {
      {"location", "location"},       {"quality", "network_quality"}, {"battery", "battery_state"},
      {"camera", camera_topic},       {"heartbeat", "heartbeat"},     {"cpu", "cpu_load"},
      {"state", "transmission_state"}};
  for (const auto& [name, topic] : topics) {
    const auto sut = Hand().arrives("uxv low", topic, 1, 98, 0);
    for (const auto& [other, unused] : topics) {
      const double age_s = sut.value((std::string(other) + "_age_mean").c_str());
      const double p95_s = sut.value((std::string(other) + "_age_p95").c_str());
      if (std::string(other) == name) {
        EXPECT_NEAR(age_s, (0 + 0.5 + 1 + 1.5 + 2) / 5, 1e-9) << name;
        EXPECT_NEAR(p95_s, 2, 1e-9) << name;
      } else {
        EXPECT_TRUE(std::isnan(age_s)) << other << " of " << name;
        EXPECT_TRUE(std::isnan(p95_s)) << other << " of " << name;
      }
    }
  }
}

TEST(LinkMetrics, AreDifferencesOverTheWindow) {
  auto sut = Hand().link({{0, 20}});
  EXPECT_NEAR(sut.value("link_bytes"), 25'000e-6 * 99, 1e-9);
  EXPECT_NEAR(sut.value("airtime"), 20, 1e-9);
  sut.warm_up(50);
  EXPECT_NEAR(sut.value("link_bytes"), 25'000e-6 * 49, 1e-9);
}

TEST(LinkMetrics, HaveNoAnswerWithoutTwoReports) {
  EXPECT_TRUE(std::isnan(Hand().value("link_bytes")));
  EXPECT_TRUE(std::isnan(Hand().value("airtime")));
}

TEST(MetricTexts, AreAllDefinedWithAUnit) {
  for (const MetricText& text : metric_texts()) {
    EXPECT_GT(std::string(text.text).size(), 10U) << text.name;
    EXPECT_FALSE(std::string(text.unit).empty()) << text.name;
  }
}

TEST(MetricTexts, SayWhichWayIsBetter) {
  const auto less = [](const char* name) {
    return metric_texts()[metric_index(name)].less_is_better;
  };
  for (const char* name : {"qni_mean", "qni_min", "high_delivered", "low_delivered", "completed"}) {
    EXPECT_FALSE(less(name)) << name;
  }
  for (const char* name :
       {"telemetry_per_max", "high_latency_p99", "slot_cost", "user_cost", "critical_late",
        "location_age_mean", "missed", "airtime", "completion"}) {
    EXPECT_TRUE(less(name)) << name;
  }
}

}  // namespace
}  // namespace tocsin::experiment
