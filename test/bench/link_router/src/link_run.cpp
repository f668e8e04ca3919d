// SPDX-License-Identifier: Apache-2.0
#include "link_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <unordered_map>
#include <variant>

#include "link_router/link_receiver.hpp"
#include "link_router/link_sender.hpp"
#include "rtps_model/message.hpp"
#include "statistics.hpp"

namespace tocsin::bench {
namespace {

constexpr Duration warm_up = std::chrono::seconds(12);
constexpr Duration late_after = std::chrono::milliseconds(250);
constexpr Duration age_period = std::chrono::milliseconds(100);
constexpr std::size_t origin_bytes = 32;
constexpr int echo_bytes = 92;
/// Share of the shrinking that is done by size; the rest by rate.
constexpr double size_share = 0.75;

std::size_t side_of(radio::Direction direction) {
  return direction == radio::Direction::uplink ? 0 : 1;
}

/// What crosses the radio as one or more packets.
struct Cargo {
  std::variant<router::Transmission, router::LinkReceipt, std::monostate> what;
  std::size_t to = 0;  ///< side
  std::size_t missing = 0;
  bool is_request = false;
};

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
        channel_(traffic.channel, traffic.walls, seed, traffic.begin),
        written_(traffic.sources.size()) {
    for (std::size_t side = 0; side < 2; ++side) {
      senders_[side] = std::make_unique<router::LinkSender>(steps.params, side + 1);
      receivers_[side] = std::make_unique<router::LinkReceiver>(steps.params, side + 1);
    }
    for (std::size_t side = 0; side < 2; ++side) {
      senders_[side]->on_peer("peer", 2 - side, traffic.begin);
      receivers_[side]->on_peer("peer", 2 - side);
    }
    for (std::size_t i = 0; i < traffic.sources.size(); ++i) add_source(i);
    next_age_ = traffic.begin + warm_up;
  }

  Figures run() {
    Time now = traffic_.begin;
    while (now < traffic_.end) {
      play_due(now);
      for (std::size_t side = 0; side < 2; ++side) serve(side, now);
      now = std::min({next_input(), channel_.next_event(), next_deadline(now), traffic_.end});
      channel_.advance(now);
      while (const auto outcome = channel_.take()) end_packet(*outcome);
    }
    return figures();
  }

 private:
  void add_source(std::size_t i) {
    const TrafficSource& source = traffic_.sources[i];
    router::StreamRule rule = source.rule;
    rule.repaired = rule.repaired && steps_.repair;
    if (!steps_.repair) rule.durable = false;
    const auto id = static_cast<router::StreamId>(i);
    const std::size_t side = side_of(source.direction);
    senders_[side]->add_stream(id, rule);
    senders_[side]->set_wanted("peer", id, true, traffic_.begin);
    receivers_[1 - side]->on_stream("peer", id, rule);
  }

  [[nodiscard]] Time next_input() const {
    Time next = next_age_;
    if (write_ < traffic_.writes.size()) next = std::min(next, traffic_.writes[write_].time);
    if (place_ < traffic_.places.size()) next = std::min(next, traffic_.places[place_].time);
    if (echo_ < traffic_.echoes.size()) next = std::min(next, traffic_.echoes[echo_]);
    if (gate_ < traffic_.gates.size()) next = std::min(next, traffic_.gates[gate_].time);
    return next;
  }

  [[nodiscard]] Time next_deadline(Time now) const {
    Time next = never;
    for (std::size_t side = 0; side < 2; ++side) {
      next = std::min({next, senders_[side]->deadline(now), receivers_[side]->deadline()});
    }
    return std::max(next, now + std::chrono::microseconds(50));
  }

  void play_due(Time now) {
    for (; place_ < traffic_.places.size() && traffic_.places[place_].time <= now; ++place_) {
      channel_.set_position(traffic_.places[place_].x_m, traffic_.places[place_].y_m);
    }
    for (; gate_ < traffic_.gates.size() && traffic_.gates[gate_].time <= now; ++gate_) {
      if (steps_.pause) senders_[0]->set_paused(!traffic_.gates[gate_].open, now);
    }
    for (; echo_ < traffic_.echoes.size() && traffic_.echoes[echo_] <= now; ++echo_) {
      send({std::monostate{}, 1, 1, true}, {static_cast<std::size_t>(echo_bytes)}, now);
    }
    for (; write_ < traffic_.writes.size() && traffic_.writes[write_].time <= now; ++write_) {
      write(traffic_.writes[write_], now);
    }
    for (; next_age_ <= now; next_age_ += age_period) note_age(next_age_);
  }

  void write(const MissionTraffic::Write& write, Time now) {
    const TrafficSource& source = traffic_.sources[write.source];
    router::LinkSender& sender = *senders_[side_of(source.direction)];
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

  void serve(std::size_t side, Time now) {
    while (const auto one = senders_[side]->next(now)) {
      auto packets =
          rtps::packets_of(one->sample.bytes, 1, rtps::wire::largest_payload - origin_bytes);
      for (std::size_t& packet : packets) packet += origin_bytes;
      if (one->repair) ++repairs_;
      send({*one, 1 - side, packets.size(), false}, packets, now);
    }
    while (const auto receipt = receivers_[side]->take_receipt(now)) {
      const std::size_t bytes = 36 + 18 * receipt->receipt.streams.size();
      const auto packets = rtps::packets_of(bytes, 1, rtps::wire::largest_payload);
      ++receipts_;
      send({receipt->receipt, 1 - side, 1, false}, packets, now);
    }
    if (steps_.trace && side == 0 && now >= next_trace_) {
      next_trace_ = now + std::chrono::seconds(1);
      const auto state = senders_[0]->state(now);
      std::printf("%6.1f snr %5.1f cap %8.0f backlog %5.3f loss %.3f scale %.2f silent %zu q %zu\n",
                  to_seconds(now - traffic_.begin), channel_.propagation().mean_snr_db(),
                  state.capacity_bytes_per_s, to_seconds(state.backlog), state.loss, state.scale,
                  state.silent_peers, channel_.report(now).uplink.queued);
    }
  }

  void send(Cargo cargo, const std::vector<std::size_t>& packets, Time now) {
    const auto direction = cargo.to == 1 ? radio::Direction::uplink : radio::Direction::downlink;
    const auto shared = std::make_shared<Cargo>(std::move(cargo));
    for (const std::size_t bytes : packets) {
      under_way_[channel_.push(direction, static_cast<int>(bytes), false, now)] = shared;
    }
  }

  void end_packet(const radio::Outcome& outcome) {
    const auto found = under_way_.find(outcome.id);
    const std::shared_ptr<Cargo> cargo = found->second;
    under_way_.erase(found);
    if (outcome.fate != radio::Fate::delivered || --cargo->missing > 0) return;
    arrive(*cargo, outcome.at);
  }

  void arrive(const Cargo& cargo, Time now) {
    if (const auto* receipt = std::get_if<router::LinkReceipt>(&cargo.what)) {
      senders_[cargo.to]->on_receipt("peer", *receipt, now);
      return;
    }
    if (const auto* one = std::get_if<router::Transmission>(&cargo.what)) {
      const router::Origin& origin = one->sample.origin;
      const auto verdict = receivers_[cargo.to]->on_arrived(
          "peer", {one->stream, one->number, origin, one->sample.bytes}, now);
      if (verdict != router::Verdict::deliver) return;
      Written& written = written_[one->stream][origin.sequence - 1];
      written.delivered = true;
      written.latency = now - written.time;
      if (traffic_.sources[one->stream].topic == "location") location_ = written.time;
      return;
    }
    if (cargo.is_request) {
      send({std::monostate{}, 0, 1, false}, {static_cast<std::size_t>(echo_bytes)}, now);
    }
  }

  void note_age(Time at) {
    if (location_) ages_.push_back(to_seconds(at - *location_));
  }

  struct Class {
    std::vector<double> latencies_ms;
    double written = 0;
    double late = 0;
    double lost = 0;
  };

  [[nodiscard]] Class collect(router::Priority priority, bool adaptive_only) const {
    Class of;
    for (std::size_t i = 0; i < written_.size(); ++i) {
      const TrafficSource& source = traffic_.sources[i];
      if (source.direction != radio::Direction::uplink || source.rule.priority != priority)
        continue;
      if (adaptive_only && !source.rule.adaptive) continue;
      for (const Written& one : written_[i]) {
        if (one.time < traffic_.begin + warm_up || one.time + late_after > traffic_.end) continue;
        ++of.written;
        if (!one.delivered) ++of.lost;
        if (!one.delivered || one.latency > late_after) ++of.late;
        if (one.delivered) of.latencies_ms.push_back(1e3 * to_seconds(one.latency));
      }
    }
    return of;
  }

  Figures figures() {
    Figures f;
    Class critical = collect(router::Priority::critical, false);
    Class high = collect(router::Priority::high, false);
    const Class low = collect(router::Priority::low, false);
    Class pictures = collect(router::Priority::low, true);
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
    f.receipts_per_s = receipts_ / length_s;
    f.repairs_per_s = repairs_ / length_s;
    return f;
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
  std::array<std::unique_ptr<router::LinkSender>, 2> senders_;
  std::array<std::unique_ptr<router::LinkReceiver>, 2> receivers_;
  std::unordered_map<radio::FrameId, std::shared_ptr<Cargo>> under_way_;
  std::vector<std::vector<Written>> written_;  ///< of each source
  AdaptiveSource camera_;
  std::size_t write_ = 0;
  std::size_t place_ = 0;
  std::size_t echo_ = 0;
  std::size_t gate_ = 0;
  Time next_age_{};
  Time next_trace_{};
  std::optional<Time> location_;
  std::vector<double> ages_;
  double receipts_ = 0;
  double repairs_ = 0;
};

}  // namespace

Figures run_link(const MissionTraffic& traffic, const Steps& steps, std::uint64_t seed) {
  return LinkRun(traffic, steps, seed).run();
}

}  // namespace tocsin::bench
