// SPDX-License-Identifier: Apache-2.0
#include "metrics/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "metrics/messages.hpp"
#include "metrics/toy_recording.hpp"

namespace tocsin::experiment {
namespace {

double value(const report::Recording& recording, Metric metric,
             const Timing& timing = toy_timing()) {
  return measure(recording, timing).values[index_of(metric)];
}

TEST(Metrics, OfQuality) {
  const auto recording = toy_recording();
  EXPECT_DOUBLE_EQ(value(recording, Metric::qni_mean), 70);
  EXPECT_EQ(value(recording, Metric::qni_min), 30);
  EXPECT_DOUBLE_EQ(value(recording, Metric::probe_per_mean), 10);
  EXPECT_EQ(value(recording, Metric::probe_per_max), 50);
}

TEST(Metrics, OfLossTellSentFromWritten) {
  const auto recording = toy_recording();
  EXPECT_NEAR(value(recording, Metric::high_lost), 10, 0.2);
  EXPECT_NEAR(value(recording, Metric::telemetry_per), 10, 0.2);
  EXPECT_DOUBLE_EQ(value(recording, Metric::high_delivered), 90);
  EXPECT_TRUE(std::isnan(value(recording, Metric::low_delivered)));
}

TEST(Metrics, OfTelemetryLeavePicturesOut) {
  auto recording = toy_recording();
  recording.arrivals[uxv_low] = {{1001, 1002, camera_topic, "2", 1, 9},
                                 {1050, 1051, camera_topic, "2", 3, 9}};
  EXPECT_NEAR(value(recording, Metric::telemetry_per), 10, 0.2);
  EXPECT_NEAR(value(recording, Metric::camera_lost), 33.3, 0.1);
  EXPECT_TRUE(std::isnan(value(recording, Metric::low_lost)));
}

TEST(Metrics, OfTheWorstObservationNeedTenSamplesInIt) {
  auto recording = toy_recording();
  EXPECT_DOUBLE_EQ(value(recording, Metric::telemetry_per_max), 10);
  Timing timing = toy_timing();
  timing.observation_s = 5;
  EXPECT_TRUE(std::isnan(value(recording, Metric::telemetry_per_max, timing)));
}

TEST(Metrics, OfLatency) {
  const auto recording = toy_recording();
  EXPECT_NEAR(value(recording, Metric::high_latency_median), 20, 1e-3);
  EXPECT_NEAR(value(recording, Metric::high_latency_p99), 20, 1e-3);
}

TEST(Metrics, OfAge) {
  const auto recording = toy_recording();
  EXPECT_GT(value(recording, Metric::quality_age_mean), 0.2);
  EXPECT_LT(value(recording, Metric::quality_age_mean), 1.0);
  EXPECT_TRUE(std::isnan(value(recording, Metric::camera_age_mean)));
}

TEST(Metrics, OfTheLink) {
  const auto recording = toy_recording();
  EXPECT_NEAR(value(recording, Metric::link_bytes), 0.099, 1e-9);
  EXPECT_NEAR(value(recording, Metric::airtime), 10, 1e-6);
}

TEST(Metrics, AgainstTheTruth) {
  const auto recording = toy_recording();
  Timing timing = toy_timing();
  EXPECT_NEAR(value(recording, Metric::poor_share, timing), 20, 1e-9);
  EXPECT_EQ(value(recording, Metric::detect), 0);
  EXPECT_EQ(value(recording, Metric::missed), 0);
  EXPECT_EQ(value(recording, Metric::pauses), 1);
  EXPECT_DOUBLE_EQ(value(recording, Metric::silence_max), 20);
}

TEST(Metrics, OfTheMission) {
  auto recording = toy_recording();
  EXPECT_EQ(value(recording, Metric::completion), 88.5);
  EXPECT_EQ(value(recording, Metric::completed), 1);
  recording.mission.state = "running";
  EXPECT_TRUE(std::isnan(value(recording, Metric::completion)));
  EXPECT_EQ(value(recording, Metric::completed), 0);
}

TEST(Metrics, DoNotCountTheWarmUp) {
  Timing timing = toy_timing();
  timing.warm_up_s = 60;
  EXPECT_EQ(value(toy_recording(), Metric::qni_min, timing), 80);
  EXPECT_EQ(value(toy_recording(), Metric::pauses, timing), 0);
}

TEST(Metrics, OfARunShorterThanItsWarmUpHaveNoAnswer) {
  Timing timing = toy_timing();
  timing.warm_up_s = 200;
  const Measures sut = measure(toy_recording(), timing);
  EXPECT_TRUE(std::isnan(sut.values[index_of(Metric::qni_mean)]));
  EXPECT_TRUE(sut.series.empty());
}

TEST(Metrics, OfAnEmptyRecordingHaveNoAnswer) {
  report::Recording nothing;
  nothing.end_s = 100;
  const Measures sut = measure(nothing, toy_timing());
  EXPECT_TRUE(std::isnan(sut.values[index_of(Metric::telemetry_per)]));
  EXPECT_EQ(sut.values[index_of(Metric::pauses)], 0);
}

TEST(Observations, CoverTheRunInSteps) {
  const auto series = measure(toy_recording(), toy_timing()).series;
  ASSERT_EQ(series.size(), 10U);
  EXPECT_EQ(series[3].time_s, 30);
  EXPECT_EQ(series[3].qni, 80);
  EXPECT_EQ(series[4].qni, 30);
  EXPECT_EQ(series[4].probe_per, 50);
  EXPECT_EQ(series[4].snr_db, 5);
  EXPECT_EQ(series[4].active, 0);
  EXPECT_EQ(series[3].active, 1);
  EXPECT_EQ(series[3].sent, 10);
  EXPECT_EQ(series[3].lost, 1);
  EXPECT_NEAR(series[3].latency_ms, 20, 1e-3);
}

TEST(Observations, LeaveOutARestAtTheEnd) {
  Timing timing = toy_timing();
  timing.observation_s = 30;
  EXPECT_EQ(measure(toy_recording(), timing).series.size(), 3U);
}

TEST(Observations, MarkWhenTheMachineFroze) {
  auto recording = toy_recording();
  recording.link[25].late_ms = stall_ms;
  recording.link[35].late_ms = stall_ms + 1;
  const Measures sut = measure(recording, toy_timing());
  EXPECT_FALSE(sut.series[2].stalled);
  EXPECT_TRUE(sut.series[3].stalled);
  EXPECT_DOUBLE_EQ(sut.values[index_of(Metric::stalled)], 10);
}

TEST(Measure, TellsTheShareOfEachObservationThatIsPoor) {
  const auto sut = measure(toy_recording(), toy_timing()).series;
  ASSERT_EQ(sut.size(), 10U);
  EXPECT_EQ(sut[3].poor, 0);
  EXPECT_EQ(sut[4].poor, 1);
  EXPECT_EQ(sut[5].poor, 1);
  EXPECT_EQ(sut[6].poor, 0);
}

TEST(Measure, CostsAPauseThatFitsNoMoreThanTheClairvoyants) {
  const auto values = measure(toy_recording(), toy_timing()).values;
  // Two poor slots in silence, two changes, of ten slots.
  EXPECT_NEAR(values[index_of(Metric::slot_cost)], 100 * (2 * 0.1 + 2 * 0.5), 1e-6);
  EXPECT_NEAR(values[index_of(Metric::slot_regret)], 0, 1e-6);
}

TEST(Measure, CountsGoalsThatWereLost) {
  auto recording = toy_recording();
  for (const std::uint64_t sequence : {1, 2, 4}) {
    const double at_s = 1000 + 10 * static_cast<double>(sequence);
    recording.arrivals[gcs_high].push_back({at_s, at_s + 0.1, "goal", "1", sequence, 200});
  }
  const auto values = measure(recording, toy_timing()).values;
  EXPECT_NEAR(values[index_of(Metric::goals_lost)], 25, 1e-6);
}

TEST(Measure, TellsTheAgeOfEachTopicByItself) {
  auto recording = toy_recording();
  for (int i = 0; i < 50; ++i) {
    const double at_s = 1000 + 2 * i;
    recording.arrivals[uxv_critical].push_back(
        {at_s, at_s, "heartbeat", "1", static_cast<std::uint64_t>(i + 1), 20});
  }
  const auto values = measure(recording, toy_timing()).values;
  EXPECT_NEAR(values[index_of(Metric::heartbeat_age_mean)], 0.75, 0.3);
  EXPECT_TRUE(std::isnan(values[index_of(Metric::cpu_age_mean)]));
}

}  // namespace
}  // namespace tocsin::experiment
