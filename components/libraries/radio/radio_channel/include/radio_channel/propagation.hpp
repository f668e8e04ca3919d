// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "foundation/time.hpp"
#include "geometry/wall.hpp"
#include "radio_channel/channel_params.hpp"
#include "radio_channel/fading.hpp"
#include "radio_channel/shadowing.hpp"

namespace tocsin::radio {

/// What is drawn of a radio by itself has this seed: that of the site for its first one.
[[nodiscard]] std::uint64_t own_seed(const ChannelParams& params, std::uint64_t site);

/// What is drawn for one vehicle has this seed: that of the radio for the first one.
[[nodiscard]] std::uint64_t vehicle_seed(std::uint64_t radio, std::size_t vehicle);

/// Received power over position and time: log distance, walls, shadowing, fading. The same in both
/// directions (reciprocal channel, equal transmit powers).
class Propagation {
 public:
  /// `seed` of the site: see own_seed(). `start` is time zero of the fading. Vehicles at one place
  /// have the same shadowing there, and fading of their own.
  Propagation(const ChannelParams& params, std::vector<geometry::Wall> walls, std::uint64_t seed,
              Time start, std::size_t vehicle = 0);

  /// Moves the station, in metres in the map frame. A position that is not finite or
  /// beyond 1000 km is ignored.
  void set_position(double x_m, double y_m);

  /// Loss of path and walls, without shadowing.
  [[nodiscard]] double path_loss_db() const { return path_loss_db_; }
  /// Brings the mean up to `now`; only a trace changes it without a move.
  void follow(Time now);
  /// A trace says that nothing comes through at `now`.
  [[nodiscard]] bool dead(Time now) const {
    return params_.trace && params_.trace->dead(trace_s(now));
  }
  /// What a trace adds to the delay of one way at `now`.
  [[nodiscard]] Duration extra_delay(Time now) const {
    return params_.trace ? seconds(params_.trace->one_way_s(trace_s(now))) : Duration::zero();
  }
  /// Mean over fading.
  [[nodiscard]] double mean_rssi_dbm() const { return mean_rssi_dbm_; }
  [[nodiscard]] double mean_snr_db() const { return mean_rssi_dbm_ - params_.noise_dbm; }
  /// At `now`. Fading is held for 4 ms, far below its coherence time.
  [[nodiscard]] double rssi_dbm(Time now) {
    if (now < faded_from_ || now >= faded_until_) fade(now);
    return rssi_dbm_;
  }
  [[nodiscard]] double x_m() const { return x_m_; }
  [[nodiscard]] double y_m() const { return y_m_; }

 private:
  [[nodiscard]] double wall_loss_db() const;
  [[nodiscard]] double trace_s(Time now) const;
  void fade(Time now);

  ChannelParams params_;
  std::vector<geometry::Wall> walls_;
  ShadowingField shadowing_;
  ShadowingField own_shadowing_;  ///< what this radio does not share
  RicianFading fading_;
  Time start_;
  double trace_start_s_ = 0;
  double x_m_ = 0;
  double y_m_ = 0;
  double path_loss_db_ = 0;
  double mean_rssi_dbm_ = 0;
  double rssi_dbm_ = 0;
  Time faded_from_ = never;  // when rssi_dbm_ holds
  Time faded_until_ = never;
};

}  // namespace tocsin::radio
