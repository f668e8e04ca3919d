// SPDX-License-Identifier: Apache-2.0
// The one place where a metric is named and defined for readers.
#include "metrics/metric.hpp"

namespace tocsin::experiment {

namespace {

constexpr std::array<MetricText, metric_count> table{{
    {Metric::qni_mean, "qni_mean", "%",
     "network quality indicator, mean over the vehicle's decisions", false},
    {Metric::qni_min, "qni_min", "%", "the lowest QNI of the run", false},
    {Metric::probe_per_mean, "probe_per_mean", "%",
     "share of ICMP echoes without an answer: mean over the vehicle's measurements", true},
    {Metric::probe_per_max, "probe_per_max", "%",
     "the highest of these measurements (20 echoes each)", true},
    {Metric::telemetry_per, "telemetry_per", "%",
     "share of the vehicle's samples that were put on the link and never arrived, all topics "
     "but the camera; what the gate held back was not sent",
     true},
    {Metric::telemetry_per_max, "telemetry_per_max", "%",
     "the highest share lost in one observation (at least 10 samples sent in it)", true},
    {Metric::user_cost, "user_cost", "1",
     "one cost of what users feel: weighted sum of the late shares of class critical and high, of "
     "class low not delivered, of the age of the location, of the delay of pictures and of "
     "airtime; the weights are the experiment file's, in units of one percent of class low",
     true},
    {Metric::critical_late, "critical_late", "%",
     "share of samples sent that came later than 250 ms or never, class critical of the vehicle",
     true},
    {Metric::critical_very_late, "critical_very_late", "%", "the same, later than 1 s or never",
     true},
    {Metric::high_late, "high_late", "%", "share that came later than 250 ms or never, class high",
     true},
    {Metric::high_very_late, "high_very_late", "%", "the same, later than 1 s or never", true},
    {Metric::critical_lost, "critical_lost", "%",
     "share of samples sent that never arrived, repaired or not, class critical of the vehicle",
     true},
    {Metric::high_lost, "high_lost", "%", "the same of class high", true},
    {Metric::low_lost, "low_lost", "%", "the same of class low without the camera", true},
    {Metric::camera_lost, "camera_lost", "%", "the same of the camera", true},
    {Metric::goals_lost, "goals_lost", "%", "the same of the ground station's goals (class high)",
     true},
    {Metric::high_delivered, "high_delivered", "%",
     "share that arrived of all that the vehicle's components wrote, class high", false},
    {Metric::low_delivered, "low_delivered", "%",
     "the same of class low, camera included, held back ones counted", false},
    {Metric::critical_latency_median, "critical_latency_median", "ms",
     "from write to acknowledgement, median, class critical", true},
    {Metric::critical_latency_p99, "critical_latency_p99", "ms", "the same, 99th percentile", true},
    {Metric::high_latency_median, "high_latency_median", "ms",
     "from write to acknowledgement, median, class high", true},
    {Metric::high_latency_p99, "high_latency_p99", "ms", "the same, 99th percentile", true},
    {Metric::low_latency_p99, "low_latency_p99", "ms", "the same, class low without the camera",
     true},
    {Metric::picture_latency_p99, "picture_latency_p99", "ms",
     "from write to acknowledgement of a whole picture, 99th percentile", true},
    {Metric::goal_latency_p99, "goal_latency_p99", "ms",
     "from write to acknowledgement of the ground station's goals", true},
    {Metric::location_age_mean, "location_age_mean", "s",
     "age of the newest received sample at the ground station, looked at each half second: mean",
     true},
    {Metric::location_age_p95, "location_age_p95", "s", "the same, 95th percentile", true},
    {Metric::location_age_p99, "location_age_p99", "s", "the same, 99th percentile", true},
    {Metric::quality_age_mean, "quality_age_mean", "s", "network quality: the same, mean", true},
    {Metric::quality_age_p95, "quality_age_p95", "s", "network quality: 95th percentile", true},
    {Metric::battery_age_mean, "battery_age_mean", "s", "battery state (class low): mean", true},
    {Metric::battery_age_p95, "battery_age_p95", "s", "battery state (class low): 95th percentile",
     true},
    {Metric::camera_age_mean, "camera_age_mean", "s", "camera (class low): mean", true},
    {Metric::camera_age_p95, "camera_age_p95", "s", "camera (class low): 95th percentile", true},
    {Metric::heartbeat_age_mean, "heartbeat_age_mean", "s", "heartbeat (class critical): mean",
     true},
    {Metric::heartbeat_age_p95, "heartbeat_age_p95", "s",
     "heartbeat (class critical): 95th percentile", true},
    {Metric::state_age_mean, "state_age_mean", "s", "transmission state (class critical): mean",
     true},
    {Metric::state_age_p95, "state_age_p95", "s",
     "transmission state (class critical): 95th percentile", true},
    {Metric::cpu_age_mean, "cpu_age_mean", "s", "CPU load (class low): mean", true},
    {Metric::cpu_age_p95, "cpu_age_p95", "s", "CPU load (class low): 95th percentile", true},
    {Metric::link_bytes, "link_bytes", "MB", "IP packets given to the radio, both directions",
     true},
    {Metric::airtime, "airtime", "%",
     "share of the run that our frames and acknowledgements were on the air", true},
    {Metric::poor_share, "poor_share", "%", "share of the run in which the link was truly poor",
     true},
    {Metric::poor_intervals, "poor_intervals", "1",
     "truly poor intervals of at least two observations; shorter gaps do not divide one", true},
    {Metric::missed, "missed", "1", "of these, without any pause", true},
    {Metric::detect, "detect", "s",
     "from the begin of a truly poor interval, where the clairvoyant pauses, to the pause: mean "
     "over the intervals that had one",
     true},
    {Metric::resume, "resume", "s",
     "from the end of a truly poor interval, where the clairvoyant resumes, to speaking: mean",
     true},
    {Metric::sent_in_poor, "sent_in_poor", "%",
     "share of the truly poor time in which the gate was open", true},
    {Metric::silent_in_good, "silent_in_good", "%",
     "share of the other time in which it was closed", true},
    {Metric::slot_cost, "slot_cost", "1",
     "cost per 1000 observations: 1 for one spoken in while the link was truly poor (for more than "
     "half of it), 0.5 for a silent one while it was good, 0.1 for a silent one while poor, 0.5 "
     "for each change; the costs of the decision library, to which `fit` fits the policies",
     true},
    {Metric::slot_regret, "slot_regret", "1",
     "the same, minus the cost of the clairvoyant, who knows the truth beforehand and is never "
     "silent for more than 30 observations",
     true},
    {Metric::pauses, "pauses", "1", "pauses of the vehicle", true},
    {Metric::silence_mean, "silence_mean", "s", "length of a pause, mean", true},
    {Metric::silence_max, "silence_max", "s", "length of the longest pause", true},
    {Metric::completion, "completion", "s",
     "from the first goal to the last waypoint; none when it was not reached", true},
    {Metric::completed, "completed", "1", "1 when the mission was done within the run", false},
    {Metric::stalled, "stalled", "%",
     "share of observations in which the machine froze (real runs)", true},
}};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (index_of(table[i].metric) != i) return false;
  }
  return true;
}
static_assert(is_in_order());

}  // namespace

const std::array<MetricText, metric_count>& metric_texts() { return table; }

const MetricText& text_of(Metric metric) { return table[index_of(metric)]; }

std::string metric_label(Metric metric) {
  const MetricText& text = text_of(metric);
  return std::string(text.name) + " [" + text.unit + "]";
}

}  // namespace tocsin::experiment
