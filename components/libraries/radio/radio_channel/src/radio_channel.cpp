// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/radio_channel.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "geometry/wall.hpp"

namespace tocsin::radio {
namespace {

constexpr Duration association_lost_after{720'000'000};

int station_of(Direction direction) { return direction == Direction::uplink ? 0 : 1; }

std::uint64_t PacketCounts::*counter_of(Fate fate) {
  if (fate == Fate::delivered) return &PacketCounts::delivered;
  return fate == Fate::lost_in_queue ? &PacketCounts::queue_drops : &PacketCounts::losses;
}

}  // namespace

int link_quality(double rssi_dbm) {
  if (std::isnan(rssi_dbm)) return 0;
  return static_cast<int>(std::lround(std::clamp(rssi_dbm, -110.0, -40.0))) + 110;
}

RadioChannel::RadioChannel(const ChannelParams& params, std::vector<geometry::Wall> walls,
                           std::uint64_t seed, Time start)
    : params_(params),
      has_mac_(params.mode == "radio"),
      wire_delay_(seconds(params.wire_delay_s)),
      walls_(std::move(walls)),
      site_seed_(seed),
      seed_(own_seed(params, seed)),
      start_(start),
      propagation_(params, walls_, seed, start),
      outages_(params.outages_s, start),
      medium_(params, propagation_, outages_, seed_, start),
      packet_loss_(params, seed_, start),
      jitter_(seed_, 8),
      reported_at_(start) {}

void RadioChannel::configure(const ChannelParams& params) {
  const double x_m = propagation_.x_m();
  const double y_m = propagation_.y_m();
  params_ = params;
  has_mac_ = params.mode == "radio";
  wire_delay_ = seconds(params.wire_delay_s);
  propagation_ = Propagation(params, walls_, site_seed_, start_);
  propagation_.set_position(x_m, y_m);
  medium_.configure(params);
  packet_loss_ = PacketLoss(params, seed_, start_);
}

DirectionReport& RadioChannel::totals(Direction direction) {
  return totals_[static_cast<std::size_t>(station_of(direction))];
}

void RadioChannel::count(Direction direction, AccessCategory category,
                         std::uint64_t PacketCounts::*which) {
  DirectionReport& total = totals(direction);
  ++(total.*which);
  ++(total.categories[static_cast<std::size_t>(category)].*which);
}

FrameId RadioChannel::push(Direction direction, const Packet& packet, Time now) {
  assert(packet.bytes > 0);
  advance(now);
  count(direction, packet.category, &PacketCounts::pushed);
  totals(direction).bytes_pushed += static_cast<std::uint64_t>(packet.bytes);
  const bool acknowledged = direction == Direction::uplink || !packet.group_addressed;
  const AirFrame frame{next_id_++, packet.bytes, acknowledged, packet.category};
  if (has_mac_) {
    push_radio(direction, frame, now);
  } else {
    push_without_mac(direction, frame, now);
  }
  return frame.id;
}

void RadioChannel::push_radio(Direction direction, const AirFrame& frame, Time now) {
  if (direction == Direction::uplink) {
    enqueue(direction, frame, now);
    return;
  }
  Time at = now + wire_delay_ + propagation_.extra_delay(now);
  if (!wire_to_access_point_.empty()) at = std::max(at, wire_to_access_point_.back().at);
  wire_to_access_point_.push_back({at, frame});
}

void RadioChannel::push_without_mac(Direction direction, const AirFrame& frame, Time now) {
  const bool lost = packet_loss_.lost(now) || outages_.active(now);
  const Time leaves = leaves_at(direction, frame.bytes, now);
  const Fate kept = lost ? Fate::lost_on_air : Fate::delivered;
  const Fate fate = leaves == never ? Fate::lost_in_queue : kept;
  const Outcome outcome{frame.id, direction, fate, frame.bytes, frame.category, now};
  if (fate != Fate::delivered) return end(outcome);
  const double jitter_s = params_.jitter_s > 0 ? params_.jitter_s * (2 * jitter_.uniform() - 1) : 0;
  deliver_at(leaves + seconds(std::max(params_.delay_s + jitter_s, 0.0)), outcome);
}

Time RadioChannel::leaves_at(Direction direction, int bytes, Time now) {
  if (params_.rate_mbit_s <= 0) return now;
  Time& free_at = line_free_at_[static_cast<std::size_t>(station_of(direction))];
  const Duration takes = seconds(8e-6 * bytes / params_.rate_mbit_s);
  if (free_at - now > takes * params_.queue_frames) return never;
  free_at = std::max(free_at, now) + takes;
  return free_at;
}

void RadioChannel::enqueue(Direction direction, const AirFrame& frame, Time now) {
  if (medium_.enqueue(station_of(direction), frame, now)) return;
  end({frame.id, direction, Fate::lost_in_queue, frame.bytes, frame.category, now});
}

void RadioChannel::deliver_at(Time at, const Outcome& outcome) {
  Time& last = last_delivery_[static_cast<std::size_t>(station_of(outcome.direction))];
  last = std::max(last, at);
  const auto place = std::upper_bound(deliveries_.begin(), deliveries_.end(), last,
                                      [](Time time, const Outcome& one) { return time < one.at; });
  deliveries_.insert(place, outcome)->at = last;
}

void RadioChannel::end(const Outcome& outcome) {
  if (outcome.fate == Fate::delivered) {
    totals(outcome.direction).bytes_delivered += static_cast<std::uint64_t>(outcome.bytes);
  }
  count(outcome.direction, outcome.category, counter_of(outcome.fate));
  outcomes_.push_back(outcome);
}

void RadioChannel::advance(Time now) {
  for (Time next = next_event(); next <= now && next != never; next = next_event()) step(next);
}

Time RadioChannel::advance_to_outcome(Time limit) {
  while (outcomes_.empty()) {
    const Time next = next_event();
    if (next >= limit) return limit;
    step(next);
  }
  return outcomes_.front().at;
}

void RadioChannel::step(Time next) {
  if (!deliveries_.empty() && deliveries_.front().at == next) {
    end(deliveries_.front());
    deliveries_.pop_front();
  } else if (!wire_to_access_point_.empty() && wire_to_access_point_.front().at == next) {
    enqueue(Direction::downlink, wire_to_access_point_.front().frame, next);
    wire_to_access_point_.pop_front();
  } else {
    step_medium();
  }
}

void RadioChannel::step_medium() {
  air_results_.clear();
  medium_.step(air_results_);
  for (const AirResult& result : air_results_) {
    const bool up = result.station == 0;
    const Fate fate = result.received ? Fate::delivered : Fate::lost_on_air;
    const Outcome outcome{result.id,
                          up ? Direction::uplink : Direction::downlink,
                          fate,
                          result.bytes,
                          result.category,
                          result.at};
    if (up && result.received) {
      deliver_at(result.at + wire_delay_ + propagation_.extra_delay(result.at), outcome);
    } else {
      end(outcome);
    }
  }
}

std::optional<Outcome> RadioChannel::take() {
  if (outcomes_.empty()) return std::nullopt;
  const Outcome outcome = outcomes_.front();
  outcomes_.pop_front();
  return outcome;
}

DirectionReport RadioChannel::direction_report(Direction direction) const {
  const int station = station_of(direction);
  DirectionReport report = totals_[static_cast<std::size_t>(station)];
  report.air = medium_.counters(station);
  report.queued = medium_.queued(station);
  return report;
}

double RadioChannel::busy_share(Time now) {
  const Duration airtime = medium_.counters(0).airtime + medium_.counters(1).airtime;
  const double own_s = to_seconds(airtime - reported_airtime_);
  const double elapsed_s = to_seconds(now - reported_at_);
  reported_airtime_ = airtime;
  reported_at_ = now;
  const double own = elapsed_s > 0 ? own_s / elapsed_s : 0;
  return std::min(1.0, own + params_.background_load);
}

LinkReport RadioChannel::report(Time now) {
  advance(now);
  medium_.hear_beacons(now);
  propagation_.follow(now);
  const SignalTracker& signal = medium_.signal();
  const bool associated =
      !std::isnan(signal.last_dbm()) && medium_.silence(now) <= association_lost_after;
  return {associated,
          signal.last_dbm(),
          signal.mean_dbm(),
          params_.noise_dbm,
          associated ? link_quality(signal.last_dbm()) : 0,
          busy_share(now),
          propagation_.mean_snr_db(),
          propagation_.x_m(),
          propagation_.y_m(),
          direction_report(Direction::uplink),
          direction_report(Direction::downlink)};
}

}  // namespace tocsin::radio
