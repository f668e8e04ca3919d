// SPDX-License-Identifier: Apache-2.0
// What several vehicles get through one channel when all always have packets of 1500 bytes, beside
// what ns-3 says (src/wifi/examples/wifi-bianchi.cc, bianchiResultsEifs of 802.11g), and what one
// far vehicle costs the others.
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "radio_channel/radio_channel.hpp"

namespace tocsin::radio {
namespace {

constexpr double length_s = 20;

/// Of each vehicle [Mbit/s]; `far_x_m`: where the first one stands.
std::vector<double> saturate(const ChannelParams& params, std::size_t vehicles, double far_x_m) {
  RadioChannel channel(params, {}, 1, Time{}, vehicles);
  channel.set_position(far_x_m, 0, 0);
  for (double t_s = 0; t_s < length_s; t_s += 0.01) {
    const Time now = Time{} + seconds(t_s);
    for (std::size_t i = 0; i < vehicles; ++i) {
      for (auto queued = channel.report(now, i).uplink.queued; queued < 40; ++queued) {
        channel.push(Direction::uplink, {1500, false, AccessCategory::best_effort, i}, now);
      }
    }
    while (channel.take()) {
    }
  }
  std::vector<double> mbps;
  for (std::size_t i = 0; i < vehicles; ++i) {
    const LinkReport report = channel.report(Time{} + seconds(length_s), i);
    mbps.push_back(static_cast<double>(report.uplink.bytes_delivered) * 8 / length_s / 1e6);
  }
  return mbps;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

ChannelParams clear_air() {
  ChannelParams params;
  params.shadowing_sigma_db = 0;
  params.rician_k_clear_db = 60;
  params.queue_frames = 200;
  params.wire_delay_s = 0;
  return params;
}

void print_saturation() {
  struct Row {
    const char* data_rate;
    double total_mbps[4];  // of 5, 10, 20, 50
  };
  const Row rows[] = {{"6", {4.69, 4.32, 3.96, 3.47}},
                      {"24", {16.08, 14.92, 13.73, 12.09}},
                      {"54", {29.29, 27.38, 25.33, 22.42}}};
  const std::size_t sizes[] = {5, 10, 20, 50};
  std::printf("rate  vehicles  ours  ns-3  ratio\n");
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < 4; ++i) {
      ChannelParams params = clear_air();
      params.data_rate = row.data_rate;
      params.attempts = 31;  // Bianchi's stations never give up a frame
      const double total = sum(saturate(params, sizes[i], 0));
      std::printf("%4s  %8zu  %5.2f  %5.2f  %.3f\n", row.data_rate, sizes[i], total,
                  row.total_mbps[i], total / row.total_mbps[i]);
    }
  }
}

void print_far_one() {
  std::printf("vehicles  all near: each  one far: far  each of the others\n");
  for (const std::size_t vehicles : {2u, 5u, 10u, 20u}) {
    const auto near = saturate(clear_air(), vehicles, 0);
    const auto mixed = saturate(clear_air(), vehicles, 140);
    const double others = static_cast<double>(vehicles) - 1;
    std::printf("%8zu  %14.2f  %12.2f  %18.2f\n", vehicles, sum(near) / (others + 1), mixed[0],
                (sum(mixed) - mixed[0]) / others);
  }
}

}  // namespace
}  // namespace tocsin::radio

int main() {
  tocsin::radio::print_saturation();
  tocsin::radio::print_far_one();
}
