// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/events.hpp"

#include <algorithm>

namespace tocsin::kobuki {
namespace {

/// A sensor that exists left, centre and right, and its bit.
struct SideBit {
  Side side;
  std::uint8_t bit;
};
constexpr std::array<SideBit, 3> sides{
    {{Side::left, left_bit}, {Side::centre, centre_bit}, {Side::right, right_bit}}};
constexpr std::array<SideBit, 2> wheel_sides{
    {{Side::left, left_wheel_drop_bit}, {Side::right, right_bit}}};

bool changed(std::uint8_t a, std::uint8_t b, std::uint8_t bit) { return ((a ^ b) & bit) != 0; }

std::uint16_t adc_of(Side side, const std::optional<CliffAdc>& adc) {
  if (!adc) return 0;
  if (side == Side::left) return adc->left;
  return side == Side::centre ? adc->centre : adc->right;
}

}  // namespace

Events EventDetector::update(const Feedback& feedback) {
  Events out;
  if (feedback.input) inputs(*feedback.input, out);
  if (!feedback.core) return out;
  const CoreSensors& core = *feedback.core;
  if (core.buttons != last_.buttons) buttons(core.buttons, out);
  if (core.bumper != last_.bumper) bumpers(core.bumper, out);
  if (core.cliff != last_.cliff) cliffs(core.cliff, feedback.cliff_adc, out);
  if (core.wheel_drop != last_.wheel_drop) wheels(core.wheel_drop, out);
  power(battery_.read(core.battery_dv, core.charger), out);
  last_ = core;
  return out;
}

void EventDetector::buttons(std::uint8_t now, Events& out) {
  for (int i = 0; i < 3; ++i) {
    const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(i));
    if (changed(now, last_.buttons, bit)) out.emplace_back(ButtonEvent{i, (now & bit) != 0});
  }
}

void EventDetector::bumpers(std::uint8_t now, Events& out) {
  for (const auto& [side, bit] : sides) {
    if (changed(now, last_.bumper, bit)) out.emplace_back(BumperEvent{side, (now & bit) != 0});
  }
}

void EventDetector::cliffs(std::uint8_t now, const std::optional<CliffAdc>& adc, Events& out) {
  for (const auto& [side, bit] : sides) {
    if (!changed(now, last_.cliff, bit)) continue;
    out.emplace_back(CliffEvent{side, (now & bit) != 0, adc_of(side, adc)});
  }
}

void EventDetector::wheels(std::uint8_t now, Events& out) {
  for (const auto& [side, bit] : wheel_sides) {
    if (changed(now, last_.wheel_drop, bit))
      out.emplace_back(WheelDropEvent{side, (now & bit) != 0});
  }
}

void EventDetector::inputs(const GeneralInput& input, Events& out) {
  const std::uint16_t now = input.digital & 0x0FU;
  if (now == last_input_) return;
  last_input_ = now;
  InputEvent event;
  for (std::size_t i = 0; i < 4; ++i) event.values[i] = (now >> i & 1U) != 0;
  out.emplace_back(event);
}

void EventDetector::power(const Battery& now, Events& out) {
  plugging(now, out);
  levels(now, out);
}

void EventDetector::plugging(const Battery& now, Events& out) {
  if (now.source != source_) {
    source_ = now.source;
    charged_for_ = 0;
    if (source_ == ChargingSource::none) out.emplace_back(PowerEvent::unplugged);
    if (source_ == ChargingSource::adapter) out.emplace_back(PowerEvent::plugged_to_adapter);
    if (source_ == ChargingSource::dock) out.emplace_back(PowerEvent::plugged_to_dock);
  }
  if (now.state != ChargingState::charged) {
    charged_for_ = 0;
  } else if (charged_for_ < charged_frames && ++charged_for_ == charged_frames) {
    out.emplace_back(PowerEvent::charge_completed);
  }
}

void EventDetector::levels(const Battery& now, Events& out) {
  if (now.state != ChargingState::discharging) {
    worst_ = BatteryLevel::maximum;
    return;
  }
  if (now.level >= worst_) return;
  worst_ = now.level;
  if (worst_ == BatteryLevel::low) out.emplace_back(PowerEvent::battery_low);
  if (worst_ == BatteryLevel::dangerous) out.emplace_back(PowerEvent::battery_critical);
}

}  // namespace tocsin::kobuki
