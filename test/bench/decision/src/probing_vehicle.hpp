// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <deque>
#include <map>

#include "decision/quality_index.hpp"
#include "radio_channel/radio_channel.hpp"

namespace tocsin::decision {

/// What changes when the link falls.
struct Fall {
  const char* name;
  double weaker_db;
  double load;
};

inline constexpr double usual_load = 0.2;

inline radio::ChannelParams good_link() {
  radio::ChannelParams params;
  params.tx_dbm = -9;  // mean SNR 22 dB at 10 m
  params.shadowing_sigma_db = 3;
  params.background_load = usual_load;
  return params;
}

/// Drives in a circle and measures once a second as network_monitor does.
class Vehicle {
 public:
  explicit Vehicle(std::uint64_t seed) : channel_(good_link(), {}, seed, Time{}) {}

  void fall(const Fall& fall) {
    radio::ChannelParams params = channel_.params();
    params.tx_dbm -= fall.weaker_db;
    params.background_load = fall.load;
    channel_.configure(params);
  }

  QualityMeasurement second() {
    for (int i = 0; i < 20; ++i) {
      if (step_ % 2 == 0) move();
      if (step_ % 6 == 0) probe();
      (void)channel_.push(radio::Direction::uplink, {1200}, now_);
      run_until(now_ + std::chrono::milliseconds(50));
      ++step_;
    }
    return sample();
  }

 private:
  struct Probe {
    Time sent;
    std::optional<double> rtt_ms;
  };

  void move() {
    const double angle = 0.03 * to_seconds(now_ - Time{});  // 0.3 m/s
    channel_.set_position(10 * std::cos(angle), 10 * std::sin(angle));
  }
  void probe() {
    probes_.push_back({now_, {}});
    under_way_[channel_.push(radio::Direction::uplink, {92}, now_)] = first_ + probes_.size() - 1;
    while (probes_.size() > 24) {
      probes_.pop_front();
      ++first_;
    }
  }
  void run_until(Time limit) {
    while (true) {
      now_ = channel_.advance_to_outcome(limit);
      const auto outcome = channel_.take();
      if (!outcome) break;
      take(*outcome);
    }
    now_ = limit;
  }
  void take(const radio::Outcome& outcome) {
    const auto it = under_way_.find(outcome.id);
    if (it == under_way_.end()) return;
    const std::size_t number = it->second;
    under_way_.erase(it);
    if (outcome.fate != radio::Fate::delivered || number < first_) return;
    if (outcome.direction == radio::Direction::uplink) {
      under_way_[channel_.push(radio::Direction::downlink, {92}, outcome.at)] = number;
      return;
    }
    Probe& probe = probes_[number - first_];
    probe.rtt_ms = 1000 * to_seconds(outcome.at - probe.sent);
  }
  QualityMeasurement sample() {
    double sent = 0;
    double rtt = 0;
    double answered = 0;
    for (const Probe& probe : probes_) {
      if (now_ - probe.sent < std::chrono::seconds(1)) continue;
      ++sent;
      if (!probe.rtt_ms || *probe.rtt_ms > 1000) continue;
      ++answered;
      rtt += *probe.rtt_ms;
    }
    const radio::LinkReport report = channel_.report(now_);
    const auto air = report.uplink.air;
    const double attempts = static_cast<double>(air.attempts - before_.attempts);
    const double retries = static_cast<double>(air.retries - before_.retries);
    before_ = air;
    QualityMeasurement measured;
    measured.per_percent = sent > 0 ? 100 * (sent - answered) / sent : 0;
    if (answered > 0) measured.rtt_ms = rtt / answered;
    measured.signal_dbm = report.rssi_mean_dbm;
    measured.quality_percent = report.quality / 0.7;
    if (attempts > 0) measured.retry_percent = 100 * retries / attempts;
    measured.busy_percent = 100 * report.busy_share;
    return measured;
  }

  radio::RadioChannel channel_;
  Time now_{};
  long step_ = 0;
  std::deque<Probe> probes_;
  std::size_t first_ = 0;  // number of probes_.front()
  std::map<radio::FrameId, std::size_t> under_way_;
  radio::AirCounters before_{};
};

}  // namespace tocsin::decision
