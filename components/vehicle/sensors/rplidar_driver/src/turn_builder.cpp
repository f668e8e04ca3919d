// SPDX-License-Identifier: Apache-2.0
#include "rplidar_driver/turn_builder.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::rplidar {
namespace {

constexpr float unseen = std::numeric_limits<float>::quiet_NaN();
constexpr float far = std::numeric_limits<float>::infinity();
constexpr double longest_turn_s = 2;

void check(const TurnParams& params) {
  if (!(params.angle_max_deg > params.angle_min_deg)) {
    throw ConfigError(fmt::format("angle_max_deg: {} is not above angle_min_deg, {}",
                                  params.angle_max_deg, params.angle_min_deg));
  }
  if (!(params.range_max_m > params.range_min_m)) {
    throw ConfigError(fmt::format("range_max_m: {} is not above range_min_m, {}",
                                  params.range_max_m, params.range_min_m));
  }
}

}  // namespace

TurnBuilder::TurnBuilder(const TurnParams& params)
    : params_(params),
      first_rad_(params.angle_min_deg * degree),
      step_rad_(2 * pi / params.beams),
      count_(0) {
  check(params);
  const double view_rad = (params.angle_max_deg - params.angle_min_deg) * degree;
  const bool is_whole = view_rad > 2 * pi - step_rad_ / 2;
  count_ = static_cast<std::size_t>(is_whole ? params.beams
                                             : std::lround(std::floor(view_rad / step_rad_)) + 1);
}

void TurnBuilder::clear() { begun_.reset(); }

void TurnBuilder::begin(Time at) {
  begun_ = at;
  ranges_m_.assign(count_, unseen);
}

std::optional<Turn> TurnBuilder::on_reading(const Reading& reading, Time at) {
  const double past_cut_rad = whole_turn(reading.angle_rad - pi);
  // Angles jitter by some hundredths of a degree: only a large step back is the cut.
  const bool is_cut = past_cut_rad < past_cut_rad_ - pi;
  past_cut_rad_ = past_cut_rad;
  std::optional<Turn> turn;
  if (is_cut) {
    if (begun_) turn = finished(at);
    begin(at);
  }
  if (begun_) put(reading);
  return turn;
}

void TurnBuilder::put(const Reading& reading) {
  const double bearing_rad =
      std::remainder(params_.inverted ? reading.angle_rad : -reading.angle_rad, 2 * pi);
  // The beam at -180 degrees also has what lies just before +180.
  double steps = std::round((bearing_rad - first_rad_) / step_rad_);
  if (steps < 0) steps += params_.beams;
  if (steps >= params_.beams) steps -= params_.beams;
  if (steps < 0 || steps >= static_cast<double>(count_)) return;
  float& beam = ranges_m_[static_cast<std::size_t>(steps)];
  if (reading.range_m <= 0 || reading.range_m > params_.range_max_m) {
    if (std::isnan(beam)) beam = far;
    return;
  }
  const float range_m =
      reading.range_m < params_.range_min_m ? -far : static_cast<float>(reading.range_m);
  if (!(beam <= range_m)) beam = range_m;
}

std::optional<Turn> TurnBuilder::finished(Time at) const {
  const double period_s = to_seconds(at - *begun_);
  if (period_s <= 0 || period_s > longest_turn_s) return std::nullopt;
  const double beam_s = period_s / params_.beams;
  // Clockwise, the beam at -180 degrees is the last of the turn, that at angle_min_deg as much
  // before.
  const double skipped = (first_rad_ + pi) / step_rad_;
  const double first_s = params_.inverted ? skipped * beam_s : period_s - skipped * beam_s;
  return Turn{ranges_m_, *begun_ + seconds(first_s), params_.inverted ? beam_s : -beam_s, period_s};
}

}  // namespace tocsin::rplidar
