// SPDX-License-Identifier: Apache-2.0
#include "poor_place.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/wall_file.hpp"
#include "radio_channel/channel_files.hpp"
#include "radio_channel/radio_channel.hpp"

namespace tocsin::check {
namespace {

constexpr double least_snr_db = 8;
constexpr std::uint64_t seed = 1;
const Time start{std::chrono::hours(1)};

/// The mean SNR that a tenth of the places on a grid over the walls do not reach.
double poor_snr_db(const radio::ChannelParams& params, const std::vector<geometry::Wall>& walls) {
  constexpr int steps = 20;
  auto [left, right] = std::pair{params.access_point_x_m - 10, params.access_point_x_m + 10};
  auto [bottom, top] = std::pair{params.access_point_y_m - 10, params.access_point_y_m + 10};
  if (!walls.empty()) {
    left = bottom = 1e9;
    right = top = -1e9;
  }
  for (const geometry::Wall& wall : walls) {
    left = std::min({left, wall.x1_m, wall.x2_m});
    right = std::max({right, wall.x1_m, wall.x2_m});
    bottom = std::min({bottom, wall.y1_m, wall.y2_m});
    top = std::max({top, wall.y1_m, wall.y2_m});
  }
  radio::Propagation propagation(params, walls, seed, start);
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      propagation.set_position(left + (right - left) * i / steps,
                               bottom + (top - bottom) * j / steps);
      all.push_back(propagation.mean_snr_db());
    }
  }
  const auto tenth = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 10);
  std::nth_element(all.begin(), tenth, all.end());
  return *tenth;
}

/// Beside the access point, at the power that gives this mean SNR there.
radio::ChannelParams with_snr(radio::ChannelParams params, double snr_db) {
  params.shadowing_sigma_db = 0;
  radio::Propagation propagation(params, {}, seed, start);
  propagation.set_position(params.access_point_x_m + 1, params.access_point_y_m);
  params.tx_dbm += snr_db - propagation.mean_snr_db();
  return params;
}

}  // namespace

PoorPlace poor_place(radio::ChannelParams params, const std::vector<geometry::Wall>& walls) {
  constexpr int packet_bytes = 1400;
  constexpr int full = 20;  // packets in the queue
  const Duration length = std::chrono::seconds(20);
  params.outages_s.clear();
  PoorPlace place;
  place.mean_snr_db = std::max(least_snr_db, poor_snr_db(params, walls));
  radio::RadioChannel channel(with_snr(params, place.mean_snr_db), {}, seed, start);
  channel.set_position(params.access_point_x_m + 1, params.access_point_y_m);
  int waiting = 0;
  for (Time now = start; now < start + length; now = channel.next_event()) {
    channel.advance(now);
    while (channel.take()) --waiting;
    for (; waiting < full; ++waiting) {
      (void)channel.push(radio::Direction::uplink, {packet_bytes}, now);
    }
  }
  const radio::DirectionReport uplink = channel.report(start + length).uplink;
  place.bytes_per_s = static_cast<double>(uplink.bytes_delivered) / to_seconds(length);
  place.loss = static_cast<double>(uplink.losses) / static_cast<double>(uplink.pushed);
  return place;
}

std::optional<PoorPlace> poor_place_of(const deployment::Deployment& deployment) {
  if (!deployment.radio) return std::nullopt;
  const radio::ChannelParams params = radio::load_channel(deployment.radio->channel);
  if (params.mode != "radio" || !params.trace_file.empty()) return std::nullopt;
  const bool walled = !deployment.radio->walls.empty();
  PoorPlace place = poor_place(params, walled ? geometry::load_walls(deployment.radio->walls)
                                              : std::vector<geometry::Wall>{});
  place.channel = deployment.radio->channel;
  return place;
}

}  // namespace tocsin::check
