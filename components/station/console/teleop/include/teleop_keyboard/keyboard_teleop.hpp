// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/twist.hpp"
#include "teleop_keyboard/key_reader.hpp"

namespace tocsin {

/// Which letters drive.
enum class KeyLayout { wasd, turtlebot };
constexpr std::array<const char*, 2> words_of(KeyLayout) { return {"wasd", "turtlebot"}; }

/// Drives by the keys of a terminal, which tells presses and repeats but no releases.
///
/// A key moves the vehicle until its next repeat is overdue: after the first press that is the
/// keyboard's repeat delay, later its repeat period. Another key takes over at once; a key that
/// means nothing stops, like space. Pure; `now` must not decrease.
class KeyboardTeleop {
 public:
  struct Params {
    KeyLayout layout = KeyLayout::wasd;
    double linear_mps = 0.3;
    double angular_rad_s = 1.0;
    double step = 1.1;
    double linear_max_mps = 0.7;
    double angular_max_rad_s = 1.9;
    double repeat_delay_s = 0.7;
    double repeat_period_s = 0.25;
    template <class Visitor>
    void visit(Visitor& v) {
      visit_enum(v, "layout", layout, Choices{"wasd", "turtlebot"},
                 "keys beside the arrows and space");
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

  enum class ControlKey {
    hand_over,  ///< h: ask for control, or give it
    take,       ///< H: take it from who drives
    keep,       ///< n
  };

  /// Throws ConfigError when a speed is above its greatest.
  explicit KeyboardTeleop(const Params& params);
  void on_bytes(std::string_view bytes, Time now);
  /// What was last typed about control authority, once.
  [[nodiscard]] std::optional<ControlKey> take_control_key() {
    return std::exchange(control_key_, {});
  }
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
  [[nodiscard]] bool is_turtlebot() const { return params_.layout == KeyLayout::turtlebot; }

  struct Held {
    Key key;
    Direction direction;
    Time pressed;
    Time until;
  };
  Params params_;
  KeyReader reader_;
  std::optional<Held> held_;
  std::optional<ControlKey> control_key_;
};

}  // namespace tocsin
