// SPDX-License-Identifier: Apache-2.0
#include "link_run.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "router_radio.hpp"

namespace tocsin::bench {
namespace {

constexpr Duration age_period = std::chrono::milliseconds(100);
/// Share of the shrinking that is done by size; the rest by rate.
constexpr double size_share = 0.9;

std::size_t side_of(radio::Direction direction) {
  return direction == radio::Direction::uplink ? 0 : 1;
}

/// The value below which `share` of them lie; 0 of none. Sorts them.
double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

/// A sample that a component wrote.
struct Written {
  Time time;
  bool delivered = false;
  Duration latency{0};
  std::size_t bytes = 0;
};

/// A component that adapts: fewer and smaller samples.
class AdaptiveSource {
 public:
  /// The size of the picture to send, if any.
  std::optional<std::size_t> shrink(std::size_t bytes, const router::StreamBudget& budget) {
    due_ = std::min(due_ + std::pow(budget.scale, 1 - size_share), 2.0);
    if (due_ < 1 || budget.hold) return std::nullopt;
    due_ -= 1;
    return static_cast<std::size_t>(static_cast<double>(bytes) *
                                    std::pow(budget.scale, size_share));
  }

 private:
  double due_ = 0;
};

class LinkRun {
 public:
  LinkRun(const MissionTraffic& traffic, const Steps& steps, std::uint64_t seed)
      : traffic_(traffic),
        steps_(steps),
        channel_(channel_of(traffic, steps), traffic.walls, seed, traffic.begin),
        second_(second_of(traffic, steps, seed)),
        routers_(channel_, {steps.params, steps.dscp, second_.get()}, traffic.begin),
        written_(traffic.sources.size()) {
    for (std::size_t i = 0; i < traffic.sources.size(); ++i) add_source(i);
    next_age_ = traffic.begin + warm_up;
  }

  [[nodiscard]] std::vector<bool> critical_misses() const {
    return collect(TrafficClass::critical, false).missed;
  }

  Figures run() {
    const auto deliver = [this](std::size_t, router::StreamId stream, const router::Origin& origin,
                                Time at) { on_delivered(stream, origin, at); };
    for (Time now = traffic_.begin; now < traffic_.end;) {
      play_due(now);
      routers_.serve(now);
      const Time next = std::min({next_input(), routers_.next_event(now), traffic_.end});
      now = std::max(next, now + Duration{1});
      routers_.advance(now, deliver);
    }
    return figures();
  }

 private:
  static radio::ChannelParams channel_of(const MissionTraffic& traffic, const Steps& steps) {
    radio::ChannelParams params = steps.first.value_or(traffic.channel);
    params.access_categories = steps.categories;
    return params;
  }

  static std::unique_ptr<radio::RadioChannel> second_of(const MissionTraffic& traffic,
                                                        const Steps& steps, std::uint64_t seed) {
    if (!steps.second) return nullptr;
    return std::make_unique<radio::RadioChannel>(*steps.second, traffic.walls, seed, traffic.begin);
  }

  void add_source(std::size_t i) {
    const TrafficSource& source = traffic_.sources[i];
    router::StreamRule rule = source.rule;
    rule.repaired = rule.repaired && steps_.repair;
    rule.durable = rule.durable && steps_.repair;
    if (policy_of(rule.traffic_class).repaired) rule.paths = steps_.urgent;
    routers_.add_stream(side_of(source.direction), static_cast<router::StreamId>(i), rule,
                        traffic_.begin);
  }

  [[nodiscard]] Time next_input() const {
    Time next = next_age_;
    if (write_ < traffic_.writes.size()) next = std::min(next, traffic_.writes[write_].time);
    if (place_ < traffic_.places.size()) next = std::min(next, traffic_.places[place_].time);
    if (echo_ < traffic_.echoes.size()) next = std::min(next, traffic_.echoes[echo_]);
    if (gate_ < traffic_.gates.size()) next = std::min(next, traffic_.gates[gate_].time);
    return next;
  }

  void play_due(Time now) {
    for (; place_ < traffic_.places.size() && traffic_.places[place_].time <= now; ++place_) {
      channel_.set_position(traffic_.places[place_].x_m, traffic_.places[place_].y_m);
      if (second_) second_->set_position(traffic_.places[place_].x_m, traffic_.places[place_].y_m);
    }
    for (; gate_ < traffic_.gates.size() && traffic_.gates[gate_].time <= now; ++gate_) {
      if (steps_.pause) routers_.sender(0).set_paused(!traffic_.gates[gate_].open, now);
    }
    for (; echo_ < traffic_.echoes.size() && traffic_.echoes[echo_] <= now; ++echo_) {
      routers_.send_echo(now);
    }
    for (; write_ < traffic_.writes.size() && traffic_.writes[write_].time <= now; ++write_) {
      write(traffic_.writes[write_], now);
    }
    for (; next_age_ <= now; next_age_ += age_period) note_age(next_age_);
  }

  void write(const MissionTraffic::Write& write, Time now) {
    const TrafficSource& source = traffic_.sources[write.source];
    router::LinkSender& sender = routers_.sender(side_of(source.direction));
    std::size_t bytes = write.bytes;
    if (source.rule.adaptive && steps_.adaptation) {
      for (const router::StreamBudget& budget : sender.budgets(now)) {
        if (budget.stream != write.source) continue;
        const auto shrunk = camera_.shrink(bytes, budget);
        if (!shrunk) return;
        bytes = *shrunk;
      }
    }
    auto& written = written_[write.source];
    written.push_back({now, false, {}, bytes});
    sender.offer(static_cast<router::StreamId>(write.source),
                 {{write.source, written.size(), now}, bytes, nullptr}, now);
  }

  void on_delivered(router::StreamId stream, const router::Origin& origin, Time now) {
    Written& written = written_[stream][origin.sequence - 1];
    written.delivered = true;
    written.latency = now - written.time;
    if (traffic_.sources[stream].topic == "location") location_ = written.time;
  }

  void note_age(Time at) {
    if (location_) ages_.push_back(to_seconds(at - *location_));
  }

  struct Class {
    std::vector<double> latencies_ms;
    double written = 0;
    double late = 0;
    double lost = 0;
    std::vector<bool> missed;
    double unplugged = 0;
    double unplugged_late = 0;
  };
  [[nodiscard]] bool is_of_unplugging(Time time) const {
    return steps_.unplugged && time >= *steps_.unplugged &&
           time < *steps_.unplugged + std::chrono::seconds(2);
  }

  [[nodiscard]] Class collect(TrafficClass traffic_class, bool adaptive_only) const {
    Class of;
    for (std::size_t i = 0; i < written_.size(); ++i) {
      const TrafficSource& source = traffic_.sources[i];
      if (source.direction != radio::Direction::uplink ||
          source.rule.traffic_class != traffic_class)
        continue;
      if (adaptive_only && !source.rule.adaptive) continue;
      for (const Written& one : written_[i]) {
        if (one.time < traffic_.begin + warm_up || one.time + late_after > traffic_.end) continue;
        ++of.written;
        of.missed.push_back(!one.delivered || one.latency > late_after);
        if (!one.delivered) ++of.lost;
        if (!one.delivered || one.latency > late_after) ++of.late;
        if (one.delivered) of.latencies_ms.push_back(1e3 * to_seconds(one.latency));
        if (!is_of_unplugging(one.time)) continue;
        ++of.unplugged;
        if (of.missed.back()) ++of.unplugged_late;
      }
    }
    return of;
  }

  Figures figures() {
    Figures f;
    Class critical = collect(TrafficClass::critical, false);
    Class high = collect(TrafficClass::high, false);
    const Class low = collect(TrafficClass::low, false);
    Class pictures = collect(TrafficClass::low, true);
    const double length_s = to_seconds(traffic_.end - traffic_.begin);
    f.critical_p50_ms = quantile(critical.latencies_ms, 0.5);
    f.critical_p99_ms = quantile(critical.latencies_ms, 0.99);
    f.high_p50_ms = quantile(high.latencies_ms, 0.5);
    f.high_p99_ms = quantile(high.latencies_ms, 0.99);
    f.critical_late = 100 * critical.late / critical.written;
    f.high_late = 100 * high.late / high.written;
    f.critical_lost = 100 * critical.lost / critical.written;
    f.high_lost = 100 * high.lost / high.written;
    f.low_delivered = 100 * (1 - low.lost / low.written);
    f.location_age_p99_s = quantile(ages_, 0.99);
    f.picture_p99_ms = quantile(pictures.latencies_ms, 0.99);
    f.pictures_per_s = (pictures.written - pictures.lost) / (length_s - to_seconds(warm_up));
    f.picture_kb = mean_picture_kb();
    const auto report = channel_.report(traffic_.end);
    f.airtime =
        100 * to_seconds(report.uplink.air.airtime + report.downlink.air.airtime) / length_s;
    f.acknowledgements_per_s = routers_.acknowledgements() / length_s;
    f.acknowledgement_bytes_per_s = routers_.acknowledgement_bytes() / length_s;
    f.repairs_per_s = routers_.repairs() / length_s;
    if (critical.unplugged > 0)
      f.unplugged_late = 100 * critical.unplugged_late / critical.unplugged;
    f.critical_kb_per_s = critical_bytes() / length_s / 1e3;
    return f;
  }

  [[nodiscard]] double critical_bytes() const {
    double sum = 0;
    for (std::size_t i = 0; i < traffic_.sources.size(); ++i) {
      const TrafficSource& source = traffic_.sources[i];
      if (source.direction != radio::Direction::uplink ||
          source.rule.traffic_class != TrafficClass::critical)
        continue;
      sum += static_cast<double>(routers_.bytes_of(static_cast<router::StreamId>(i)));
    }
    return sum;
  }

  [[nodiscard]] double mean_picture_kb() const {
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < written_.size(); ++i) {
      if (!traffic_.sources[i].rule.adaptive) continue;
      for (const Written& one : written_[i]) {
        if (!one.delivered) continue;
        sum += static_cast<double>(one.bytes);
        ++count;
      }
    }
    return count > 0 ? sum / count / 1e3 : 0;
  }

  const MissionTraffic& traffic_;
  const Steps& steps_;
  radio::RadioChannel channel_;
  std::unique_ptr<radio::RadioChannel> second_;  ///< null: there is one path
  RouterRadio routers_;
  std::vector<std::vector<Written>> written_;  ///< of each source
  AdaptiveSource camera_;
  std::size_t write_ = 0;
  std::size_t place_ = 0;
  std::size_t echo_ = 0;
  std::size_t gate_ = 0;
  Time next_age_{};
  std::optional<Time> location_;
  std::vector<double> ages_;
};

}  // namespace

Figures run_link(const MissionTraffic& traffic, const Steps& steps, std::uint64_t seed) {
  return LinkRun(traffic, steps, seed).run();
}

std::vector<bool> critical_misses(const MissionTraffic& traffic, const Steps& steps,
                                  std::uint64_t seed) {
  LinkRun one(traffic, steps, seed);
  (void)one.run();
  return one.critical_misses();
}

}  // namespace tocsin::bench
