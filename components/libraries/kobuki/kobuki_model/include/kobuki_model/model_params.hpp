// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "kobuki_protocol/dimensions.hpp"

namespace tocsin::kobuki {

/// The simulated base. Times and noises are our estimates unless a source is named.
struct ModelParams {
  double acceleration_mps2 = 1.5;
  double command_delay_s = 0.1;
  double command_timeout_s = 0;
  double slip_sigma = 0.01;
  double left_wheel_scale = 1.0;
  double right_wheel_scale = 1.0;
  double encoder_noise_ticks = 0;
  double gyro_drift_deg_per_sqrt_s = 0.01;
  double gyro_scale = 1.0;
  double gyro_bias_dps = 0;
  double gyro_noise_dps = 0.1;
  double infrared_loss = 0;
  double battery_capacity_ah = 2.2;
  double battery_charge = 0.9;
  double battery_drain_scale = 1.0;
  std::string hardware = "1.0.4";
  std::string firmware = "1.2.0";
  bool old_versions = false;
  template <class Visitor>
  void visit(Visitor& v) {
    v("acceleration_mps2", acceleration_mps2, {0.1, 20}, "[m/s2] of each wheel");
    v("command_delay_s", command_delay_s, {0, 1}, "[s] command to wheels; 0.2 was reported");
    v("command_timeout_s", command_timeout_s, {0, 60},
      "[s] the base stops itself after this silence; 0 is never");
    v("slip_sigma", slip_sigma, {0, 0.5}, "[1] deviation of true from rolled distance per 20 ms");
    v("left_wheel_scale", left_wheel_scale, {0.8, 1.2}, "[1] true over nominal distance, left");
    v("right_wheel_scale", right_wheel_scale, {0.8, 1.2}, "[1] true over nominal distance, right");
    v("encoder_noise_ticks", encoder_noise_ticks, {0, 100},
      "[tick] deviation of each reported encoder, beside rounding to whole ticks");
    v("gyro_drift_deg_per_sqrt_s", gyro_drift_deg_per_sqrt_s, {0, 10},
      "[deg/sqrt(s)] random walk of the reported angle");
    v("gyro_scale", gyro_scale, {0.8, 1.2}, "[1] reported over true turn");
    v("gyro_bias_dps", gyro_bias_dps, {-10, 10}, "[deg/s] reported while standing still");
    v("gyro_noise_dps", gyro_noise_dps, {0, 10}, "[deg/s] deviation of each raw sample");
    v("infrared_loss", infrared_loss, {0, 0.99},
      "[1] share of a dock's signals that a receiver misses in a frame");
    v("battery_capacity_ah", battery_capacity_ah, {0.1, 20}, "[Ah] small pack 2.2, large 4.4");
    v("battery_charge", battery_charge, {0, 1}, "[1] at the start");
    v("battery_drain_scale", battery_drain_scale, {0, 10000}, "[1] faster draining and charging");
    v("hardware", hardware, "version as major.minor.patch");
    v("firmware", firmware, "version as major.minor.patch");
    v("old_versions", old_versions, "answers versions in the old 2-byte form");
  }
};

}  // namespace tocsin::kobuki
