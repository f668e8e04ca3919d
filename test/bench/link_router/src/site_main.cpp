// SPDX-License-Identifier: Apache-2.0
// What vehicles on one channel do to each other, and what shares of its air are worth: each sends
// what is urgent, and bulk without end; the last one stands far away. The rival of airtime shares
// are shares that give all the same bytes, in as much of the air. usage: site [SECONDS [FAR_M
// [AIR]]] Of the vehicles that stand near: delay of critical samples of both ways, what of them is
// lost or later than 250 ms, and bulk. *w/o*: of its critical p99 without the far one.
#include <algorithm>
#include <cstdio>
#include <deque>
#include <string>
#include <vector>

#include "airtime_allocator/airtime_allocator.hpp"
#include "foundation/program.hpp"
#include "router_radio.hpp"

namespace {

using namespace tocsin;
using namespace tocsin::bench;

constexpr Time begin{std::chrono::hours(1)};
constexpr Duration warm_up = std::chrono::seconds(10);
constexpr Duration late_after = std::chrono::milliseconds(250);
constexpr Duration share_period = std::chrono::seconds(1);

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

enum class Rule { none, equal_bytes, airtime };

struct Case {
  std::size_t near = 1;
  bool far = true;
  Rule rule = Rule::none;
  bool access_categories = false;
  double length_s = 60;
  double far_m = 200;
  AirtimeAllocator::Params shares;
};

/// A vehicle and what of the station serves it.
class Vehicle {
 public:
  Vehicle(radio::RadioChannel& channel, std::size_t number, Time end)
      : routers_(channel, setup(number), begin), counted_until_(end - std::chrono::seconds(1)) {
    for (router::StreamId id = 0; id < kinds.size(); ++id) {
      const Kind& kind = kinds[id];
      routers_.add_stream(kind.side, id, stream_rule(kind.name, kind.traffic_class), begin);
      const double phase = 0.37 * static_cast<double>(number) + 0.13 * id;
      next_.push_back(begin + seconds((phase - static_cast<int>(phase)) / kind.rate_hz));
      offered_.push_back(0);
    }
  }
  void serve(Time now) {
    for (router::StreamId id = 0; id < kinds.size(); ++id) {
      if (now < next_[id]) continue;
      const Kind& kind = kinds[id];
      next_[id] += seconds(1 / kind.rate_hz);
      const router::Sample sample{{7 + id, ++offered_[id], now}, kind.bytes, nullptr, {}};
      routers_.sender(kind.side).offer(id, sample, now);
      if (counts(now) && kind.traffic_class == TrafficClass::critical) ++critical;
    }
    routers_.serve(now);
  }
  [[nodiscard]] Time next(Time now) const {
    return std::min(routers_.next_event(now), *std::min_element(next_.begin(), next_.end()));
  }
  void end(const radio::Outcome& outcome) {
    const auto deliver = [this](std::size_t, router::StreamId id, const router::Origin& origin,
                                Time now) {
      if (!counts(origin.sent)) return;
      if (id == bulk) bulk_bytes += static_cast<double>(kinds[id].bytes);
      if (kinds[id].traffic_class != TrafficClass::critical) return;
      critical_ms.push_back(to_seconds(now - origin.sent) * 1e3);
      if (now - origin.sent <= late_after) ++in_time;
    };
    routers_.end(0, outcome, deliver);
  }
  [[nodiscard]] router::LinkSender& sender() { return routers_.sender(0); }

  double critical = 0;
  double in_time = 0;
  double bulk_bytes = 0;
  std::vector<double> critical_ms;

 private:
  static RouterRadio::Setup setup(std::size_t number) {
    RouterRadio::Setup setup;
    setup.vehicle = number;
    return setup;
  }
  [[nodiscard]] bool counts(Time offered) const {
    return offered >= begin + warm_up && offered < counted_until_;
  }
  RouterRadio routers_;
  const Time counted_until_;
  std::vector<Time> next_;
  std::vector<std::uint64_t> offered_;
};

/// Gives the vehicles their shares, once a second.
class Shares {
 public:
  Shares(const Case& one, std::size_t vehicles)
      : rule_(one.rule), params_(one.shares), allocator_(params_, vehicles) {}
  void give(std::deque<Vehicle>& vehicles, Time now) {
    if (rule_ == Rule::none || now < next_) return;
    next_ = now + share_period;
    if (rule_ == Rule::equal_bytes) return give_equal_bytes(vehicles, now);
    const auto shares = allocator_.divide(now).shares;
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
      router::LinkSender& sender = vehicles[i].sender();
      sender.set_airtime_share(shares[i].share);
      const double used = std::min(sender.airtime_used(now), 1.0);
      allocator_.on_use(i, {used, shares[i].share, sender.take_share_missed()}, now);
    }
  }
  [[nodiscard]] Time next() const { return rule_ == Rule::none ? never : next_; }

 private:
  void give_equal_bytes(std::deque<Vehicle>& vehicles, Time now) const {
    double air_of_a_byte = 0;
    for (Vehicle& one : vehicles) air_of_a_byte += 1 / one.sender().free_bytes_per_s(now);
    const double bytes_per_s = params_.air / air_of_a_byte;
    for (Vehicle& one : vehicles) {
      one.sender().set_airtime_share(bytes_per_s / one.sender().free_bytes_per_s(now));
    }
  }
  const Rule rule_;
  const AirtimeAllocator::Params params_;
  AirtimeAllocator allocator_;
  Time next_ = begin;
};

radio::ChannelParams channel_of(const Case& one) {
  radio::ChannelParams params;
  params.shadowing_sigma_db = 0;
  params.rician_k_clear_db = 12;
  params.frame_lifetime_s = 0.512;
  params.access_categories = one.access_categories;
  return params;
}

std::deque<Vehicle> run(const Case& one) {
  const std::size_t count = one.near + (one.far ? 1 : 0);
  const Time end = begin + warm_up + seconds(one.length_s);
  radio::RadioChannel channel(channel_of(one), {}, 1, begin, count);
  std::deque<Vehicle> vehicles;
  for (std::size_t i = 0; i < count; ++i) {
    channel.set_position(i < one.near ? 4 + 0.5 * static_cast<double>(i) : one.far_m, 0, i);
    vehicles.emplace_back(channel, i, end);
  }
  Shares shares(one, count);
  for (Time now = begin; now < end;) {
    shares.give(vehicles, now);
    for (Vehicle& vehicle : vehicles) vehicle.serve(now);
    Time next = std::min(channel.next_event(), shares.next());
    for (const Vehicle& vehicle : vehicles) next = std::min(next, vehicle.next(now));
    now = std::max(next, now + Duration{1});
    channel.advance(now);
    while (const auto outcome = channel.take()) vehicles[outcome->vehicle].end(*outcome);
  }
  return vehicles;
}

double at(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

struct Result {
  double p50_ms = 0;
  double p99_ms = 0;
  double late = 0;  ///< [%]
  double near_kb_per_s = 0;
  double all_kb_per_s = 0;
};

Result result_of(const Case& one) {
  std::deque<Vehicle> vehicles = run(one);
  Result result;
  std::vector<double> ms;
  double critical = 0;
  double in_time = 0;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const double kb_per_s = vehicles[i].bulk_bytes / 1e3 / (one.length_s - 1);
    result.all_kb_per_s += kb_per_s;
    if (i >= one.near) continue;
    result.near_kb_per_s += kb_per_s / static_cast<double>(one.near);
    critical += vehicles[i].critical;
    in_time += vehicles[i].in_time;
    ms.insert(ms.end(), vehicles[i].critical_ms.begin(), vehicles[i].critical_ms.end());
  }
  result.p50_ms = at(ms, 0.5);
  result.p99_ms = at(ms, 0.99);
  result.late = 100 * (1 - in_time / critical);
  return result;
}

void print(Case one, const char* name) {
  const Result with = result_of(one);
  one.far = false;
  const Result without = result_of(one);
  const double far = with.all_kb_per_s - with.near_kb_per_s * static_cast<double>(one.near);
  std::printf("| %zu | %s | %.1f | %.1f | %.2f | %.2f | %.0f | %.0f | %.0f |\n", one.near + 1, name,
              with.p50_ms, with.p99_ms, with.p99_ms / without.p99_ms, with.late, with.near_kb_per_s,
              far, with.all_kb_per_s);
  std::fflush(stdout);
}

void print_all(Case one) {
  std::printf("%s 802.11e\n\n", one.access_categories ? "with" : "without");
  std::printf(
      "| vehicles | shares | p50, ms | p99, ms | w/o | late, %% | near, kB/s each | far, kB/s | "
      "all, kB/s |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::size_t vehicles : {2U, 5U, 10U, 20U}) {
    one.near = vehicles - 1;
    one.rule = Rule::none;
    print(one, "none");
    one.rule = Rule::equal_bytes;
    print(one, "equal bytes");
    one.rule = Rule::airtime;
    print(one, "airtime");
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("site", [&] {
    Case one;
    if (argc > 1) one.length_s = std::stod(argv[1]);
    if (argc > 2) one.far_m = std::stod(argv[2]);
    if (argc > 3) one.shares.air = std::stod(argv[3]);
    for (const bool access_categories : {false, true}) {
      one.access_categories = access_categories;
      print_all(one);
    }
    return 0;
  });
}
