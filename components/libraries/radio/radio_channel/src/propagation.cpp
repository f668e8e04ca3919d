// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/propagation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/wall.hpp"
#include "radio_channel/random.hpp"

namespace tocsin::radio {
namespace {

constexpr double farthest_m = 1e6;
constexpr Duration fading_hold{4'000'000};

double log_distance_db(const ChannelParams& p, double distance_m) {
  const double d = std::max(distance_m, 1.0);
  const double near = std::min(d, p.breakpoint_m);
  return p.loss_at_1m_db + 10 * p.exponent_near * std::log10(near) +
         10 * p.exponent_far * std::log10(d / near);
}

}  // namespace

std::uint64_t own_seed(const ChannelParams& params, std::uint64_t site) {
  constexpr std::uint64_t stream = 7;
  return params.shared_shadowing < 1 ? RandomStream(site, stream).bits() : site;
}

std::uint64_t vehicle_seed(std::uint64_t radio, std::size_t vehicle) {
  constexpr std::uint64_t first_stream = 100;
  return vehicle == 0 ? radio : RandomStream(radio, first_stream + vehicle).bits();
}

Propagation::Propagation(const ChannelParams& params, std::vector<geometry::Wall> walls,
                         std::uint64_t seed, Time start, std::size_t vehicle)
    : params_(params),
      walls_(std::move(walls)),
      shadowing_(params.shadowing_sigma_db * std::sqrt(params.shared_shadowing),
                 params.shadowing_distance_m, seed),
      own_shadowing_(params.shadowing_sigma_db * std::sqrt(1 - params.shared_shadowing),
                     params.shadowing_distance_m, own_seed(params, seed)),
      fading_(299.792458 / params.frequency_mhz, params.environment_doppler_hz,
              vehicle_seed(own_seed(params, seed), vehicle)),
      start_(start) {
  if (params.trace && params.trace_random_start) {
    RandomStream random(vehicle_seed(own_seed(params, seed), vehicle), 6);
    trace_start_s_ = random.uniform() * params.trace->length_s();
  }
  set_position(0, 0);
  follow(start);
}

double Propagation::trace_s(Time now) const { return trace_start_s_ + to_seconds(now - start_); }

void Propagation::follow(Time now) {
  if (params_.trace) mean_rssi_dbm_ = params_.trace->rssi_dbm(trace_s(now));
}

double Propagation::wall_loss_db() const {
  double sum = 0;
  const geometry::Point access_point{params_.access_point_x_m, params_.access_point_y_m};
  for (const geometry::Wall& wall : walls_) {
    if (crosses(wall, access_point, {x_m_, y_m_})) sum += wall.loss_db;
  }
  return sum;
}

void Propagation::set_position(double x_m, double y_m) {
  if (!(std::abs(x_m) <= farthest_m && std::abs(y_m) <= farthest_m)) return;
  x_m_ = x_m;
  y_m_ = y_m;
  const double walls_db = wall_loss_db();
  path_loss_db_ = walls_db + log_distance_db(params_, std::hypot(x_m - params_.access_point_x_m,
                                                                 y_m - params_.access_point_y_m));
  if (!params_.trace) {
    mean_rssi_dbm_ = params_.tx_dbm - path_loss_db_ + shadowing_.at(x_m, y_m);
    if (params_.shared_shadowing < 1) mean_rssi_dbm_ += own_shadowing_.at(x_m, y_m);
  }
  fading_.move_to(x_m, y_m, walls_db > 0 ? params_.rician_k_walled_db : params_.rician_k_clear_db);
  faded_from_ = never;
}

void Propagation::fade(Time now) {
  const Duration since_start = (now - start_) / fading_hold * fading_hold;
  follow(now);
  rssi_dbm_ = mean_rssi_dbm_ + fading_.gain_db(to_seconds(since_start));
  faded_from_ = start_ + since_start;
  faded_until_ = faded_from_ + fading_hold;
}

}  // namespace tocsin::radio
