// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin::laser {

/// What a kind of laser measures. Noise of a reading of r metres is normal with a deviation of
/// noise_m + noise_share r + noise_square_per_m r^2.
struct LaserProfile {
  const char* name = "";
  double min_range_m = 0.15;
  double max_range_m = 12;
  double first_rad = 0;  ///< of its view, counter-clockwise from ahead
  double view_rad = 6.283185307179586;
  double turn_hz = 5.5;
  double readings_per_s = 2000;  ///< within a whole turn
  double noise_m = 0.003;
  double noise_share = 0.003;
  double noise_square_per_m = 0;
  double step_m = 0.00025;        ///< readings are multiples of it
  double beam_rad = 0.008;        ///< width of a beam
  double missing_share = 0.01;    ///< of readings that should have a return
  double mixed_share = 0.3;       ///< of beams at an edge that measure something between
  bool motor_by_request = false;  ///< of the RPLIDAR A2
};

/// Slamtec RPLIDAR A1M8 (data sheet LD108: 0.15 to 12 m, 5.5 Hz, error below 1 % of the distance)
/// and A2M8 (10 Hz), and a Kinect v1 of which one line is used (57 degrees, 0.45 to 10 m; deviation
/// 0.0014 r^2 by Khoshelham, 2011; ten times a second, every half degree). Beam width, missing and
/// mixed readings are our estimates.
[[nodiscard]] const std::vector<LaserProfile>& laser_profiles();
/// Throws ConfigError that lists the names when there is none of this one.
[[nodiscard]] const LaserProfile& find_laser_profile(const std::string& name);

}  // namespace tocsin::laser
