// SPDX-License-Identifier: Apache-2.0
// How fast the radio model runs. Counters: simulated seconds per second, time per frame.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "radio_channel/radio_channel.hpp"

namespace tocsin::radio {
namespace {

constexpr double slice_s = 10;  // simulated time of one iteration

/// Walls as many as in the map of the demo.
std::vector<geometry::Wall> forty_walls() {
  std::vector<geometry::Wall> walls;
  for (int i = 0; i < 40; ++i) walls.push_back({3.0 + i, -20, 3.0 + i, -2.0 - i % 3, 3.4});
  return walls;
}

/// Probes of 92 bytes, 20 in every 0.3 s as the thesis sent them, and telemetry of 200 bytes at 20
/// Hz; plus a camera of this rate in packets of 1400 bytes.
class Traffic {
 public:
  explicit Traffic(double camera_mbps) : camera_s_(1400 * 8 / (camera_mbps * 1e6)) {
    if (camera_mbps == 0) next_camera_s_ = HUGE_VAL;
  }

  /// Runs the channel over the next slice; returns the number of frames pushed.
  int run(RadioChannel& channel) {
    int frames = 0;
    const double end_s = now_s_ + slice_s;
    while (true) {
      now_s_ = std::min({next_move_s_, next_probe_s_, next_telemetry_s_, next_camera_s_});
      if (now_s_ >= end_s) break;
      frames += step(channel);
      while (auto outcome = channel.take()) benchmark::DoNotOptimize(outcome->at);
    }
    now_s_ = end_s;
    return frames;
  }

 private:
  int step(RadioChannel& channel) {
    const Time now = Time{} + seconds(now_s_);
    if (now_s_ == next_move_s_) {
      channel.set_position(2 + 8 * (1 + std::sin(now_s_ / 40)), 5 * std::cos(now_s_ / 40));
      next_move_s_ += 0.05;
      return 0;
    }
    if (now_s_ == next_probe_s_) {
      channel.push(Direction::uplink, {92}, now);
      channel.push(Direction::downlink, {92}, now);
      next_probe_s_ += 0.3;
      return 2;
    }
    const bool camera = now_s_ == next_camera_s_;
    channel.push(Direction::uplink, {camera ? 1400 : 200}, now);
    (camera ? next_camera_s_ : next_telemetry_s_) += camera ? camera_s_ : 0.05;
    return 1;
  }

  double camera_s_;
  double now_s_ = 0;
  double next_move_s_ = 0;
  double next_probe_s_ = 0.01;
  double next_telemetry_s_ = 0.02;
  double next_camera_s_ = 0.03;
};

/// Arguments: mean SNR at 10 m in dB, camera in hundreds of kbit/s.
void radio(benchmark::State& state) {
  ChannelParams params;
  params.noise_dbm = 16 - 62.6 - static_cast<double>(state.range(0));
  params.background_load = 0.3;
  RadioChannel channel(params, forty_walls(), 1, Time{});
  Traffic traffic(static_cast<double>(state.range(1)) / 10);
  double frames = 0;
  double simulated_s = 0;
  for (auto _ : state) {
    frames += traffic.run(channel);
    simulated_s += slice_s;
  }
  using benchmark::Counter;
  state.counters["simulated_s_per_s"] = Counter(simulated_s, Counter::kIsRate);
  state.counters["per_frame"] = Counter(frames, Counter::kIsRate | Counter::kInvert);
}
BENCHMARK(radio)->ArgNames({"snr_db", "camera_100kbps"})->ArgsProduct({{6, 15, 30}, {0, 25}});

}  // namespace
}  // namespace tocsin::radio

BENCHMARK_MAIN();
