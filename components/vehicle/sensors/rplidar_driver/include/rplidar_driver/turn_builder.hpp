// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "rplidar_protocol/answer.hpp"

namespace tocsin::rplidar {

/// What of a turn is told.
struct TurnParams {
  int beams = 360;
  double angle_min_deg = -180;
  double angle_max_deg = 180;
  double range_min_m = 0.15;
  double range_max_m = 12;
  bool inverted = false;
  template <class Visitor>
  void visit(Visitor& v) {
    v("beams", beams, {36, 3600}, "[1] of a whole turn, evenly spaced; the nearest reading counts");
    v("angle_min_deg", angle_min_deg, {-180, 180},
      "[deg] of the first beam, from ahead to the left");
    v("angle_max_deg", angle_max_deg, {-180, 180}, "[deg] of the last beam; above angle_min_deg");
    v("range_min_m", range_min_m, {0, 10}, "[m] nearer readings are -inf");
    v("range_max_m", range_max_m, {0.5, 40}, "[m] farther readings are +inf");
    v("inverted", inverted, "mounted upside down");
  }
};

/// One turn of the laser, cut behind it, its beams counter-clockwise.
struct Turn {
  std::vector<float> ranges_m;  ///< NaN: no reading, +inf: no return, -inf: too near (REP 117)
  Time first;                   ///< of beam 0; a device that turns clockwise measures it last
  double interval_s = 0;  ///< from beam to beam; negative when they are told backwards in time
  double period_s = 0;    ///< of the turn
};

/// Assembles turns from readings. Pure.
class TurnBuilder {
 public:
  /// Throws ConfigError when angle_max_deg is not above angle_min_deg, or range_max_m not above
  /// range_min_m.
  explicit TurnBuilder(const TurnParams& params);

  /// Takes a reading that was made at `at`; returns the turn that it ends. `at` must not decrease.
  std::optional<Turn> on_reading(const Reading& reading, Time at);
  /// What was begun is forgotten.
  void clear();

  [[nodiscard]] double first_rad() const { return first_rad_; }
  [[nodiscard]] double step_rad() const { return step_rad_; }
  [[nodiscard]] std::size_t beams() const { return count_; }

 private:
  void begin(Time at);
  void put(const Reading& reading);
  [[nodiscard]] std::optional<Turn> finished(Time at) const;

  TurnParams params_;
  double first_rad_;
  double step_rad_;
  std::size_t count_;
  std::optional<Time> begun_;  ///< empty: the first cut has not come
  double past_cut_rad_ = 0;    ///< of the last reading, clockwise from behind
  std::vector<float> ranges_m_;
};

}  // namespace tocsin::rplidar
