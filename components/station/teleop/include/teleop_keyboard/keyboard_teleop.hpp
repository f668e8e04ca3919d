// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "foundation/time.hpp"
#include "geometry/twist.hpp"
#include "teleop_keyboard/key_reader.hpp"

namespace tocsin {

/// Drives by the keys of a terminal, which tells presses and repeats but no releases.
///
/// A key moves the vehicle until its next repeat is overdue: after the first press that is the
/// keyboard's repeat delay, later its repeat period. Another key takes over at once; a key that
/// means nothing stops, like space. Pure; `now` must not decrease.
class KeyboardTeleop {
 public:
  struct Params {
    std::string layout = "wasd";
    double linear_mps = 0.3;
    double angular_rad_s = 1.0;
    double step = 1.1;
    double linear_max_mps = 0.7;
    double angular_max_rad_s = 1.9;
    double repeat_delay_s = 0.7;
    double repeat_period_s = 0.25;
    template <class Visitor>
    void visit(Visitor& v) {
      v("layout", layout, {"wasd", "turtlebot"}, "keys beside the arrows and space");
      v("linear_mps", linear_mps, {0.01, 2}, "[m/s] speed at the start");
      v("angular_rad_s", angular_rad_s, {0.05, 6}, "[rad/s] turn rate at the start");
      v("step", step, {1.01, 2}, "[1] factor of one step of speed");
      v("linear_max_mps", linear_max_mps, {0.01, 2}, "[m/s] no step goes beyond it");
      v("angular_max_rad_s", angular_max_rad_s, {0.05, 6}, "[rad/s] no step goes beyond it");
      v("repeat_delay_s", repeat_delay_s, {0.1, 2},
        "[s] longest wait for a held key's first repeat");
      v("repeat_period_s", repeat_period_s, {0.05, 1}, "[s] longest wait for its next ones");
    }
  };

  /// Throws ConfigError when a speed is above its greatest.
  explicit KeyboardTeleop(const Params& params);
  void on_bytes(std::string_view bytes, Time now);
  /// What was last typed of the wheel, once: 'h' (hand over) or 'n' (no).
  [[nodiscard]] std::optional<char> take_wheel_key() { return std::exchange(wheel_key_, {}); }
  /// Nobody can press a key any more: stand.
  void on_end() { held_.reset(); }

  [[nodiscard]] geometry::Twist velocity(Time now) const;
  /// When the held key counts as released; `never` when none is held.
  [[nodiscard]] Time next_deadline(Time now) const;
  /// The speeds that keys give: [m/s], [rad/s].
  [[nodiscard]] double linear_mps() const { return params_.linear_mps; }
  [[nodiscard]] double angular_rad_s() const { return params_.angular_rad_s; }
  /// The keys, for people; several lines.
  [[nodiscard]] std::string help() const;

 private:
  /// A direction: forward, turning left.
  struct Direction {
    double linear = 0;
    double angular = 0;
  };
  void on_key(const Key& key, Time now);
  void press(const Key& key, const Direction& direction, Time now);
  [[nodiscard]] std::optional<Direction> direction_of(const Key& key) const;
  [[nodiscard]] bool change_speed(char key);
  [[nodiscard]] bool is_turtlebot() const { return params_.layout == "turtlebot"; }

  struct Held {
    Key key;
    Direction direction;
    Time pressed;
    Time until;
  };
  Params params_;
  KeyReader reader_;
  std::optional<Held> held_;
  std::optional<char> wheel_key_;
};

}  // namespace tocsin
