// SPDX-License-Identifier: Apache-2.0
#include "laser_model/laser_profile.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::laser {
namespace {

LaserProfile rplidar_a1() {
  LaserProfile profile;
  profile.name = "rplidar_a1";
  return profile;
}

LaserProfile rplidar_a2() {
  LaserProfile profile;
  profile.name = "rplidar_a2";
  profile.turn_hz = 10;
  profile.readings_per_s = 4000;
  profile.motor_by_request = true;
  return profile;
}

LaserProfile kinect() {
  LaserProfile profile;
  profile.name = "kinect";
  profile.min_range_m = 0.45;
  profile.max_range_m = 10;
  profile.view_rad = 57 * degree;
  profile.first_rad = -profile.view_rad / 2;
  profile.turn_hz = 10;
  profile.readings_per_s = 7200;
  profile.noise_m = 0.001;
  profile.noise_share = 0;
  profile.noise_square_per_m = 0.0014;
  profile.step_m = 0.001;
  profile.beam_rad = 0.002;
  return profile;
}

}  // namespace

const std::vector<LaserProfile>& laser_profiles() {
  static const std::vector<LaserProfile> all{rplidar_a1(), rplidar_a2(), kinect()};
  return all;
}

const LaserProfile& find_laser_profile(const std::string& name) {
  std::string names;
  for (const LaserProfile& one : laser_profiles()) {
    if (one.name == name) return one;
    names += (names.empty() ? "" : ", ") + std::string(one.name);
  }
  throw ConfigError(fmt::format("laser profile '{}' is not one of: {}", name, names));
}

}  // namespace tocsin::laser
