// SPDX-License-Identifier: Apache-2.0
#include "metrics/metrics.hpp"

#include <algorithm>
#include <cmath>

#include "metrics/messages.hpp"
#include "metrics/series.hpp"
#include "metrics/slot_cost.hpp"
#include "metrics/truth.hpp"
#include "metrics/user_cost.hpp"

namespace tocsin::experiment {
namespace {

using report::Arrival;
using report::Recording;

constexpr double age_step_s = 0.5;

/// The metrics of one run while they are computed.
class MetricValues {
 public:
  MetricValues() : values_(metric_texts().size(), std::nan("")) {}
  void set(const char* name, double value) { values_[metric_index(name)] = value; }
  [[nodiscard]] double get(const char* name) const { return values_[metric_index(name)]; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }

 private:
  std::vector<double> values_;
};

double lost_percent(const std::vector<Message>& messages) {
  if (messages.empty()) return std::nan("");
  const auto lost = std::count_if(messages.begin(), messages.end(),
                                  [](const Message& message) { return message.lost(); });
  return 100.0 * static_cast<double>(lost) / static_cast<double>(messages.size());
}

std::vector<double> latencies_ms(const std::vector<Message>& messages) {
  std::vector<double> latencies;
  for (const Message& message : messages) {
    if (!message.lost()) latencies.push_back(1000 * message.latency_s);
  }
  return latencies;
}

/// Pictures, or everything else.
std::vector<Message> only(const std::vector<Message>& messages, bool camera) {
  std::vector<Message> result;
  for (const Message& message : messages) {
    if (message.camera == camera) result.push_back(message);
  }
  return result;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? std::nan("") : sum / static_cast<double>(values.size());
}

double largest(const std::vector<double>& values) {
  return values.empty() ? std::nan("") : *std::max_element(values.begin(), values.end());
}

void add_quality(const Recording& recording, const Window& window, MetricValues& values) {
  std::vector<double> qni;
  std::vector<double> per;
  for (const auto& decision : recording.decisions) {
    if (window.holds(decision.time_s) && std::isfinite(decision.qni)) qni.push_back(decision.qni);
  }
  for (const auto& quality : recording.qualities) {
    if (window.holds(quality.time_s) && std::isfinite(quality.per_percent)) {
      per.push_back(quality.per_percent);
    }
  }
  values.set("qni_mean", mean(qni));
  values.set("qni_min", qni.empty() ? std::nan("") : *std::min_element(qni.begin(), qni.end()));
  values.set("probe_per_mean", mean(per));
  values.set("probe_per_max", largest(per));
}

void add_losses(const Traffic& traffic, MetricValues& values) {
  const auto& low = traffic.of("uxv low");
  values.set("telemetry_per", lost_percent(traffic.telemetry()));
  values.set("critical_lost", lost_percent(traffic.of("uxv critical")));
  values.set("high_lost", lost_percent(traffic.of("uxv high")));
  values.set("low_lost", lost_percent(only(low, false)));
  values.set("camera_lost", lost_percent(only(low, true)));
  values.set("goals_lost", lost_percent(traffic.of("gcs high")));
}

void add_latencies(const Traffic& traffic, MetricValues& values) {
  const auto high = report::spread_of(latencies_ms(traffic.of("uxv high")));
  const auto p99 = [](const std::vector<Message>& messages) {
    return report::spread_of(latencies_ms(messages)).p99;
  };
  const auto critical = report::spread_of(latencies_ms(traffic.of("uxv critical")));
  values.set("critical_latency_median", critical.median);
  values.set("critical_latency_p99", critical.p99);
  values.set("high_latency_median", high.median);
  values.set("high_latency_p99", high.p99);
  values.set("low_latency_p99", p99(only(traffic.of("uxv low"), false)));
  values.set("picture_latency_p99", p99(only(traffic.of("uxv low"), true)));
  values.set("goal_latency_p99", p99(traffic.of("gcs high")));
}

/// A class that was written and of which nothing arrived is late altogether.
void add_late(const Recording& recording, const Traffic& traffic, const std::string& traffic_class,
              MetricValues& values) {
  const std::string name = "uxv " + traffic_class;
  const auto written = recording.written.find(name);
  const bool is_written = written != recording.written.end() && written->second > 0;
  const auto share = [&](double limit_s) {
    const double late = late_percent(traffic.of(name), limit_s);
    return std::isnan(late) && is_written ? 100 : late;
  };
  values.set((traffic_class + "_late").c_str(), share(late_s));
  values.set((traffic_class + "_very_late").c_str(), share(very_late_s));
}

void add_user_cost(const CostWeights& weights, MetricValues& values) {
  const UserFigures figures{values.get("critical_late"),       values.get("critical_very_late"),
                            values.get("high_late"),           values.get("high_very_late"),
                            values.get("low_delivered"),       values.get("location_age_p99"),
                            values.get("picture_latency_p99"), values.get("airtime")};
  values.set("user_cost", user_cost(figures, weights));
}

/// Share that arrived of what was written, over the whole run.
void add_delivered(const Recording& recording, MetricValues& values) {
  const auto share = [&](const char* name) {
    const auto written = recording.written.find(name);
    const auto arrived = recording.arrivals.find(name);
    if (written == recording.written.end() || written->second == 0) return std::nan("");
    const std::size_t count = arrived == recording.arrivals.end() ? 0 : arrived->second.size();
    return 100.0 * static_cast<double>(count) / static_cast<double>(written->second);
  };
  values.set("high_delivered", share("uxv high"));
  values.set("low_delivered", share("uxv low"));
}

void add_age(const Recording& recording, const Window& window, const std::string& name,
             const std::string& topic, MetricValues& values) {
  std::vector<Arrival> wanted;
  for (const auto& [name_of_class, arrivals] : recording.arrivals) {
    for (const Arrival& arrival : arrivals) {
      if (arrival.topic == topic && window.holds(arrival.received_s)) wanted.push_back(arrival);
    }
  }
  const std::vector<double> ages = report::ages(std::move(wanted), window.end_s, age_step_s);
  values.set((name + "_age_mean").c_str(), mean(ages));
  values.set((name + "_age_p95").c_str(), report::percentile(ages, 0.95));
  if (name == "location") values.set("location_age_p99", report::percentile(ages, 0.99));
}

void add_link(const Recording& recording, const Window& window, MetricValues& values) {
  const report::LinkState* first = nullptr;
  const report::LinkState* last = nullptr;
  for (const auto& state : recording.link) {
    if (!window.holds(state.time_s)) continue;
    if (first == nullptr) first = &state;
    last = &state;
  }
  if (first == last) return;
  values.set("link_bytes", (last->bytes - first->bytes) * 1e-6);
  values.set("airtime",
             100 * (last->airtime_s - first->airtime_s) / (last->time_s - first->time_s));
}

void add_silences(const std::vector<report::Interval>& pauses, MetricValues& values) {
  std::vector<double> lengths_s;
  for (const auto& pause : pauses) lengths_s.push_back(pause.end_s - pause.begin_s);
  values.set("pauses", static_cast<double>(pauses.size()));
  values.set("silence_mean", mean(lengths_s));
  values.set("silence_max", pauses.empty() ? 0 : largest(lengths_s));
}

void add_truth(const std::vector<report::Interval>& poor,
               const std::vector<report::Interval>& pauses, const Window& window,
               MetricValues& values) {
  add_silences(pauses, values);
  const AgainstTruth truth = compare(poor, pauses, window.begin_s, window.end_s);
  values.set("poor_share", 100 * length_s(poor) / window.length_s());
  values.set("poor_intervals", truth.intervals);
  values.set("missed", truth.missed);
  values.set("detect", truth.detect_s);
  values.set("resume", truth.resume_s);
  values.set("sent_in_poor", truth.sent_in_poor);
  values.set("silent_in_good", truth.silent_in_good);
}

void add_series(const std::vector<Observation>& series, MetricValues& values) {
  std::vector<double> pers;
  double stalled = 0;
  for (const Observation& one : series) {
    if (one.sent >= 10) pers.push_back(100 * one.lost / one.sent);
    stalled += one.stalled ? 1 : 0;
  }
  values.set("telemetry_per_max", largest(pers));
  const SlotCost cost = slot_cost(series);
  values.set("slot_cost", cost.own);
  values.set("slot_regret", cost.own - cost.clairvoyant);
  values.set("stalled",
             series.empty() ? std::nan("") : 100 * stalled / static_cast<double>(series.size()));
}

void add_mission(const Recording& recording, MetricValues& values) {
  const bool done = recording.mission.state == "done";
  values.set("completed", done ? 1 : 0);
  values.set("completion", done ? recording.mission.elapsed_s : std::nan(""));
}

}  // namespace

Measures measure(const Recording& recording, const Timing& timing) {
  const Window window{recording.begin_s + timing.warm_up_s, recording.end_s};
  if (!(window.end_s > window.begin_s)) return {MetricValues().values(), {}};
  const Traffic traffic(recording, window);
  MetricValues values;
  add_quality(recording, window, values);
  add_losses(traffic, values);
  add_latencies(traffic, values);
  add_late(recording, traffic, "critical", values);
  add_late(recording, traffic, "high", values);
  add_delivered(recording, values);
  add_age(recording, window, "location", "location", values);
  add_age(recording, window, "quality", "network_quality", values);
  add_age(recording, window, "battery", "battery_state", values);
  add_age(recording, window, "camera", camera_topic, values);
  add_age(recording, window, "heartbeat", "heartbeat", values);
  add_age(recording, window, "state", "transmission_state", values);
  add_age(recording, window, "cpu", "cpu_load", values);
  add_link(recording, window, values);
  add_user_cost(timing.cost, values);
  const PoorLink limits{timing.poor_below_snr_db, 2 * timing.observation_s};
  const auto poor = truly_poor(recording.link, limits, window.begin_s, window.end_s);
  add_truth(poor, within(report::pauses_of(recording), window), window, values);
  add_mission(recording, values);
  auto series = observe(recording, traffic, window, timing.observation_s);
  mark_poor(poor, window, timing.observation_s, series);
  add_series(series, values);
  return {values.values(), std::move(series)};
}

}  // namespace tocsin::experiment
