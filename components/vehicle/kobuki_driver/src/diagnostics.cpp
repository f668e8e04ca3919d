// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/diagnostics.hpp"

#include <cstdio>

namespace tocsin::kobuki {
namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string bit(unsigned mask, unsigned which) { return (mask & which) != 0 ? "yes" : "no"; }

Values sides(unsigned mask) {
  return {{"left", bit(mask, left_bit)},
          {"centre", bit(mask, centre_bit)},
          {"right", bit(mask, right_bit)}};
}

/// A warning with `text` when any bit is set.
Diagnosis by_mask(const char* name, unsigned mask, const char* text, Values values) {
  if (mask == 0) return {Health::ok, name, "all right", std::move(values)};
  return {Health::warn, name, text, std::move(values)};
}

Diagnosis battery(const Reading& reading) {
  static constexpr const char* levels[] = {"dangerously low", "low", "healthy", "full"};
  static constexpr const char* states[] = {"discharging", "charged", "charging"};
  static constexpr const char* sources[] = {"none", "adapter", "dock"};
  const Battery& b = reading.battery;
  Health level = Health::ok;
  if (b.level == BatteryLevel::low) level = Health::warn;
  if (b.level == BatteryLevel::dangerous) level = Health::error;
  return {level,
          "Battery",
          levels[static_cast<std::size_t>(b.level)],
          {{"voltage_v", number(b.voltage_v)},
           {"percentage", number(b.percentage)},
           {"charging_state", states[static_cast<std::size_t>(b.state)]},
           {"charging_source", sources[static_cast<std::size_t>(b.source)]}}};
}

Diagnosis watchdog(BaseState state) {
  switch (state) {
    case BaseState::online:
      return {Health::ok, "Watchdog", "online", {}};
    case BaseState::refused:
      return {Health::error, "Watchdog", "refused: firmware of another major version", {}};
    case BaseState::silent:
      return {Health::error, "Watchdog", "the port is open, but no frames come", {}};
    case BaseState::no_port:
      break;
  }
  return {Health::error, "Watchdog", "the port is closed", {}};
}

Diagnosis cliff(const Reading& reading) {
  const unsigned mask = reading.feedback.core->cliff;
  Values values = sides(mask);
  if (const auto& adc = reading.feedback.cliff_adc) {
    values.emplace_back("left_adc", std::to_string(adc->left));
    values.emplace_back("centre_adc", std::to_string(adc->centre));
    values.emplace_back("right_adc", std::to_string(adc->right));
  }
  return by_mask("Cliff Sensor", mask, "at a cliff", std::move(values));
}

Diagnosis wheel_drop(const Reading& reading) {
  const unsigned mask = reading.feedback.core->wheel_drop;
  return by_mask("Wheel Drop", mask, "a wheel hangs",
                 {{"left", bit(mask, left_wheel_drop_bit)}, {"right", bit(mask, right_bit)}});
}

Diagnosis motor_current(const Reading& reading) {
  const unsigned mask = reading.feedback.core->over_current;
  Values values;
  if (const auto& current = reading.feedback.current) {
    values = {{"left_a", number(current->left / 100.0)},
              {"right_a", number(current->right / 100.0)}};
  }
  values.emplace_back("left_over_current", bit(mask, left_over_current_bit));
  values.emplace_back("right_over_current", bit(mask, right_over_current_bit));
  return by_mask("Motor Current", mask, "over current: a motor was cut off", std::move(values));
}

Diagnosis motor_state(const KobukiDriver& driver) {
  if (driver.emergency_stop()) {
    return {Health::warn, "Motor State", "held by the emergency stop: velocities are ignored", {}};
  }
  if (driver.motor_power()) return {Health::ok, "Motor State", "on", {}};
  return {Health::ok, "Motor State", "off: velocities are ignored", {}};
}

Diagnosis gyro(const Reading& reading) {
  if (!reading.feedback.inertia) return {Health::warn, "Gyro Sensor", "sends nothing", {}};
  return {Health::ok,
          "Gyro Sensor",
          "sends",
          {{"heading_rad", number(reading.gyro_heading_rad)},
           {"rate_rad_s", number(reading.gyro_rate_rad_s)}}};
}

Diagnosis digital_input(const Reading& reading) {
  Values values;
  if (const auto& input = reading.feedback.input) {
    for (unsigned i = 0; i < 4; ++i) {
      values.emplace_back("DI" + std::to_string(i), bit(input->digital, 1U << i));
    }
  }
  return {Health::ok, "Digital Input", "as read", std::move(values)};
}

Diagnosis analog_input(const Reading& reading) {
  Values values;
  if (const auto& input = reading.feedback.input) {
    for (std::size_t i = 0; i < input->analog.size(); ++i) {
      values.emplace_back("AI" + std::to_string(i) + "_adc", std::to_string(input->analog[i]));
    }
  }
  return {Health::ok, "Analog Input", "as read", std::move(values)};
}

/// Counters since the start; they judge nothing, because a fault of an hour ago is no fault now.
Diagnosis serial_line(const KobukiDriver& driver) {
  const auto text = [](std::uint64_t count) { return std::to_string(count); };
  const Reassembler::Counts& frames = driver.frame_counts();
  const DecodeCounts& subs = driver.decode_counts();
  return {Health::ok,
          "Serial Line",
          "counters",
          {{"frames", text(frames.frames)},
           {"frames_rejected", text(frames.rejected)},
           {"bytes_discarded", text(frames.discarded)},
           {"sub_payloads_unknown", text(subs.unknown)},
           {"sub_payloads_malformed", text(subs.malformed)},
           {"sub_payloads_truncated", text(subs.truncated)},
           {"odometry_jumps_left_out", text(driver.odometry().rejected_jumps())}}};
}

}  // namespace

std::vector<Diagnosis> diagnose(const KobukiDriver& driver, const Reading* last) {
  std::vector<Diagnosis> all{watchdog(driver.state()), motor_state(driver), serial_line(driver)};
  if (last == nullptr) return all;
  const unsigned bumper = last->feedback.core->bumper;
  std::vector<Diagnosis> sensors{battery(*last),
                                 cliff(*last),
                                 by_mask("Wall Sensor", bumper, "at an obstacle", sides(bumper)),
                                 wheel_drop(*last),
                                 motor_current(*last),
                                 gyro(*last),
                                 digital_input(*last),
                                 analog_input(*last)};
  const bool stale = driver.state() != BaseState::online;
  for (Diagnosis& sensor : sensors) {
    if (stale) sensor.level = Health::stale;
    all.push_back(std::move(sensor));
  }
  return all;
}

}  // namespace tocsin::kobuki
