// SPDX-License-Identifier: Apache-2.0
#include "stop_relay/stop_relay_component.hpp"

#include <utility>

#include "emergency_stop_input/stop_state_words.hpp"
#include "foundation/enum_words.hpp"
#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "named_end/named_end.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

std::string whole_name(const std::string& vehicle, const char* topic) {
  if (!is_name(vehicle)) throw ConfigError("vehicle: '" + vehicle + "' must be " + name_rule);
  return "/" + vehicle + "/" + topic;
}

}  // namespace

StopRelayComponent::StopRelayComponent(Context& context, const Params& params)
    : Component(context),
      stop_topic_(whole_name(params.vehicle, topic::EmergencyStop::info.name)),
      request_topic_(whole_name(params.vehicle, topic::EmergencyStopRequest::info.name)),
      state_topic_(whole_name(params.vehicle, topic::EmergencyStopState::info.name)),
      request_(*this, named_end<topic::EmergencyStopRequest>(request_topic_, *this)),
      state_(*this, named_end<topic::EmergencyStopState>(state_topic_, *this)),
      stop_(bus().advertise(named_end<topic::EmergencyStop>(stop_topic_, *this))) {}

void StopRelayComponent::tick(Time now) {
  take_other_station(now);
  take_site(now);
  if (const auto word = keeper_.word(now)) say(*word, now);
  wake_at(keeper_.due(now));
}

void StopRelayComponent::take_other_station(Time now) {
  while (const auto link = link_.take()) {
    if (keeper_.wanted().value_or(false) == link->stands()) continue;
    log().warn("emergency stop of the other station {}", link->stands() ? "ON" : "off");
    keeper_.on_request(link->stands(), now);
  }
}

void StopRelayComponent::take_site(Time now) {
  while (const auto message = request_.take_message()) {
    const auto request =
        std::static_pointer_cast<const topic::EmergencyStopRequest::Message>(message);
    if (!request->data() && left_.write(*request) == Status::failed)
      log().warn("a release was not passed on");
  }
  while (const auto message = state_.take_message()) {
    const auto state = std::static_pointer_cast<const topic::EmergencyStopState::Message>(message);
    const auto vehicle = value_of<VehicleStop>(state->vehicle());
    if (!vehicle || vehicle == VehicleStop::unheard) continue;
    topic::SafetyStatus::Message status;
    status.stamp(wall(now));
    status.emergency_stop(vehicle == VehicleStop::stands);
    status.stopped_by(state->stopped_by());
    if (status_.write(std::move(status)) == Status::failed)
      log().warn("the vehicle's stop was not passed on");
  }
}

void StopRelayComponent::say(bool pressed, Time now) {
  auto message = std::make_shared<topic::EmergencyStop::Message>();
  message->data(pressed);
  if (stop_->write(std::move(message)) == Status::failed) log().warn("the stop was not sent");
  keeper_.said(now);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::StopRelayComponent)
