// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/radio_channel.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "geometry/wall.hpp"

namespace tocsin::radio {
namespace {

constexpr Duration association_lost_after{720'000'000};

std::size_t index_of(Direction direction) { return direction == Direction::uplink ? 0 : 1; }

Outcome outcome_of(const AirFrame& frame, Direction direction, Fate fate, Time at) {
  return {frame.id, direction, fate, frame.bytes, frame.category, frame.vehicle, at};
}

std::uint64_t PacketCounts::*counter_of(Fate fate) {
  if (fate == Fate::delivered) return &PacketCounts::delivered;
  return fate == Fate::lost_in_queue ? &PacketCounts::queue_drops : &PacketCounts::losses;
}

}  // namespace

int link_quality(double rssi_dbm) {
  if (std::isnan(rssi_dbm)) return 0;
  return static_cast<int>(std::lround(std::clamp(rssi_dbm, -110.0, -40.0))) + 110;
}

RadioChannel::Vehicle::Vehicle(const ChannelParams& params,
                               const std::vector<geometry::Wall>& walls, std::uint64_t site_seed,
                               Time start, std::size_t number)
    : propagation(params, walls, site_seed, start, number),
      seed(vehicle_seed(own_seed(params, site_seed), number)),
      packet_loss(params, seed, start),
      jitter(seed, 8),
      reported_at(start) {}

Time RadioChannel::Vehicle::next() const {
  Time next = never;
  if (!wire_to_access_point.empty()) next = wire_to_access_point.front().at;
  if (!deliveries.empty()) next = std::min(next, deliveries.front().at);
  return next;
}

DirectionReport& RadioChannel::Vehicle::totals_of(Direction direction) {
  return totals[index_of(direction)];
}

RadioChannel::RadioChannel(const ChannelParams& params, const std::vector<geometry::Wall>& walls,
                           std::uint64_t seed, Time start, std::size_t vehicles)
    : params_(params),
      has_mac_(params.mode == "radio"),
      wire_delay_(seconds(params.wire_delay_s)),
      walls_(walls),
      site_seed_(seed),
      start_(start),
      vehicles_([&] {
        std::deque<Vehicle> all;
        for (std::size_t i = 0; i < vehicles; ++i) all.emplace_back(params, walls, seed, start, i);
        return all;
      }()),
      outages_(params.outages_s, start),
      medium_(params, propagations(), outages_, own_seed(params, seed), start) {}

std::vector<Propagation*> RadioChannel::propagations() {
  std::vector<Propagation*> all;
  for (Vehicle& one : vehicles_) all.push_back(&one.propagation);
  return all;
}

void RadioChannel::configure(const ChannelParams& params) {
  params_ = params;
  has_mac_ = params.mode == "radio";
  wire_delay_ = seconds(params.wire_delay_s);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    Vehicle& one = vehicles_[i];
    const double x_m = one.propagation.x_m();
    const double y_m = one.propagation.y_m();
    one.propagation = Propagation(params, walls_, site_seed_, start_, i);
    one.propagation.set_position(x_m, y_m);
    one.packet_loss = PacketLoss(params, one.seed, start_);
  }
  medium_.configure(params);
}

void RadioChannel::count(const Outcome& outcome, std::uint64_t PacketCounts::*which) {
  DirectionReport& total = vehicles_[outcome.vehicle].totals_of(outcome.direction);
  ++(total.*which);
  ++(total.categories[static_cast<std::size_t>(outcome.category)].*which);
}

FrameId RadioChannel::push(Direction direction, const Packet& packet, Time now) {
  assert(packet.bytes > 0 && packet.vehicle < vehicles_.size());
  advance(now);
  const bool acknowledged = direction == Direction::uplink || !packet.group_addressed;
  const AirFrame frame{next_id_++, packet.bytes, acknowledged, packet.category, packet.vehicle};
  count(outcome_of(frame, direction, Fate::delivered, now), &PacketCounts::pushed);
  vehicles_[packet.vehicle].totals_of(direction).bytes_pushed +=
      static_cast<std::uint64_t>(packet.bytes);
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
  Vehicle& vehicle = vehicles_[frame.vehicle];
  auto& wire = vehicle.wire_to_access_point;
  Time at = now + wire_delay_ + vehicle.propagation.extra_delay(now);
  if (!wire.empty()) at = std::max(at, wire.back().at);
  wire.push_back({at, frame});
}

void RadioChannel::push_without_mac(Direction direction, const AirFrame& frame, Time now) {
  Vehicle& vehicle = vehicles_[frame.vehicle];
  const bool lost = vehicle.packet_loss.lost(now) || outages_.active(now);
  const Time leaves = leaves_at(direction, frame, now);
  const Fate kept = lost ? Fate::lost_on_air : Fate::delivered;
  const Fate fate = leaves == never ? Fate::lost_in_queue : kept;
  const Outcome outcome = outcome_of(frame, direction, fate, now);
  if (fate != Fate::delivered) return end(outcome);
  const double jitter_s =
      params_.jitter_s > 0 ? params_.jitter_s * (2 * vehicle.jitter.uniform() - 1) : 0;
  deliver_at(leaves + seconds(std::max(params_.delay_s + jitter_s, 0.0)), outcome);
}

Time RadioChannel::leaves_at(Direction direction, const AirFrame& frame, Time now) {
  if (params_.rate_mbit_s <= 0) return now;
  Time& free_at = vehicles_[frame.vehicle].line_free_at[index_of(direction)];
  const Duration takes = seconds(8e-6 * frame.bytes / params_.rate_mbit_s);
  if (free_at - now > takes * params_.queue_frames) return never;
  free_at = std::max(free_at, now) + takes;
  return free_at;
}

void RadioChannel::enqueue(Direction direction, const AirFrame& frame, Time now) {
  if (medium_.enqueue(direction, frame, now)) return;
  end(outcome_of(frame, direction, Fate::lost_in_queue, now));
}

void RadioChannel::deliver_at(Time at, const Outcome& outcome) {
  Vehicle& vehicle = vehicles_[outcome.vehicle];
  Time& last = vehicle.last_delivery[index_of(outcome.direction)];
  last = std::max(last, at);
  auto& deliveries = vehicle.deliveries;
  const auto place = std::upper_bound(deliveries.begin(), deliveries.end(), last,
                                      [](Time time, const Outcome& one) { return time < one.at; });
  deliveries.insert(place, outcome)->at = last;
}

void RadioChannel::end(const Outcome& outcome) {
  if (outcome.fate == Fate::delivered) {
    vehicles_[outcome.vehicle].totals_of(outcome.direction).bytes_delivered +=
        static_cast<std::uint64_t>(outcome.bytes);
  }
  count(outcome, counter_of(outcome.fate));
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
  for (Vehicle& vehicle : vehicles_) {
    if (step_waiting(vehicle, next)) return;
  }
  step_medium();
}

/// False when nothing waits for `next` with this vehicle.
bool RadioChannel::step_waiting(Vehicle& vehicle, Time next) {
  auto& wire = vehicle.wire_to_access_point;
  if (!vehicle.deliveries.empty() && vehicle.deliveries.front().at == next) {
    end(vehicle.deliveries.front());
    vehicle.deliveries.pop_front();
    return true;
  }
  if (wire.empty() || wire.front().at != next) return false;
  enqueue(Direction::downlink, wire.front().frame, next);
  wire.pop_front();
  return true;
}

void RadioChannel::step_medium() {
  air_results_.clear();
  medium_.step(air_results_);
  for (const AirResult& result : air_results_) {
    const Fate lost = result.expired ? Fate::lost_in_queue : Fate::lost_on_air;
    const Fate fate = result.received ? Fate::delivered : lost;
    const Outcome outcome{result.id,       result.direction, fate,     result.bytes,
                          result.category, result.vehicle,   result.at};
    if (result.direction == Direction::uplink && result.received) {
      const Propagation& propagation = vehicles_[result.vehicle].propagation;
      deliver_at(result.at + wire_delay_ + propagation.extra_delay(result.at), outcome);
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

DirectionReport RadioChannel::direction_report(std::size_t vehicle, Direction direction) const {
  DirectionReport report = vehicles_[vehicle].totals[index_of(direction)];
  report.air = medium_.counters(vehicle, direction);
  report.queued = medium_.queued(vehicle, direction);
  return report;
}

double RadioChannel::busy_share(Vehicle& vehicle, Time now) const {
  const Duration airtime = medium_.airtime();
  const double own_s = to_seconds(airtime - vehicle.reported_airtime);
  const double elapsed_s = to_seconds(now - vehicle.reported_at);
  vehicle.reported_airtime = airtime;
  vehicle.reported_at = now;
  const double own = elapsed_s > 0 ? own_s / elapsed_s : 0;
  return std::min(1.0, own + params_.background_load);
}

LinkReport RadioChannel::report(Time now, std::size_t vehicle) {
  advance(now);
  Vehicle& reported = vehicles_[vehicle];
  medium_.hear_beacons(vehicle, now);
  reported.propagation.follow(now);
  const SignalTracker& signal = medium_.signal(vehicle);
  const bool associated =
      !std::isnan(signal.last_dbm()) && medium_.silence(vehicle, now) <= association_lost_after;
  return {associated,
          signal.last_dbm(),
          signal.mean_dbm(),
          params_.noise_dbm,
          associated ? link_quality(signal.last_dbm()) : 0,
          busy_share(reported, now),
          reported.propagation.mean_snr_db(),
          reported.propagation.x_m(),
          reported.propagation.y_m(),
          direction_report(vehicle, Direction::uplink),
          direction_report(vehicle, Direction::downlink)};
}

}  // namespace tocsin::radio
