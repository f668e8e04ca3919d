// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "kobuki_protocol/battery.hpp"
#include "kobuki_protocol/feedback.hpp"

namespace tocsin::kobuki {

enum class Side : std::uint8_t { left, centre, right };

struct ButtonEvent {
  int button = 0;  ///< 0 to 2
  bool pressed = false;
};
struct BumperEvent {
  Side side = Side::left;
  bool pressed = false;
};
struct CliffEvent {
  Side side = Side::left;
  bool cliff = false;
  std::uint16_t adc = 0;  ///< of this sensor in the same frame; 0 when the frame had none
};
struct WheelDropEvent {
  Side side = Side::left;  ///< left or right
  bool dropped = false;
};
enum class PowerEvent : std::uint8_t {
  unplugged,
  plugged_to_adapter,
  plugged_to_dock,
  charge_completed,
  battery_low,
  battery_critical
};
struct InputEvent {
  std::array<bool, 4> values{};
};

using Event =
    std::variant<ButtonEvent, BumperEvent, CliffEvent, WheelDropEvent, PowerEvent, InputEvent>;

/// The events of one frame; mostly none, which costs nothing.
using Events = std::vector<Event>;

/// Turns states into edges. All states are false at the start, so what is already true at the first
/// frame is an event.
///
/// Power: plugging is reported from any source to any other. "Charged" must last
/// `charged_frames` frames, because the firmware says it briefly after plugging in. Low and
/// critical come once each until the base has been charged, so that a sagging voltage does not
/// chatter.
class EventDetector {
 public:
  static constexpr int charged_frames = 50;  ///< 1 s

  explicit EventDetector(const BatteryParams& params) : battery_(params) {}
  [[nodiscard]] Events update(const Feedback& feedback);

 private:
  void buttons(std::uint8_t now, Events& out);
  void bumpers(std::uint8_t now, Events& out);
  void cliffs(std::uint8_t now, const std::optional<CliffAdc>& adc, Events& out);
  void wheels(std::uint8_t now, Events& out);
  void inputs(const GeneralInput& input, Events& out);
  void power(const Battery& now, Events& out);
  void plugging(const Battery& now, Events& out);
  void levels(const Battery& now, Events& out);

  BatteryReader battery_;
  CoreSensors last_;
  std::uint16_t last_input_ = 0;
  ChargingSource source_ = ChargingSource::none;
  int charged_for_ = 0;
  BatteryLevel worst_ = BatteryLevel::maximum;
};

}  // namespace tocsin::kobuki
