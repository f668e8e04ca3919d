// SPDX-License-Identifier: Apache-2.0
#include "control.hpp"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace tocsin::kobuki {
namespace {

/// What `set` may change, copied so that it is taken as a whole or not at all.
struct Adjustable {
  BaseInputs inputs;
  LineParams line;
  ChargingSource source = ChargingSource::none;
  double charge = 0;
};

std::optional<double> number(const std::string& text, double min, double max) {
  std::istringstream in(text);
  double value = NAN;
  if (!(in >> value) || !in.eof() || !(value >= min && value <= max)) return std::nullopt;
  return value;
}

template <class Integer>
bool set_mask(Integer& to, const std::string& text, double max) {
  const auto value = number(text, 0, max);
  if (!value || *value != std::floor(*value)) return false;
  to = static_cast<Integer>(*value);
  return true;
}

bool set_share(double& to, const std::string& text) {
  const auto value = number(text, 0, 1);
  if (value) to = *value;
  return value.has_value();
}

bool set_charger(ChargingSource& to, const std::string& text) {
  static const std::map<std::string, ChargingSource> sources{{"none", ChargingSource::none},
                                                             {"adapter", ChargingSource::adapter},
                                                             {"dock", ChargingSource::dock}};
  const auto found = sources.find(text);
  if (found == sources.end()) return false;
  to = found->second;
  return true;
}

std::uint8_t* input_byte(BaseInputs& inputs, const std::string& key) {
  const std::map<std::string, std::uint8_t*> bytes{{"buttons", &inputs.buttons},
                                                   {"bumper", &inputs.bumper},
                                                   {"cliff", &inputs.cliff},
                                                   {"wheel_drop", &inputs.wheel_drop},
                                                   {"over_current", &inputs.over_current},
                                                   {"dock_right", &inputs.dock.right},
                                                   {"dock_centre", &inputs.dock.centre},
                                                   {"dock_left", &inputs.dock.left}};
  const auto found = bytes.find(key);
  return found == bytes.end() ? nullptr : found->second;
}

/// "analog0" to "analog3"
std::uint16_t* analog_input(BaseInputs& inputs, const std::string& key) {
  if (key.size() != 7 || key.rfind("analog", 0) != 0) return nullptr;
  const int index = key.back() - '0';
  return index >= 0 && index <= 3 ? &inputs.analog[static_cast<std::size_t>(index)] : nullptr;
}

bool set_line_count(int& to, const std::string& text, int max) {
  return !text.empty() && text != "0" && set_mask(to, text, max) && to >= 1;
}

bool set_one(Adjustable& settings, const std::string& key, const std::string& value) {
  if (std::uint8_t* byte = input_byte(settings.inputs, key)) return set_mask(*byte, value, 255);
  if (std::uint16_t* analog = analog_input(settings.inputs, key)) {
    return set_mask(*analog, value, 4095);
  }
  if (key == "digital") return set_mask(settings.inputs.digital, value, 65535);
  if (key == "charger") return set_charger(settings.source, value);
  if (key == "slip") return set_share(settings.inputs.slip, value);
  if (key == "charge") return set_share(settings.charge, value);
  if (key == "flip") return set_share(settings.line.flip_probability, value);
  if (key == "loss") return set_share(settings.line.loss_probability, value);
  if (key == "noise") return set_share(settings.line.noise_probability, value);
  if (key == "usb_latency_ms") return set_line_count(settings.line.usb_latency_ms, value, 16);
  if (key == "usb_packet_bytes") return set_line_count(settings.line.usb_packet_bytes, value, 62);
  return false;
}

std::string set(SimulatedBase& base, std::istringstream& words) {
  Power& power = base.model().power();
  Adjustable settings{base.model().inputs(), base.line().params(), power.source(), power.charge()};
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const bool known = equals != std::string::npos &&
                       set_one(settings, word.substr(0, equals), word.substr(equals + 1));
    if (!known) return "error: cannot set '" + word + "'";
  }
  base.model().inputs() = settings.inputs;
  base.line().configure(settings.line);
  power.plug(settings.source);
  power.set_charge(settings.charge);
  return "ok";
}

std::string place(SimulatedBase& base, std::istringstream& words) {
  geometry::Pose pose;
  if (!(words >> pose.x_m >> pose.y_m >> pose.heading_rad)) return "error: place X Y YAW";
  base.model().place(pose);
  return "ok";
}

std::string version(SimulatedBase& base, std::istringstream& words) {
  std::string hardware;
  std::string firmware;
  std::string form;
  words >> hardware >> firmware >> form;
  const bool old = form == "old";
  const bool taken = (old || form.empty()) && base.model().set_versions(hardware, firmware, old);
  return taken ? "ok" : "error: version HARDWARE FIRMWARE [old], like version 1.0.4 1.2.0";
}

std::string gains(SimulatedBase& base, std::istringstream& words) {
  double kp = -1;
  double ki = -1;
  double kd = -1;
  words >> kp >> ki >> kd;
  const auto fits = [](double gain) { return gain >= 0 && gain <= 4294967; };
  if (!words || !fits(kp) || !fits(ki) || !fits(kd)) return "error: gains P I D";
  const auto milli = [](double gain) {
    return static_cast<std::uint32_t>(std::lround(1000 * gain));
  };
  base.model().set_gains({1, milli(kp), milli(ki), milli(kd)});
  return "ok";
}

/// The seconds that follow, or `absent` when nothing does; empty when they are no duration.
std::optional<Duration> duration(std::istringstream& words, std::optional<Duration> absent) {
  std::string text;
  if (!(words >> text)) return absent;
  const auto value = number(text, 0, 1e6);
  return value ? std::optional<Duration>(seconds(*value)) : std::nullopt;
}

std::string silence(SimulatedBase& base, std::istringstream& words, Time now) {
  const auto time = duration(words, std::nullopt);
  if (!time) return "error: silence SECONDS";
  base.silence(now, *time);
  return "ok";
}

std::string unplug(SimulatedBase& base, std::istringstream& words, Time now) {
  const auto time = duration(words, Duration::max());
  if (!time) return "error: unplug [SECONDS]";
  base.unplug(now, *time);
  return "ok";
}

nlohmann::json sensors(BaseModel& model) {
  const BaseInputs& inputs = model.inputs();
  return {{"buttons", inputs.buttons},
          {"bumper", model.bumper()},
          {"cliff", inputs.cliff},
          {"wheel_drop", inputs.wheel_drop},
          {"over_current", inputs.over_current},
          {"digital", inputs.digital},
          {"analog", inputs.analog},
          {"charger", model.power().charger()},
          {"battery_dv", model.power().battery_dv()},
          {"charge", model.power().charge()}};
}

const char* led_colour(unsigned bits) {
  static constexpr const char* colours[] = {"off", "red", "green", "orange"};
  return colours[bits & 3U];
}

nlohmann::json line_state(const LineParams& line) {
  return {{"usb_latency_ms", line.usb_latency_ms},
          {"usb_packet_bytes", line.usb_packet_bytes},
          {"flip", line.flip_probability},
          {"loss", line.loss_probability},
          {"noise", line.noise_probability}};
}

std::string get(SimulatedBase& base, Time now) {
  BaseModel& model = base.model();
  const BaseOutputs& outputs = model.outputs();
  nlohmann::json state = sensors(model);
  state["x"] = model.pose().x_m;
  state["y"] = model.pose().y_m;
  state["yaw"] = model.pose().heading_rad;
  state["v"] = model.velocity().linear_mps;
  state["w"] = model.velocity().angular_rad_s;
  state["outputs"] = outputs.outputs.bits;
  state["led1"] = led_colour(outputs.outputs.bits >> 8U);
  state["led2"] = led_colour(outputs.outputs.bits >> 10U);
  state["sounds"] = outputs.sounds;
  if (outputs.last_tune) state["tune"] = static_cast<int>(*outputs.last_tune);
  if (outputs.last_tone) state["tone_hz"] = frequency_of(outputs.last_tone->note);
  state["kp"] = outputs.gains.kp_milli / 1000.0;
  state["ki"] = outputs.gains.ki_milli / 1000.0;
  state["kd"] = outputs.gains.kd_milli / 1000.0;
  const BaseMemory memory = model.memory(now);
  state["left_ticks"] = memory.left_ticks;
  state["right_ticks"] = memory.right_ticks;
  state["gyro_rad"] = memory.gyro_rad;
  state["clock_s"] = memory.clock_s;
  state["hardware"] = to_text(model.hardware());
  state["firmware"] = to_text(model.firmware());
  state["line"] = line_state(base.line().params());
  state["plugged"] = base.plugged(now);
  state["commands"] = model.command_counts().known;
  state["rejected"] = model.frame_counts().rejected;
  return state.dump();
}

}  // namespace

std::string obey_control(SimulatedBase& base, const std::string& line, Time now) {
  std::istringstream words(line);
  std::string verb;
  words >> verb;
  if (verb == "get") return get(base, now);
  if (verb == "set") return set(base, words);
  if (verb == "place") return place(base, words);
  if (verb == "version") return version(base, words);
  if (verb == "gains") return gains(base, words);
  if (verb == "silence") return silence(base, words, now);
  if (verb == "unplug") return unplug(base, words, now);
  if (verb == "plug") base.plug();
  if (verb == "reset") base.power_cycle(now);
  if (verb == "plug" || verb == "reset") return "ok";
  return "error: unknown command '" + verb + "'";
}

}  // namespace tocsin::kobuki
