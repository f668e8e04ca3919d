// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "devices/gamepad_device.hpp"
#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"
#include "geometry/twist.hpp"

namespace tocsin {

/// Which of its sticks and buttons drive.
enum class PadLayout { ps3, generic };
constexpr std::array<const char*, 2> words_of(PadLayout) { return {"ps3", "generic"}; }

/// Drives by a gamepad's stick while its dead-man button is held.
///
/// Layout `ps3`: left stick, L1 (in the numbering of old and of new kernels). Layout `generic`:
/// left stick or cross, any shoulder button. Losing the pad, or events of it, releases the button;
/// it must be pressed anew. Pure.
class GamepadTeleop {
 public:
  struct Params {
    PadLayout layout = PadLayout::ps3;
    double linear_mps = 0.5;
    double angular_rad_s = 1.5;
    double dead_zone = 0.12;
    template <class Visitor>
    void visit(Visitor& v) {
      visit_enum(v, "layout", layout, Choices{"ps3", "generic"}, "stick and dead-man button");
      v("linear_mps", linear_mps, {0.01, 2}, "[m/s] of the stick's whole way");
      v("angular_rad_s", angular_rad_s, {0.05, 6}, "[rad/s] of the stick's whole way");
      v("dead_zone", dead_zone, {0, 0.9}, "[1] share of the stick's way around its middle");
    }
  };

  explicit GamepadTeleop(const Params& params) : params_(params) {}
  void on_connect(const PadAxes& axes);
  void on_disconnect();
  void on_event(const PadEvent& event);
  [[nodiscard]] geometry::Twist velocity() const;
  /// Whether the start button, which hands control over, was pressed since this was asked.
  [[nodiscard]] bool take_start() { return std::exchange(start_, false); }

 private:
  [[nodiscard]] bool is_dead_man(std::uint16_t code) const;
  [[nodiscard]] bool is_generic() const { return params_.layout == PadLayout::generic; }
  /// [-1, 1], 0 in the dead zone and for an axis that the pad has not.
  [[nodiscard]] double deflection(std::uint16_t axis) const;

  Params params_;
  PadAxes axes_;
  std::map<std::uint16_t, std::int32_t> positions_;  ///< of axes that have moved
  bool start_ = false;
  std::map<std::uint16_t, bool> buttons_;  ///< dead-man buttons since the connection
};

}  // namespace tocsin
