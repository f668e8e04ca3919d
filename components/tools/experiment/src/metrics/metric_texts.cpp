// SPDX-License-Identifier: Apache-2.0
// The one place where a metric is named and defined for readers.
#include <algorithm>
#include <cassert>
#include <iterator>

#include "metrics/metrics.hpp"

namespace tocsin::experiment {

namespace {

constexpr MetricText table[] = {
    {"qni_mean", "%", "network quality indicator, mean over the vehicle's decisions", false},
    {"qni_min", "%", "the lowest QNI of the run", false},
    {"probe_per_mean", "%",
     "share of ICMP echoes without an answer: mean over the vehicle's measurements", true},
    {"probe_per_max", "%", "the highest of these measurements (20 echoes each)", true},
    {"telemetry_per", "%",
     "share of the vehicle's samples that were put on the link and never arrived, all topics "
     "but the camera; what the gate held back was not sent",
     true},
    {"telemetry_per_max", "%",
     "the highest share lost in one observation (at least 10 samples sent in it)", true},
    {"user_cost", "1",
     "one cost of what users feel: weighted sum of the late shares of class critical and high, of "
     "class low not delivered, of the age of the location, of the delay of pictures and of "
     "airtime; the weights are the experiment file's, in units of one percent of class low",
     true},
    {"critical_late", "%",
     "share of samples sent that came later than 250 ms or never, class critical of the vehicle",
     true},
    {"critical_very_late", "%", "the same, later than 1 s or never", true},
    {"high_late", "%", "share that came later than 250 ms or never, class high", true},
    {"high_very_late", "%", "the same, later than 1 s or never", true},
    {"critical_lost", "%",
     "share of samples sent that never arrived, repaired or not, class critical of the vehicle",
     true},
    {"high_lost", "%", "the same of class high", true},
    {"low_lost", "%", "the same of class low without the camera", true},
    {"camera_lost", "%", "the same of the camera", true},
    {"goals_lost", "%", "the same of the ground station's goals (class high)", true},
    {"high_delivered", "%",
     "share that arrived of all that the vehicle's components wrote, class high", false},
    {"low_delivered", "%", "the same of class low, camera included, held back ones counted", false},
    {"critical_latency_median", "ms", "from write to receipt, median, class critical", true},
    {"critical_latency_p99", "ms", "the same, 99th percentile", true},
    {"high_latency_median", "ms", "from write to receipt, median, class high", true},
    {"high_latency_p99", "ms", "the same, 99th percentile", true},
    {"low_latency_p99", "ms", "the same, class low without the camera", true},
    {"picture_latency_p99", "ms", "from write to receipt of a whole picture, 99th percentile",
     true},
    {"goal_latency_p99", "ms", "from write to receipt of the ground station's goals", true},
    {"location_age_mean", "s",
     "age of the newest received sample at the ground station, looked at each half second: mean",
     true},
    {"location_age_p95", "s", "the same, 95th percentile", true},
    {"location_age_p99", "s", "the same, 99th percentile", true},
    {"quality_age_mean", "s", "network quality: the same, mean", true},
    {"quality_age_p95", "s", "network quality: 95th percentile", true},
    {"battery_age_mean", "s", "battery state (class low): mean", true},
    {"battery_age_p95", "s", "battery state (class low): 95th percentile", true},
    {"camera_age_mean", "s", "camera (class low): mean", true},
    {"camera_age_p95", "s", "camera (class low): 95th percentile", true},
    {"heartbeat_age_mean", "s", "heartbeat (class critical): mean", true},
    {"heartbeat_age_p95", "s", "heartbeat (class critical): 95th percentile", true},
    {"state_age_mean", "s", "transmission state (class critical): mean", true},
    {"state_age_p95", "s", "transmission state (class critical): 95th percentile", true},
    {"cpu_age_mean", "s", "CPU load (class low): mean", true},
    {"cpu_age_p95", "s", "CPU load (class low): 95th percentile", true},
    {"link_bytes", "MB", "IP packets given to the radio, both directions", true},
    {"airtime", "%", "share of the run that our frames and acknowledgements were on the air", true},
    {"poor_share", "%", "share of the run in which the link was truly poor", true},
    {"poor_intervals", "1",
     "truly poor intervals of at least two observations; shorter gaps do not divide one", true},
    {"missed", "1", "of these, without any pause", true},
    {"detect", "s",
     "from the begin of a truly poor interval, where the clairvoyant pauses, to the pause: mean "
     "over the intervals that had one",
     true},
    {"resume", "s",
     "from the end of a truly poor interval, where the clairvoyant resumes, to speaking: mean",
     true},
    {"sent_in_poor", "%", "share of the truly poor time in which the gate was open", true},
    {"silent_in_good", "%", "share of the other time in which it was closed", true},
    {"slot_cost", "1",
     "cost per 1000 observations: 1 for one spoken in while the link was truly poor (for more than "
     "half of it), 0.5 for a silent one while it was good, 0.1 for a silent one while poor, 0.5 "
     "for each change; the costs of the decision library, to which `fit` fits the policies",
     true},
    {"slot_regret", "1",
     "the same, minus the cost of the clairvoyant, who knows the truth beforehand and is never "
     "silent for more than 30 observations",
     true},
    {"pauses", "1", "pauses of the vehicle", true},
    {"silence_mean", "s", "length of a pause, mean", true},
    {"silence_max", "s", "length of the longest pause", true},
    {"completion", "s", "from the first goal to the last waypoint; none when it was not reached",
     true},
    {"completed", "1", "1 when the mission was done within the run", false},
    {"stalled", "%", "share of observations in which the machine froze (real runs)", true},
};

}  // namespace

const std::vector<MetricText>& metric_texts() {
  static const std::vector<MetricText> texts(std::begin(table), std::end(table));
  return texts;
}

std::size_t metric_index(const std::string& name) {
  const auto& texts = metric_texts();
  const auto found = std::find_if(texts.begin(), texts.end(),
                                  [&](const MetricText& text) { return name == text.name; });
  assert(found != texts.end());
  return static_cast<std::size_t>(found - texts.begin());
}

std::string metric_label(const std::string& name) {
  return name + " [" + metric_texts()[metric_index(name)].unit + "]";
}

}  // namespace tocsin::experiment
