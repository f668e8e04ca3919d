// SPDX-License-Identifier: Apache-2.0
#include "metrics/series.hpp"

#include <algorithm>
#include <cmath>

#include "metrics/truth.hpp"

namespace tocsin::experiment {
namespace {

/// Finds the observation of an instant.
class Grid {
 public:
  Grid(const Window& window, double step_s, std::size_t count)
      : window_(window), step_s_(step_s), count_(count) {}
  /// `count` when the instant is in none.
  [[nodiscard]] std::size_t at(double time_s) const {
    if (!window_.holds(time_s)) return count_;
    return std::min(count_, static_cast<std::size_t>((time_s - window_.begin_s) / step_s_));
  }

 private:
  Window window_;
  double step_s_;
  std::size_t count_;
};

void add_decisions(const report::Recording& recording, const Grid& grid,
                   std::vector<Observation>& series) {
  for (const auto& decision : recording.decisions) {
    const std::size_t i = grid.at(decision.time_s);
    if (i < series.size() && std::isfinite(decision.qni)) series[i].qni = decision.qni;
  }
  for (const auto& quality : recording.qualities) {
    const std::size_t i = grid.at(quality.time_s);
    if (i < series.size()) series[i].probe_per = quality.per_percent;
  }
}

void add_link(const report::Recording& recording, const Grid& grid,
              std::vector<Observation>& series) {
  std::vector<int> counts(series.size(), 0);
  for (const auto& state : recording.link) {
    const std::size_t i = grid.at(state.time_s);
    if (i >= series.size()) continue;
    series[i].snr_db = (counts[i] > 0 ? series[i].snr_db : 0) + state.mean_snr_db;
    ++counts[i];
    series[i].stalled = series[i].stalled || state.late_ms > stall_ms;
  }
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (counts[i] > 0) series[i].snr_db /= counts[i];
  }
}

void add_messages(const std::vector<Message>& messages, const Grid& grid,
                  std::vector<Observation>& series) {
  std::vector<std::vector<double>> latencies(series.size());
  for (const Message& message : messages) {
    const std::size_t i = grid.at(message.sent_s);
    if (i >= series.size()) continue;
    series[i].sent += 1;
    if (message.lost()) {
      series[i].lost += 1;
    } else {
      latencies[i].push_back(1000 * message.latency_s);
    }
  }
  for (std::size_t i = 0; i < series.size(); ++i) {
    series[i].latency_ms = report::percentile(std::move(latencies[i]), 0.5);
  }
}

void add_activity(const report::Recording& recording, double step_s,
                  std::vector<Observation>& series, double begin_s) {
  const auto pauses = report::pauses_of(recording);
  for (Observation& one : series) {
    const double from_s = begin_s + one.time_s;
    one.active = 1 - common_s(pauses, {{from_s, from_s + step_s}}) / step_s;
  }
}

}  // namespace

std::vector<report::Interval> within(const std::vector<report::Interval>& intervals,
                                     const Window& window) {
  std::vector<report::Interval> result;
  for (const auto& one : intervals) {
    const double from_s = std::max(one.begin_s, window.begin_s);
    const double until_s = std::min(one.end_s, window.end_s);
    if (until_s > from_s) result.push_back({from_s, until_s});
  }
  return result;
}

Traffic::Traffic(const report::Recording& recording, const Window& window) {
  for (const auto& [link_class, arrivals] : recording.arrivals) {
    const auto& messages = classes_[link_class] =
        messages_of(arrivals, window.begin_s, window.end_s);
    if (link_class.sender != Role::uxv) continue;
    for (const Message& message : messages) {
      if (!message.camera) telemetry_.push_back(message);
    }
  }
}

const std::vector<Message>& Traffic::of(const report::LinkClass& link_class) const {
  static const std::vector<Message> none;
  const auto found = classes_.find(link_class);
  return found == classes_.end() ? none : found->second;
}

std::vector<Observation> observe(const report::Recording& recording, const Traffic& traffic,
                                 const Window& window, double step_s) {
  const auto count = static_cast<std::size_t>(window.length_s() / step_s + 1e-9);
  std::vector<Observation> series;
  for (std::size_t i = 0; i < count; ++i) {
    series.push_back({static_cast<double>(i) * step_s, std::nan(""), std::nan(""), std::nan(""), 1,
                      0, 0, 0, std::nan(""), false});
  }
  const Grid grid(window, step_s, count);
  add_decisions(recording, grid, series);
  add_link(recording, grid, series);
  add_messages(traffic.telemetry(), grid, series);
  add_activity(recording, step_s, series, window.begin_s);
  return series;
}

void mark_poor(const std::vector<report::Interval>& poor, const Window& window, double step_s,
               std::vector<Observation>& series) {
  for (Observation& one : series) {
    const double from_s = window.begin_s + one.time_s;
    one.poor = common_s(poor, {{from_s, from_s + step_s}}) / step_s;
  }
}

}  // namespace tocsin::experiment
