// SPDX-License-Identifier: Apache-2.0
#include "base_commands.hpp"

#include <cmath>
#include <limits>

namespace tocsin::kobuki {
namespace {

namespace msg = kobuki_ros_interfaces::msg;

std::optional<std::uint32_t> milli(double gain) {
  const double value = std::round(1000.0 * gain);
  if (!(value >= 0 && value <= std::numeric_limits<std::uint32_t>::max())) return std::nullopt;
  return static_cast<std::uint32_t>(value);
}

}  // namespace

std::optional<OutputRegister> with_led(OutputRegister outputs, int led, std::uint8_t colour) {
  using namespace msg::Led_Constants;
  if (colour > RED) return std::nullopt;
  const bool red = colour == RED || colour == ORANGE;
  const bool green = colour == GREEN || colour == ORANGE;
  outputs.set_led(led, red, green);
  return outputs;
}

OutputRegister with_outputs(OutputRegister outputs, const msg::DigitalOutput& wanted) {
  for (int i = 0; i < 4; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (wanted.mask()[at]) outputs.set_output(i, wanted.values()[at]);
  }
  return outputs;
}

std::optional<OutputRegister> with_supply(OutputRegister outputs,
                                          const msg::ExternalPower& wanted) {
  if (wanted.source() > 3 || wanted.state() > 1) return std::nullopt;
  outputs.set_supply(wanted.source(), wanted.state() == 1);
  return outputs;
}

std::optional<Tune> tune_of(const msg::Sound& sound) {
  if (sound.value() > static_cast<std::uint8_t>(Tune::cleaning_end)) return std::nullopt;
  return static_cast<Tune>(sound.value());
}

std::optional<ControllerGains> gains_of(const msg::ControllerInfo& info) {
  const auto kp = milli(info.p_gain());
  const auto ki = milli(info.i_gain());
  const auto kd = milli(info.d_gain());
  if (info.type() > 1 || !kp || !ki || !kd) return std::nullopt;
  return ControllerGains{info.type(), *kp, *ki, *kd};
}

msg::ControllerInfo to_message(const ControllerGains& gains) {
  msg::ControllerInfo message;
  message.type(gains.type);
  message.p_gain(gains.kp_milli / 1000.0);
  message.i_gain(gains.ki_milli / 1000.0);
  message.d_gain(gains.kd_milli / 1000.0);
  return message;
}

}  // namespace tocsin::kobuki
