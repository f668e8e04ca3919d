// SPDX-License-Identifier: Apache-2.0
// How soon the router knows that the capacity of its radio has fallen or risen: other stations take
// a share of the time for ten seconds, then none for ten seconds, while a camera and a heartbeat
// are sent. The truth is what a full queue brings. usage: capacity_step
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "foundation/program.hpp"
#include "router_radio.hpp"

namespace {

using namespace tocsin;
using namespace tocsin::bench;

constexpr Time begin{std::chrono::hours(1)};
constexpr Duration half = std::chrono::milliseconds(10370);  // at any phase of the pictures
constexpr int steps = 40;                                    // of which every second one is a rise
constexpr std::size_t picture_bytes = 30000;
constexpr double near_truth = 0.25;
constexpr router::StreamId camera = 1;
constexpr router::StreamId heartbeat = 2;

radio::ChannelParams channel(double load) {
  radio::ChannelParams params;
  params.tx_dbm = 0;
  params.shadowing_sigma_db = 0;
  params.rician_k_clear_db = 12;
  params.background_load = load;
  return params;
}

/// Bytes a second of a queue that is never empty.
double truth_bytes_per_s(double load) {
  constexpr int packet_bytes = 1400;
  constexpr double measured_s = 20;
  radio::RadioChannel radio(channel(load), {}, 1, begin);
  radio.set_position(4, 0);
  double delivered = 0;
  for (Time now = begin; now < begin + seconds(measured_s); now += std::chrono::milliseconds(5)) {
    radio.advance(now);
    while (const auto outcome = radio.take()) delivered += outcome->fate == radio::Fate::delivered;
    for (int i = 0; i < 30; ++i) {
      (void)radio.push(radio::Direction::uplink, {packet_bytes, false, {}}, now);
    }
  }
  return delivered * packet_bytes / measured_s;
}

/// What is told of one step.
struct Step {
  double known_after_s = to_seconds(half);  ///< until the estimate is near the truth
  double highest = 0;                       ///< estimate over truth afterwards
};

class Run {
 public:
  Run(double load, Duration period, std::uint64_t seed)
      : load_(load),
        period_(period),
        channel_(channel(0), {}, seed, begin),
        routers_(channel_, {}, begin) {
    channel_.set_position(4, 0);
    routers_.add_stream(0, camera, stream_rule("camera", TrafficClass::low), begin);
    routers_.add_stream(0, heartbeat, stream_rule("heartbeat", TrafficClass::critical), begin);
  }

  /// Falls and rises, in turn.
  std::vector<Step> run(double full, double rest) {
    std::vector<Step> all;
    run_until(begin + half, full);
    for (int i = 0; i < steps; ++i) {
      const bool falls = i % 2 == 0;
      channel_.configure(channel(falls ? load_ : 0));
      all.push_back(run_until(now_ + half, falls ? rest : full));
    }
    return all;
  }

 private:
  Step run_until(Time end, double truth) {
    const auto deliver = [](std::size_t, router::StreamId, const router::Origin&, Time) {};
    const Time from = now_;
    Step step;
    bool is_known = false;
    while (now_ < end) {
      offer();
      routers_.serve(now_);
      now_ = std::max(std::min({next_picture_, next_heartbeat_, routers_.next_event(now_), end}),
                      now_ + Duration{1});
      routers_.advance(now_, deliver);
      const double share = routers_.sender(0).capacity_bytes_per_s(now_) / truth;
      if (!is_known && std::abs(share - 1) <= near_truth) {
        is_known = true;
        step.known_after_s = to_seconds(now_ - from);
      }
      if (is_known) step.highest = std::max(step.highest, share);
    }
    return step;
  }
  void offer() {
    if (now_ >= next_picture_) {
      routers_.sender(0).offer(camera, {{7, ++pictures_, now_}, picture_bytes, nullptr, {}}, now_);
      next_picture_ += period_;
    }
    if (now_ >= next_heartbeat_) {
      routers_.sender(0).offer(heartbeat, {{8, ++heartbeats_, now_}, 100, nullptr, {}}, now_);
      next_heartbeat_ += std::chrono::milliseconds(200);
    }
  }

  double load_;
  Duration period_;
  radio::RadioChannel channel_;
  RouterRadio routers_;
  Time now_ = begin;
  Time next_picture_ = begin;
  Time next_heartbeat_ = begin;
  std::uint64_t pictures_ = 0;
  std::uint64_t heartbeats_ = 0;
};

double at(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void print(double load, double pictures_per_s) {
  const double full = truth_bytes_per_s(0);
  const double rest = truth_bytes_per_s(load);
  const auto all = Run(load, seconds(1 / pictures_per_s), 1).run(full, rest);
  for (const bool falls : {true, false}) {
    std::vector<double> after_s;
    std::vector<double> highest;
    for (std::size_t i = falls ? 0 : 1; i < all.size(); i += 2) {
      after_s.push_back(all[i].known_after_s);
      highest.push_back(all[i].highest);
    }
    std::printf("| %.0f | %s | %.0f -> %.0f | %.2f | %.2f | %.2f |\n", pictures_per_s,
                falls ? "fall" : "rise", (falls ? full : rest) / 1e3, (falls ? rest : full) / 1e3,
                at(after_s, 0.5), at(after_s, 0.9), at(highest, 0.5));
  }
}

}  // namespace

int main() {
  return run_program("capacity_step", [] {
    std::printf(
        "| pictures/s | capacity | kB/s | known after, median, s | p90, s | highest / truth |\n");
    std::printf("| --- | --- | --- | --- | --- | --- |\n");
    for (const double load : {0.5, 0.8}) {
      for (const double pictures_per_s : {2.0, 8.0}) print(load, pictures_per_s);
    }
    return 0;
  });
}
