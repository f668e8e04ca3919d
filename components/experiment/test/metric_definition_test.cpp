// SPDX-License-Identifier: Apache-2.0
// Each metric on samples that are few enough to compute it by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <utility>

#include "experiment/metrics.hpp"
#include "messages.hpp"

namespace tocsin::experiment {
namespace {

constexpr double begin_s = 1000;

/// A run of 100 s that is filled sample by sample; times count from its begin.
class Hand {
 public:
  Hand() {
    recording_.begin_s = begin_s;
    recording_.end_s = begin_s + 100;
    timing_.duration_s = 100;
    timing_.warm_up_s = 0;
    timing_.observation_s = 10;
    timing_.poor_below_snr_db = 10;
  }
  Hand& warm_up(double s) {
    timing_.warm_up_s = s;
    return *this;
  }
  /// Sample `sequence` of a topic, sent at `sent_s`, that took `latency_s`.
  Hand& arrives(const char* name, const char* topic, std::uint64_t sequence, double sent_s,
                double latency_s, const char* writer = "1") {
    const double at_s = begin_s + sent_s;
    recording_.arrivals[name].push_back({at_s, at_s + latency_s, topic, writer, sequence, 50});
    return *this;
  }
  Hand& written(const char* name, std::uint64_t count) {
    recording_.written[name] = count;
    return *this;
  }
  Hand& decides(double at_s, bool active, double qni) {
    recording_.decisions.push_back({begin_s + at_s, active, "toy", "steady", qni});
    return *this;
  }
  Hand& probes(double at_s, double per) {
    recording_.qualities.push_back({begin_s + at_s, per, -60, 5});
    return *this;
  }
  /// The link's SNR second by second: pairs of (from this second on, value).
  Hand& link(std::initializer_list<std::pair<int, double>> steps) {
    double snr_db = 0;
    for (int i = 0; i <= 100; ++i) {
      for (const auto& [from_s, value] : steps) snr_db = i == from_s ? value : snr_db;
      recording_.link.push_back({begin_s + i, snr_db, 0.5, 0.2 * i, 25'000.0 * i, 0});
    }
    return *this;
  }
  Hand& done_after(double s) {
    recording_.mission = {"toy", "done", 8, 9, 9, s};
    return *this;
  }
  [[nodiscard]] double value(const char* metric) const {
    return measure(recording_, timing_).values[metric_index(metric)];
  }
  [[nodiscard]] Observation observation(std::size_t i) const {
    return measure(recording_, timing_).series.at(i);
  }

 private:
  report::Recording recording_;
  Timing timing_;
};

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
  for (std::size_t i : {2, 3, 4, 5}) {
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

TEST(AgeMetrics, GrowFromOneArrivalToTheNext) {
  // Looked at each half second from 98 s on: 0, 0.5, 1 (the next came with the age 0), 0.5, 1.
  const auto sut =
      Hand().arrives("uxv high", "location", 1, 98, 0).arrives("uxv high", "location", 2, 99, 0);
  EXPECT_NEAR(sut.value("location_age_mean"), (0 + 0.5 + 0 + 0.5 + 1) / 5, 1e-9);
  EXPECT_NEAR(sut.value("location_age_p95"), 1, 1e-9);
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
  EXPECT_NEAR(sut.value("poor_share"), 30 + 24, 1e-9);
  EXPECT_EQ(sut.value("poor_intervals"), 2);
}

TEST(TruthMetrics, LeaveOutWhatIsShorterThanTwoObservations) {
  EXPECT_EQ(Hand().link({{0, 20}, {20, 5}, {39, 20}}).value("poor_intervals"), 0);
  EXPECT_EQ(Hand().link({{0, 20}, {20, 5}, {40, 20}}).value("poor_intervals"), 1);
}

TEST(TruthMetrics, JoinIntervalsOverAGapShorterThanTwoObservations) {
  EXPECT_EQ(half_found().value("poor_intervals"), 1) << "10 s between them";
  EXPECT_EQ(Hand().link({{0, 20}, {20, 5}, {40, 20}, {60, 5}, {80, 20}}).value("poor_intervals"),
            2);
}

TEST(TruthMetrics, TellWhenAPolicyFoundItAndSpokeAgain) {
  const auto sut = Hand()
                       .link({{0, 20}, {20, 5}, {50, 20}})
                       .decides(0, true, 80)
                       .decides(26, false, 30)
                       .decides(58, true, 80);
  EXPECT_NEAR(sut.value("detect"), 6, 1e-9);
  EXPECT_NEAR(sut.value("resume"), 8, 1e-9);
  EXPECT_EQ(sut.value("missed"), 0);
  EXPECT_NEAR(sut.value("sent_in_poor"), 100.0 * 6 / 30, 1e-9);
  EXPECT_NEAR(sut.value("silent_in_good"), 100.0 * 8 / 70, 1e-9);
}

TEST(TruthMetrics, TellWhatAPolicyMissed) {
  const auto sut = Hand()
                       .link({{0, 20}, {10, 5}, {30, 20}, {60, 5}, {80, 20}})
                       .decides(0, true, 80)
                       .decides(64, false, 30)
                       .decides(80, true, 80);
  EXPECT_EQ(sut.value("missed"), 1);
  EXPECT_NEAR(sut.value("detect"), 4, 1e-9) << "of the one that was found";
  EXPECT_NEAR(sut.value("resume"), 0, 1e-9);
  EXPECT_NEAR(sut.value("sent_in_poor"), 100.0 * (20 + 4) / 40, 1e-9);
}

TEST(TruthMetrics, HaveNoAnswerWhereNothingWasPoor) {
  const auto sut = Hand().link({{0, 20}}).decides(0, true, 80);
  EXPECT_EQ(sut.value("poor_share"), 0);
  EXPECT_TRUE(std::isnan(sut.value("detect")));
  EXPECT_TRUE(std::isnan(sut.value("resume")));
  EXPECT_TRUE(std::isnan(sut.value("sent_in_poor")));
  EXPECT_EQ(sut.value("silent_in_good"), 0);
}

TEST(SilenceMetrics, AreCountMeanAndLongest) {
  const auto sut = Hand()
                       .decides(10, false, 30)
                       .decides(14, true, 80)
                       .decides(40, false, 30)
                       .decides(50, true, 80);
  EXPECT_EQ(sut.value("pauses"), 2);
  EXPECT_NEAR(sut.value("silence_mean"), 7, 1e-9);
  EXPECT_NEAR(sut.value("silence_max"), 10, 1e-9);
}

TEST(SilenceMetrics, EndWithTheRun) {
  const auto sut = Hand().decides(0, true, 80).decides(85, false, 30);
  EXPECT_EQ(sut.value("pauses"), 1);
  EXPECT_NEAR(sut.value("silence_max"), 15, 1e-9);
}

TEST(SilenceMetrics, BeginWithTheWindow) {
  auto sut = Hand().decides(5, false, 30).decides(25, true, 80);
  sut.warm_up(20);
  EXPECT_NEAR(sut.value("silence_max"), 5, 1e-9);
}

TEST(SilenceMetrics, OfWhoNeverPausesAreNoneAndZero) {
  const auto sut = Hand().decides(0, true, 80);
  EXPECT_EQ(sut.value("pauses"), 0);
  EXPECT_TRUE(std::isnan(sut.value("silence_mean")));
  EXPECT_EQ(sut.value("silence_max"), 0);
}

TEST(SlotMetrics, CostOnePerPoorSlotSpokenIn) {
  // Three of ten slots are poor and none is silent. The clairvoyant's silence: 3 x 0.1 + 2 x 0.5.
  const auto sut = Hand().link({{0, 20}, {30, 5}, {60, 20}}).decides(0, true, 80);
  EXPECT_NEAR(sut.value("slot_cost"), 100 * 3, 1e-6);
  EXPECT_NEAR(sut.value("slot_regret"), 100 * (3 - 1.3), 1e-6);
}

TEST(SlotMetrics, CostHalfPerGoodSlotInSilence) {
  const auto sut =
      Hand().link({{0, 20}}).decides(0, true, 80).decides(40, false, 30).decides(70, true, 80);
  EXPECT_NEAR(sut.value("slot_cost"), 100 * (3 * 0.5 + 2 * 0.5), 1e-6);
  EXPECT_NEAR(sut.value("slot_regret"), sut.value("slot_cost"), 1e-6) << "he never falls silent";
}

TEST(MissionMetrics, AreOfAMissionThatWasDone) {
  EXPECT_EQ(Hand().done_after(71.5).value("completion"), 71.5);
  EXPECT_EQ(Hand().done_after(71.5).value("completed"), 1);
  EXPECT_EQ(Hand().value("completed"), 0);
  EXPECT_TRUE(std::isnan(Hand().value("completion")));
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
                       .arrives("uxv high", "location", 1, 20, 0.010)
                       .arrives("uxv high", "location", 2, 21, 0.500)
                       .arrives("uxv critical", "heartbeat", 1, 29, 0.030)
                       .arrives("uxv low", camera_topic, 1, 25, 0.9);
  EXPECT_NEAR(sut.observation(2).latency_ms, 30, 1e-6);
  EXPECT_EQ(sut.observation(2).sent, 3);
  EXPECT_TRUE(std::isnan(sut.observation(3).latency_ms));
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
  for (const char* name : {"telemetry_per_max", "high_latency_p99", "slot_cost",
                           "location_age_mean", "missed", "airtime", "completion"}) {
    EXPECT_TRUE(less(name)) << name;
  }
}

}  // namespace
}  // namespace tocsin::experiment
