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
using report::LinkClass;
using report::Recording;

constexpr double age_step_s = 0.5;

constexpr LinkClass uxv_critical{Role::uxv, TrafficClass::critical};
constexpr LinkClass uxv_high{Role::uxv, TrafficClass::high};
constexpr LinkClass uxv_low{Role::uxv, TrafficClass::low};
constexpr LinkClass gcs_high{Role::gcs, TrafficClass::high};

/// The metrics of one run while they are computed.
class MetricValues {
 public:
  MetricValues() : values_(metric_count, std::nan("")) {}
  void set(Metric metric, double value) { values_[index_of(metric)] = value; }
  [[nodiscard]] double get(Metric metric) const { return values_[index_of(metric)]; }
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
  values.set(Metric::qni_mean, mean(qni));
  values.set(Metric::qni_min,
             qni.empty() ? std::nan("") : *std::min_element(qni.begin(), qni.end()));
  values.set(Metric::probe_per_mean, mean(per));
  values.set(Metric::probe_per_max, largest(per));
}

void add_losses(const Traffic& traffic, MetricValues& values) {
  const auto& low = traffic.of(uxv_low);
  values.set(Metric::telemetry_per, lost_percent(traffic.telemetry()));
  values.set(Metric::critical_lost, lost_percent(traffic.of(uxv_critical)));
  values.set(Metric::high_lost, lost_percent(traffic.of(uxv_high)));
  values.set(Metric::low_lost, lost_percent(only(low, false)));
  values.set(Metric::camera_lost, lost_percent(only(low, true)));
  values.set(Metric::goals_lost, lost_percent(traffic.of(gcs_high)));
}

void add_latencies(const Traffic& traffic, MetricValues& values) {
  const auto high = report::spread_of(latencies_ms(traffic.of(uxv_high)));
  const auto p99 = [](const std::vector<Message>& messages) {
    return report::spread_of(latencies_ms(messages)).p99;
  };
  const auto critical = report::spread_of(latencies_ms(traffic.of(uxv_critical)));
  values.set(Metric::critical_latency_median, critical.median);
  values.set(Metric::critical_latency_p99, critical.p99);
  values.set(Metric::high_latency_median, high.median);
  values.set(Metric::high_latency_p99, high.p99);
  values.set(Metric::low_latency_p99, p99(only(traffic.of(uxv_low), false)));
  values.set(Metric::picture_latency_p99, p99(only(traffic.of(uxv_low), true)));
  values.set(Metric::goal_latency_p99, p99(traffic.of(gcs_high)));
}

/// A class that was written and of which nothing arrived is late altogether.
struct LateMetrics {
  Metric late;
  Metric very_late;
};

void add_late(const Recording& recording, const Traffic& traffic, const LinkClass& link_class,
              const LateMetrics& metrics, MetricValues& values) {
  const auto written = recording.written.find(link_class);
  const bool is_written = written != recording.written.end() && written->second > 0;
  const auto share = [&](double limit_s) {
    const double late = late_percent(traffic.of(link_class), limit_s);
    return std::isnan(late) && is_written ? 100 : late;
  };
  values.set(metrics.late, share(late_s));
  values.set(metrics.very_late, share(very_late_s));
}

void add_user_cost(const CostWeights& weights, MetricValues& values) {
  const UserFigures figures{
      values.get(Metric::critical_late),       values.get(Metric::critical_very_late),
      values.get(Metric::high_late),           values.get(Metric::high_very_late),
      values.get(Metric::low_delivered),       values.get(Metric::location_age_p99),
      values.get(Metric::picture_latency_p99), values.get(Metric::airtime)};
  values.set(Metric::user_cost, user_cost(figures, weights));
}

/// Share that arrived of what was written, over the whole run.
void add_delivered(const Recording& recording, MetricValues& values) {
  const auto share = [&](const LinkClass& link_class) {
    const auto written = recording.written.find(link_class);
    const auto arrived = recording.arrivals.find(link_class);
    if (written == recording.written.end() || written->second == 0) return std::nan("");
    const std::size_t count = arrived == recording.arrivals.end() ? 0 : arrived->second.size();
    return 100.0 * static_cast<double>(count) / static_cast<double>(written->second);
  };
  values.set(Metric::high_delivered, share(uxv_high));
  values.set(Metric::low_delivered, share(uxv_low));
}

struct AgeMetrics {
  Metric mean;
  Metric p95;
};

void add_age(const std::vector<double>& ages, const AgeMetrics& metrics, MetricValues& values) {
  values.set(metrics.mean, mean(ages));
  values.set(metrics.p95, report::percentile(ages, 0.95));
}

/// Ages of the newest received sample of a topic.
std::vector<double> ages_of(const Recording& recording, const Window& window,
                            const std::string& topic) {
  std::vector<Arrival> wanted;
  for (const auto& [link_class, arrivals] : recording.arrivals) {
    for (const Arrival& arrival : arrivals) {
      if (arrival.topic == topic && window.holds(arrival.received_s)) wanted.push_back(arrival);
    }
  }
  return report::ages(std::move(wanted), window.end_s, age_step_s);
}

void add_ages(const Recording& recording, const Window& window, MetricValues& values) {
  const auto of = [&](const char* topic) { return ages_of(recording, window, topic); };
  const auto location = of("location");
  add_age(location, {Metric::location_age_mean, Metric::location_age_p95}, values);
  values.set(Metric::location_age_p99, report::percentile(location, 0.99));
  add_age(of("network_quality"), {Metric::quality_age_mean, Metric::quality_age_p95}, values);
  add_age(of("battery_state"), {Metric::battery_age_mean, Metric::battery_age_p95}, values);
  add_age(of(camera_topic), {Metric::camera_age_mean, Metric::camera_age_p95}, values);
  add_age(of("heartbeat"), {Metric::heartbeat_age_mean, Metric::heartbeat_age_p95}, values);
  add_age(of("transmission_state"), {Metric::state_age_mean, Metric::state_age_p95}, values);
  add_age(of("cpu_load"), {Metric::cpu_age_mean, Metric::cpu_age_p95}, values);
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
  values.set(Metric::link_bytes, (last->bytes - first->bytes) * 1e-6);
  values.set(Metric::airtime,
             100 * (last->airtime_s - first->airtime_s) / (last->time_s - first->time_s));
}

void add_silences(const std::vector<report::Interval>& pauses, MetricValues& values) {
  std::vector<double> lengths_s;
  for (const auto& pause : pauses) lengths_s.push_back(pause.end_s - pause.begin_s);
  values.set(Metric::pauses, static_cast<double>(pauses.size()));
  values.set(Metric::silence_mean, mean(lengths_s));
  values.set(Metric::silence_max, pauses.empty() ? 0 : largest(lengths_s));
}

void add_truth(const std::vector<report::Interval>& poor,
               const std::vector<report::Interval>& pauses, const Window& window,
               MetricValues& values) {
  add_silences(pauses, values);
  const AgainstTruth truth = compare(poor, pauses, window.begin_s, window.end_s);
  values.set(Metric::poor_share, 100 * length_s(poor) / window.length_s());
  values.set(Metric::poor_intervals, truth.intervals);
  values.set(Metric::missed, truth.missed);
  values.set(Metric::detect, truth.detect_s);
  values.set(Metric::resume, truth.resume_s);
  values.set(Metric::sent_in_poor, truth.sent_in_poor);
  values.set(Metric::silent_in_good, truth.silent_in_good);
}

void add_series(const std::vector<Observation>& series, MetricValues& values) {
  std::vector<double> pers;
  double stalled = 0;
  for (const Observation& one : series) {
    if (one.sent >= 10) pers.push_back(100 * one.lost / one.sent);
    stalled += one.stalled ? 1 : 0;
  }
  values.set(Metric::telemetry_per_max, largest(pers));
  const SlotCost cost = slot_cost(series);
  values.set(Metric::slot_cost, cost.own);
  values.set(Metric::slot_regret, cost.own - cost.clairvoyant);
  values.set(Metric::stalled,
             series.empty() ? std::nan("") : 100 * stalled / static_cast<double>(series.size()));
}

void add_mission(const Recording& recording, MetricValues& values) {
  const bool done = recording.mission.state == "done";
  values.set(Metric::completed, done ? 1 : 0);
  values.set(Metric::completion, done ? recording.mission.elapsed_s : std::nan(""));
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
  add_late(recording, traffic, uxv_critical, {Metric::critical_late, Metric::critical_very_late},
           values);
  add_late(recording, traffic, uxv_high, {Metric::high_late, Metric::high_very_late}, values);
  add_delivered(recording, values);
  add_ages(recording, window, values);
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
