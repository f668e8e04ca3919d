// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop/emergency_stop_component.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "emergency_stop_input/stop_state_words.hpp"
#include "foundation/enum_words.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

bool is_by_station(const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), topic::EmergencyStop::station_name) != names.end();
}

}  // namespace

EmergencyStopComponent::EmergencyStopComponent(Context& context, const Params& params)
    : Component(context), file_(context.state_path(".request")), keeper_(params) {
  known_.vehicle(word_of(VehicleStop::unheard));
  if (!file_.load()) return;
  keeper_.restore();
  log().warn("emergency stop ON, as before the restart");
}

void EmergencyStopComponent::tick(Time now) {
  take_requests(now);
  take_vehicle(now);
  if (const auto word = keeper_.word(now)) say(*word, now);
  keep();
  tell(now);
  wake_at(keeper_.due(now));
}

void EmergencyStopComponent::take_requests(Time now) {
  while (const auto request = request_.take()) {
    if (keeper_.wanted() != request->data()) {
      log().warn("emergency stop {}", request->data() ? "ON" : "off");
    }
    keeper_.on_request(request->data(), now);
  }
}

void EmergencyStopComponent::take_vehicle(Time now) {
  bool any = false;
  while (const auto status = status_.take()) {
    vehicle_.on_safety_status({status->emergency_stop(), status->stopped_by()}, now);
    any = true;
  }
  while (const auto link = link_.take()) {
    vehicle_.on_link({link->stands(), link->stopped_by()}, link->silence_s(), now);
    any = true;
  }
  const auto report = any ? vehicle_.report() : std::nullopt;
  if (report) see(*report);
}

void EmergencyStopComponent::see(const VehicleStopView::Report& vehicle) {
  keeper_.on_vehicle(vehicle.stands, is_by_station(vehicle.stopped_by));
  const char* const state = word_of(vehicle.stands ? VehicleStop::stands : VehicleStop::may_drive);
  if (known_.vehicle() == state && known_.stopped_by() == vehicle.stopped_by) return;
  known_.vehicle(state);
  known_.stopped_by(vehicle.stopped_by);
  told_ = false;
}

void EmergencyStopComponent::say(bool pressed, Time now) {
  topic::EmergencyStop::Message message;
  message.data(pressed);
  if (stop_.write(std::move(message)) == Status::failed) log().warn("the stop was not sent");
  keeper_.said(now);
}

/// The first time at the start, while the disk may still have room.
void EmergencyStopComponent::keep() {
  const bool pressed = keeper_.wanted() == true;
  if (kept_ == pressed) return;
  kept_ = pressed;
  if (!file_.save(pressed)) log().warn("the request cannot be kept for a restart");
}

void EmergencyStopComponent::tell(Time now) {
  const auto wanted = keeper_.wanted();
  const char* const asked = word_of(!wanted   ? StopAsked::never
                                    : *wanted ? StopAsked::on
                                              : StopAsked::off);
  if (told_ && known_.asked() == asked) return;
  known_.asked(asked);
  known_.stamp(wall(now));
  told_ = state_.write(known_) != Status::failed;
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::EmergencyStopComponent)
