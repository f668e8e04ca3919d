// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/emergency_stop_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "foundation/printable.hpp"

namespace tocsin {
namespace {

constexpr std::size_t longest_name = 60;

/// Of those at the station: it reaches logs and terminals.
std::vector<std::string> printable_names(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const std::string& name : names) all.push_back(printable(name, longest_name));
  return all;
}

}  // namespace

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

void EmergencyStopInput::release(const EmergencyStopLatch::Writer& writer) {
  latch_.release(writer, [this](std::uint64_t id) { return input_.writer(id).has_value(); });
}

bool EmergencyStopInput::take_local() {
  bool any = false;
  while (const auto sample = input_.take_sample()) {
    any = true;
    const auto* pressed = static_cast<const topic::EmergencyStop::Message*>(sample->message.get());
    if (pressed->data()) {
      latch_.press(writer(sample->source));
    } else {
      release(writer(sample->source));
    }
  }
  return any;
}

bool EmergencyStopInput::take_link(Time now) {
  bool any = false;
  while (const auto message = link_input_.take()) {
    any = true;
    const bool is_released = link_.on_message(
        {message->stands(), printable_names(message->stopped_by()), message->releases()}, now);
    if (is_released) release({0, true, topic::EmergencyStop::station_name});
  }
  return any;
}

bool EmergencyStopInput::take(Time now) {
  const bool local = take_local();
  const bool link = take_link(now);
  return (local || link || now >= deadline_) && update(now);
}

void EmergencyStopInput::restore(const StopMemory& memory, Time now) {
  latch_.restore(memory.latch);
  link_.restore(memory.link, now);
  (void)update(now);
}

std::vector<std::string> EmergencyStopInput::names(Time now) const {
  std::vector<std::string> all = latch_.others();
  for (std::string& name : link_.stopped_by(now)) {
    if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(std::move(name));
  }
  const std::string station = topic::EmergencyStop::station_name;
  const auto by_station = std::find(all.begin(), all.end(), station);
  const bool by_link = by_station != all.end();
  if (by_link) all.erase(by_station);
  if (by_link || latch_.stands_by_station()) all.insert(all.begin(), station);
  return all;
}

bool EmergencyStopInput::update(Time now) {
  deadline_ = link_.deadline(now);
  link_memory_ = link_.memory(now);
  const bool stood = std::exchange(stands_, latch_.stands() || link_memory_.stands);
  std::vector<std::string> before = std::exchange(stopped_by_, names(now));
  return stood != stands_ || before != stopped_by_;
}

}  // namespace tocsin
