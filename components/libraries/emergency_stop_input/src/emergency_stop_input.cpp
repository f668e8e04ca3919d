// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/emergency_stop_input.hpp"

#include <fmt/format.h>

#include <string>

#include "foundation/printable.hpp"

namespace tocsin {

EmergencyStopLatch::Writer EmergencyStopInput::writer(std::uint64_t source) const {
  const auto known = input_.writer(source);
  const std::string user_data = known ? known->user_data : "";
  const bool station = user_data.find(topic::EmergencyStop::station) != std::string::npos;
  // Who has gone goes by the name that it had when it pressed.
  if (const auto pressed = latch_.name_of(source)) return {source, station, *pressed};
  const bool has_name = known && !known->name.empty();
  const std::string name = has_name ? printable(known->name, 40) : "an unknown writer";
  return {source, station, fmt::format("{} ({:016x})", name, source)};
}

std::vector<std::string> EmergencyStopInput::stopped_by() const {
  std::vector<std::string> names = latch_.others();
  if (latch_.stands_by_station()) {
    names.insert(names.begin(), topic::EmergencyStop::station_name);
  }
  return names;
}

bool EmergencyStopInput::take() {
  bool any = false;
  while (const auto sample = input_.take_sample()) {
    any = true;
    const auto* word = static_cast<const topic::EmergencyStop::Message*>(sample->message.get());
    if (word->data()) {
      latch_.press(writer(sample->source));
    } else {
      latch_.release(writer(sample->source),
                     [this](std::uint64_t id) { return input_.writer(id).has_value(); });
    }
  }
  return any;
}

}  // namespace tocsin
