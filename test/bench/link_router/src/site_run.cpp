// SPDX-License-Identifier: Apache-2.0
#include "site_run.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::bench {
namespace {

constexpr Time begin{std::chrono::hours(1)};
constexpr Duration warm_up = std::chrono::seconds(10);
constexpr Duration tail = std::chrono::seconds(1);
constexpr Duration late_after = std::chrono::milliseconds(250);
constexpr Duration share_period = std::chrono::seconds(1);
constexpr Duration move_period = std::chrono::milliseconds(100);

struct Kind {
  std::size_t side;
  const char* name;
  TrafficClass traffic_class;
  std::size_t bytes;
  double rate_hz;
};
const std::vector<Kind> kinds{{0, "heartbeat", TrafficClass::critical, 100, 5},
                              {0, "navigation_status", TrafficClass::critical, 150, 5},
                              {0, "safety_status", TrafficClass::critical, 150, 5},
                              {0, "location", TrafficClass::high, 400, 10},
                              {0, "bulk", TrafficClass::low, 30000, 40},
                              {1, "mission_status", TrafficClass::critical, 100, 5},
                              {1, "velocity", TrafficClass::critical, 100, 10}};
constexpr router::StreamId bulk = 4;

/// A vehicle and what of the station serves it.
class Vehicle {
 public:
  Vehicle(radio::RadioChannel& channel, std::size_t number, const SiteRun& run, bool is_last)
      : routers_(channel, setup(number), begin),
        run_(run),
        keeps_(is_last && run.last_pictures_per_s > 0),
        counted_until_(begin + warm_up + seconds(run.length_s) - tail) {
    for (router::StreamId id = 0; id < kinds.size(); ++id) {
      const Kind& kind = kinds[id];
      routers_.add_stream(kind.side, id, stream_rule(kind.name, kind.traffic_class), begin);
      const double phase = 0.37 * static_cast<double>(number) + 0.13 * id;
      next_.push_back(begin + seconds(std::fmod(phase, 1) / kind.rate_hz));
      offered_.push_back(0);
    }
  }
  void serve(Time now) {
    for (router::StreamId id = 0; id < kinds.size(); ++id) {
      if (now >= next_[id]) offer(id, now);
    }
    routers_.serve(now);
  }
  [[nodiscard]] Time next(Time now) const {
    return std::min(routers_.next_event(now), *std::min_element(next_.begin(), next_.end()));
  }
  void end(const radio::Outcome& outcome) {
    const auto deliver = [this](std::size_t, router::StreamId id, const router::Origin& origin,
                                Time now) { on_delivered(id, origin, now); };
    routers_.end(0, outcome, deliver);
  }
  [[nodiscard]] router::LinkSender& sender() { return routers_.sender(0); }
  void set_vehicles(std::size_t count) { routers_.set_vehicles(static_cast<unsigned>(count)); }

  SiteCounts counts;

 private:
  static RouterRadio::Setup setup(std::size_t number) {
    RouterRadio::Setup setup;
    setup.vehicle = number;
    return setup;
  }
  [[nodiscard]] bool is_counted(Time offered) const {
    return offered >= begin + warm_up && offered < counted_until_;
  }
  void offer(router::StreamId id, Time now) {
    const Kind& kind = kinds[id];
    next_[id] += seconds(1 / kind.rate_hz);
    if (id == bulk && keeps_ && !takes_kept(now)) return;
    const router::Sample sample{{7 + id, ++offered_[id], now}, kind.bytes, nullptr, {}};
    routers_.sender(kind.side).offer(id, sample, now);
    if (is_counted(now) && kind.traffic_class == TrafficClass::critical) ++counts.critical;
  }
  /// Whether a picture that is kept is to go now.
  bool takes_kept(Time now) {
    const double t_s = to_seconds(now - begin);
    kept_ += run_.last_pictures_per_s / kinds[bulk].rate_hz;
    const auto low = static_cast<std::size_t>(TrafficClass::low);
    const bool waits = sender().state(now).classes[low].waiting_samples > 0;
    if (kept_ < 1 || waits || !run_.last_may_send(t_s)) return false;
    --kept_;
    return true;
  }
  void on_delivered(router::StreamId id, const router::Origin& origin, Time now) {
    if (!is_counted(origin.sent)) return;
    if (id == bulk) counts.bulk_bytes += static_cast<double>(kinds[id].bytes);
    if (kinds[id].traffic_class != TrafficClass::critical) return;
    counts.critical_ms.push_back(to_seconds(now - origin.sent) * 1e3);
    if (now - origin.sent <= late_after) ++counts.in_time;
  }

  RouterRadio routers_;
  const SiteRun& run_;
  const bool keeps_;
  const Time counted_until_;
  double kept_ = 0;  ///< pictures
  std::vector<Time> next_;
  std::vector<std::uint64_t> offered_;
};

/// Gives the vehicles their shares, once a second.
class Shares {
 public:
  Shares(const SiteRun& run, std::size_t vehicles)
      : division_(run.division), params_(run.shares), allocator_(params_, vehicles) {}
  void give(std::deque<Vehicle>& vehicles, Time now) {
    if (division_ == Division::none || now < next_) return;
    next_ = now + share_period;
    for (Vehicle& one : vehicles) one.set_vehicles(vehicles.size());
    if (division_ == Division::equal_bytes) return give_equal_bytes(vehicles, now);
    const auto shares = allocator_.divide(now).shares;
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
      router::LinkSender& sender = vehicles[i].sender();
      sender.set_airtime_share(shares[i].share);
      const double used = std::min(sender.airtime_used(now), 1.0);
      allocator_.on_use(i, {used, shares[i].share, sender.take_share_missed()}, now);
    }
  }
  [[nodiscard]] Time next() const { return division_ == Division::none ? never : next_; }

 private:
  void give_equal_bytes(std::deque<Vehicle>& vehicles, Time now) const {
    double air_of_a_byte = 0;
    for (Vehicle& one : vehicles) air_of_a_byte += 1 / one.sender().free_bytes_per_s(now);
    const double bytes_per_s = params_.air / air_of_a_byte;
    for (Vehicle& one : vehicles) {
      one.sender().set_airtime_share(bytes_per_s / one.sender().free_bytes_per_s(now));
    }
  }
  const Division division_;
  const AirtimeAllocator::Params params_;
  AirtimeAllocator allocator_;
  Time next_ = begin;
};

radio::ChannelParams channel_of(const SiteRun& run) {
  radio::ChannelParams params;
  params.shadowing_sigma_db = 0;
  params.rician_k_clear_db = 12;
  params.frame_lifetime_s = 0.512;
  params.access_categories = run.access_categories;
  return params;
}

double at(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

std::vector<SiteCounts> run_site(const SiteRun& run) {
  const std::size_t count = run.near + (run.last ? 1 : 0);
  const Time end = begin + warm_up + seconds(run.length_s);
  radio::RadioChannel channel(channel_of(run), {}, run.seed, begin, count);
  std::deque<Vehicle> vehicles;
  for (std::size_t i = 0; i < count; ++i) {
    channel.set_position(4 + 0.5 * static_cast<double>(i), 0, i);
    vehicles.emplace_back(channel, i, run, i >= run.near);
  }
  Shares shares(run, count);
  Time next_move = run.last ? begin : never;
  for (Time now = begin; now < end;) {
    if (now >= next_move) {
      channel.set_position(run.last_x_m(to_seconds(now - begin)), 0, run.near);
      next_move += move_period;
    }
    shares.give(vehicles, now);
    for (Vehicle& vehicle : vehicles) vehicle.serve(now);
    Time next = std::min({channel.next_event(), shares.next(), next_move});
    for (const Vehicle& vehicle : vehicles) next = std::min(next, vehicle.next(now));
    now = std::max(next, now + Duration{1});
    channel.advance(now);
    while (const auto outcome = channel.take()) vehicles[outcome->vehicle].end(*outcome);
  }
  std::vector<SiteCounts> counts;
  for (const Vehicle& vehicle : vehicles) counts.push_back(vehicle.counts);
  return counts;
}

SiteFigures figures_of(const SiteRun& run) {
  const auto all = run_site(run);
  const double counted_s = run.length_s - to_seconds(tail);
  SiteFigures figures;
  std::vector<double> ms;
  double critical = 0;
  double in_time = 0;
  for (std::size_t i = 0; i < run.near; ++i) {
    figures.near_kb_per_s += all[i].bulk_bytes / 1e3 / counted_s / static_cast<double>(run.near);
    critical += all[i].critical;
    in_time += all[i].in_time;
    ms.insert(ms.end(), all[i].critical_ms.begin(), all[i].critical_ms.end());
  }
  figures.p50_ms = at(ms, 0.5);
  figures.p99_ms = at(ms, 0.99);
  figures.late = 100 * (1 - in_time / critical);
  if (run.last) figures.last_kb_per_s = all.back().bulk_bytes / 1e3 / counted_s;
  return figures;
}

}  // namespace tocsin::bench
