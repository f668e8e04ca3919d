// SPDX-License-Identifier: Apache-2.0
#include "summary.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::report {
namespace {

constexpr double age_step_s = 0.1;

using Topics = std::map<std::string, std::vector<Arrival>>;

Topics by_topic(const std::vector<Arrival>& arrivals) {
  Topics topics;
  for (const Arrival& arrival : arrivals) topics[arrival.topic].push_back(arrival);
  return topics;
}

Traffic traffic_of(const std::string& name, const std::vector<Arrival>& arrivals,
                   const Recording& recording) {
  Traffic traffic;
  traffic.name = name;
  traffic.received = arrivals.size();
  traffic.lost = lost(arrivals);
  std::vector<double> latencies;
  double bytes = 0;
  for (const Arrival& arrival : arrivals) {
    latencies.push_back(arrival.received_s - arrival.sent_s);
    bytes += std::isfinite(arrival.bytes) ? arrival.bytes : 0;
  }
  traffic.latency_s = spread_of(latencies);
  std::vector<double> all_ages;
  for (const auto& [topic, part] : by_topic(arrivals)) {
    const auto of_topic = ages(part, recording.end_s, age_step_s);
    all_ages.insert(all_ages.end(), of_topic.begin(), of_topic.end());
  }
  traffic.age_s = spread_of(all_ages);
  const double length_s = recording.end_s - recording.begin_s;
  traffic.bytes_per_s = length_s > 0 ? bytes / length_s : 0;
  return traffic;
}

void add_traffic(const Recording& recording, Summary& summary) {
  for (const auto& [name, arrivals] : recording.arrivals) {
    summary.classes.push_back(traffic_of(name, arrivals, recording));
    for (const auto& [topic, part] : by_topic(arrivals)) {
      const std::string sender = name.substr(0, name.find(' '));
      summary.topics.push_back(traffic_of(sender + " " + topic, part, recording));
    }
  }
  for (const Traffic& topic : summary.topics) {
    if (topic.name == "gcs goal") summary.classes.push_back(topic);
  }
  if (!summary.classes.empty() && summary.classes.back().name == "gcs goal") {
    summary.classes.back().name = "goals";
  }
}

void add_pauses(const Recording& recording, Summary& summary) {
  for (const Pause& pause : pauses_of(recording)) {
    const double length_s = pause.end_s - pause.begin_s;
    ++summary.pauses;
    summary.paused_s += length_s;
    summary.longest_pause_s = std::max(summary.longest_pause_s, length_s);
  }
}

void add_quality(const Recording& recording, Summary& summary) {
  std::vector<double> qnis;
  std::vector<double> pers;
  for (const Decision& decision : recording.decisions) {
    if (std::isfinite(decision.qni)) qnis.push_back(decision.qni);
  }
  for (const Quality& quality : recording.qualities) {
    if (std::isfinite(quality.per_percent)) pers.push_back(quality.per_percent);
  }
  summary.qni_median = percentile(qnis, 0.5);
  summary.qni_min = qnis.empty() ? std::nan("") : *std::min_element(qnis.begin(), qnis.end());
  summary.per_percent = spread_of(pers);
}

}  // namespace

double Traffic::lost_percent() const {
  const auto sent = static_cast<double>(received + lost);
  return sent > 0 ? 100 * static_cast<double>(lost) / sent : std::nan("");
}

std::vector<Pause> pauses_of(const Recording& recording) {
  std::vector<Pause> pauses;
  bool active = true;
  for (const Decision& decision : recording.decisions) {
    if (active && !decision.active) pauses.push_back({decision.time_s, recording.end_s});
    if (!active && decision.active) pauses.back().end_s = decision.time_s;
    active = decision.active;
  }
  return pauses;
}

Summary summarise(const Recording& recording) {
  Summary summary;
  summary.mission = recording.mission;
  summary.policy = recording.decisions.empty() ? "unknown" : recording.decisions.back().policy;
  summary.length_s = recording.end_s - recording.begin_s;
  add_pauses(recording, summary);
  add_quality(recording, summary);
  add_traffic(recording, summary);
  return summary;
}

}  // namespace tocsin::report
