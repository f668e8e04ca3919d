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

TEST(Metrics, OfTheMission) {
  auto recording = toy_recording();
  EXPECT_EQ(value(recording, Metric::completion), 88.5);
  EXPECT_EQ(value(recording, Metric::completed), 1);
  recording.mission.state = "running";
  EXPECT_TRUE(std::isnan(value(recording, Metric::completion)));
  EXPECT_EQ(value(recording, Metric::completed), 0);
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

}  // namespace
}  // namespace tocsin::experiment
