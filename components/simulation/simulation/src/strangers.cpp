// SPDX-License-Identifier: Apache-2.0
#include "strangers.hpp"

#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

template <class Topic>
Endpoint endpoint_of() {
  return {Topic::info, &type_info<typename Topic::Message>()};
}

/// A write fails only while the world ends.
template <class Message>
void write(Publication& output, Message message) {
  (void)output.write(std::make_shared<const Message>(std::move(message)));
}

}  // namespace

Person::Person(SimProcess& process)
    : request_(process.advertise(endpoint_of<topic::EmergencyStopRequest>())),
      state_(process.subscribe(endpoint_of<topic::EmergencyStopState>(), *this)) {}

void Person::receive(const Sample& sample) {
  const auto& state = *static_cast<const topic::EmergencyStopState::Message*>(sample.message.get());
  confirmed_ = state.asked() == (is_pressed() ? "on" : "off") &&
               state.vehicle() == (is_pressed() ? "stands" : "may_drive");
}

void Person::press() {
  ++presses_;
  confirmed_ = false;
  ask();
}

void Person::release() {
  --presses_;
  confirmed_ = false;
  ask();
}

void Person::ask() {
  if (confirmed_) return;
  topic::EmergencyStopRequest::Message message;
  message.data(is_pressed());
  write(*request_, std::move(message));
}

void Rogue::begin(SimProcess& process) {
  process_ = &process;
  velocity_ = process.advertise(endpoint_of<topic::CmdVel>());
}

void Rogue::drive() {
  topic::CmdVel::Message message;
  message.linear().x(0.5);
  write(*velocity_, std::move(message));
}

void Rogue::end() {
  velocity_.reset();
  process_->die();
}

}  // namespace tocsin::simulation
