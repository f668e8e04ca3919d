// SPDX-License-Identifier: Apache-2.0
#include "report/summary.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::report {
namespace {

constexpr double age_step_s = 0.1;
constexpr const char* goal_topic = "goal";

std::map<std::string, std::vector<Arrival>> by_topic(const std::vector<Arrival>& arrivals) {
  std::map<std::string, std::vector<Arrival>> topics;
  for (const Arrival& arrival : arrivals) topics[arrival.topic].push_back(arrival);
  return topics;
}

/// Those that were sent in an interval.
std::vector<Arrival> sent_in(const std::vector<Arrival>& arrivals, const Interval& interval) {
  std::vector<Arrival> some;
  for (const Arrival& arrival : arrivals) {
    if (arrival.sent_s >= interval.begin_s && arrival.sent_s < interval.end_s) {
      some.push_back(arrival);
    }
  }
  return some;
}

/// Values of all intervals, before they become percentiles.
struct Collected {
  std::vector<double> latencies_s;
  std::vector<double> ages_s;
  double bytes = 0;
  double length_s = 0;
};

void collect(const std::vector<Arrival>& arrivals, const Interval& interval, Collected& all) {
  for (const Arrival& arrival : arrivals) {
    all.latencies_s.push_back(arrival.received_s - arrival.sent_s);
    all.bytes += std::isfinite(arrival.bytes) ? arrival.bytes : 0;
  }
  for (const auto& [topic, part] : by_topic(arrivals)) {
    const auto of_topic = ages(part, interval.end_s, age_step_s);
    all.ages_s.insert(all.ages_s.end(), of_topic.begin(), of_topic.end());
  }
  all.length_s += interval.end_s - interval.begin_s;
}

/// What came of a class, or of a topic.
struct Came {
  std::vector<Arrival> live;
  std::vector<Arrival> backfilled;
};

Traffic traffic_of(const std::string& name, const Came& came,
                   const std::vector<Interval>& intervals) {
  Traffic traffic;
  traffic.name = name;
  Collected all;
  for (const Interval& interval : intervals) {
    const std::vector<Arrival> live = sent_in(came.live, interval);
    const Fates fates = fates_of(live, sent_in(came.backfilled, interval));
    traffic.received += live.size();
    traffic.backfilled += fates.backfilled;
    traffic.lost += fates.lost;
    collect(live, interval, all);
  }
  traffic.latency_s = spread_of(all.latencies_s);
  traffic.age_s = spread_of(all.ages_s);
  traffic.bytes_per_s = all.length_s > 0 ? all.bytes / all.length_s : 0;
  return traffic;
}

std::map<LinkClass, Came> came_of(const Recording& recording) {
  std::map<LinkClass, Came> all;
  for (const auto& [link_class, arrivals] : recording.arrivals) all[link_class].live = arrivals;
  for (const auto& [link_class, arrivals] : recording.backfilled) {
    all[link_class].backfilled = arrivals;
  }
  return all;
}

std::map<std::string, Came> by_topic(const Came& came) {
  std::map<std::string, Came> topics;
  for (const Arrival& one : came.live) topics[one.topic].live.push_back(one);
  for (const Arrival& one : came.backfilled) topics[one.topic].backfilled.push_back(one);
  return topics;
}

void add_traffic(const Recording& recording, Summary& summary) {
  const std::vector<Interval> whole{{recording.begin_s, std::nextafter(recording.end_s, HUGE_VAL)}};
  std::vector<Traffic> goals;
  for (const auto& [link_class, came] : came_of(recording)) {
    summary.classes.push_back(traffic_of(to_string(link_class), came, whole));
    for (const auto& [topic, part] : by_topic(came)) {
      const std::string sender = to_string(link_class.sender);
      summary.topics.push_back(traffic_of(sender + " " + topic, part, whole));
      if (link_class.sender != Role::gcs || topic != goal_topic) continue;
      goals.push_back(summary.topics.back());
      goals.back().name = "goals";
    }
  }
  summary.classes.insert(summary.classes.end(), goals.begin(), goals.end());
}

void add_poor_traffic(const Recording& recording, Summary& summary) {
  const std::vector<Interval> poor = poor_intervals(recording);
  for (const Interval& interval : poor) summary.poor_s += interval.end_s - interval.begin_s;
  if (poor.empty()) return;
  for (const auto& [link_class, came] : came_of(recording)) {
    summary.classes.push_back(traffic_of(to_string(link_class) + ", poor", came, poor));
  }
}

void add_pauses(const Recording& recording, Summary& summary) {
  for (const Interval& pause : pauses_of(recording)) {
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
  const auto sent = static_cast<double>(received + backfilled + lost);
  return sent > 0 ? 100 * static_cast<double>(lost) / sent : std::nan("");
}

std::vector<Interval> poor_intervals(const Recording& recording) {
  std::vector<Interval> intervals;
  bool poor = false;
  for (const Decision& decision : recording.decisions) {
    const bool now_poor = decision.qni < poor_below_qni;
    if (now_poor && !poor) intervals.push_back({decision.time_s, recording.end_s});
    if (!now_poor && poor) intervals.back().end_s = decision.time_s;
    poor = now_poor;
  }
  return intervals;
}

std::vector<Interval> pauses_of(const Recording& recording) {
  std::vector<Interval> pauses;
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
  add_poor_traffic(recording, summary);
  return summary;
}

}  // namespace tocsin::report
