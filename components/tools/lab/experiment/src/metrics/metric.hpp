// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "foundation/enum_words.hpp"

namespace tocsin::experiment {

/// What is measured of a run, in the order of runs.csv.
enum class Metric : std::uint8_t {
  qni_mean,
  qni_min,
  probe_per_mean,
  probe_per_max,
  telemetry_per,
  telemetry_per_max,
  user_cost,
  critical_late,
  critical_very_late,
  high_late,
  high_very_late,
  critical_lost,
  high_lost,
  low_lost,
  camera_lost,
  goals_lost,
  high_delivered,
  low_delivered,
  critical_latency_median,
  critical_latency_p99,
  high_latency_median,
  high_latency_p99,
  low_latency_p99,
  picture_latency_p99,
  goal_latency_p99,
  location_age_mean,
  location_age_p95,
  location_age_p99,
  quality_age_mean,
  quality_age_p95,
  battery_age_mean,
  battery_age_p95,
  camera_age_mean,
  camera_age_p95,
  heartbeat_age_mean,
  heartbeat_age_p95,
  state_age_mean,
  state_age_p95,
  cpu_age_mean,
  cpu_age_p95,
  link_bytes,
  airtime,
  poor_share,
  poor_intervals,
  missed,
  detect,
  resume,
  sent_in_poor,
  silent_in_good,
  slot_cost,
  slot_regret,
  pauses,
  silence_mean,
  silence_max,
  completion,
  completed,
  stalled,
};

inline constexpr std::size_t metric_count = static_cast<std::size_t>(Metric::stalled) + 1;

/// Place of a metric in Measures::values.
[[nodiscard]] constexpr std::size_t index_of(Metric metric) {
  return static_cast<std::size_t>(metric);
}

/// Their columns in runs.csv; report/metrics.py defines each for readers.
inline constexpr std::array metric_names{"qni_mean",
                                         "qni_min",
                                         "probe_per_mean",
                                         "probe_per_max",
                                         "telemetry_per",
                                         "telemetry_per_max",
                                         "user_cost",
                                         "critical_late",
                                         "critical_very_late",
                                         "high_late",
                                         "high_very_late",
                                         "critical_lost",
                                         "high_lost",
                                         "low_lost",
                                         "camera_lost",
                                         "goals_lost",
                                         "high_delivered",
                                         "low_delivered",
                                         "critical_latency_median",
                                         "critical_latency_p99",
                                         "high_latency_median",
                                         "high_latency_p99",
                                         "low_latency_p99",
                                         "picture_latency_p99",
                                         "goal_latency_p99",
                                         "location_age_mean",
                                         "location_age_p95",
                                         "location_age_p99",
                                         "quality_age_mean",
                                         "quality_age_p95",
                                         "battery_age_mean",
                                         "battery_age_p95",
                                         "camera_age_mean",
                                         "camera_age_p95",
                                         "heartbeat_age_mean",
                                         "heartbeat_age_p95",
                                         "state_age_mean",
                                         "state_age_p95",
                                         "cpu_age_mean",
                                         "cpu_age_p95",
                                         "link_bytes",
                                         "airtime",
                                         "poor_share",
                                         "poor_intervals",
                                         "missed",
                                         "detect",
                                         "resume",
                                         "sent_in_poor",
                                         "silent_in_good",
                                         "slot_cost",
                                         "slot_regret",
                                         "pauses",
                                         "silence_mean",
                                         "silence_max",
                                         "completion",
                                         "completed",
                                         "stalled"};
inline constexpr auto words_of(Metric) { return metric_names; }
static_assert(words_of(Metric{}).size() == metric_count);

}  // namespace tocsin::experiment
