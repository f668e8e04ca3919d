// SPDX-License-Identifier: Apache-2.0
#include "teleop/teleop_component.hpp"

#include <utility>

#include "foundation/enum_words.hpp"
#include "foundation/printable.hpp"

namespace tocsin {

TeleopComponent::TeleopComponent(Context& context, const Params& params, const std::string& device)
    : Component(context), name_(operator_name(params.name, device)), sender_(params.sender) {}

void TeleopComponent::take_authority() {
  constexpr std::size_t longest_name = 60;
  if (const auto state = driver_.take_latest()) {
    authority_ = {printable(state->driver(), longest_name),
                  printable(state->asked_by(), longest_name)};
  }
}

void TeleopComponent::drive(const geometry::Twist& velocity, Time now) {
  sender_.hold(velocity);
  if (const auto command = sender_.update(now)) send(*command, now);
}

void TeleopComponent::stop() {
  if (sender_.driving()) send({}, bus().now());
}

void TeleopComponent::hand_over(Time now) {
  if (const auto verb = handover_verb(authority_, name_)) request(*verb, now);
}

void TeleopComponent::take_control(Time now) {
  if (handover_verb(authority_, name_) == ControlVerb::ask) request(ControlVerb::take, now);
}

void TeleopComponent::request(ControlVerb verb, Time now) {
  topic::DriverRequest::Message message;
  message.stamp(wall(now));
  message.name(name_);
  message.verb(word_of(verb));
  if (request_.write(std::move(message)) == Status::failed) log().warn("a request was not sent");
}

void TeleopComponent::send(const geometry::Twist& velocity, Time now) {
  topic::TeleopCmdVel::Message message;
  message.header().stamp(wall(now));
  message.header().frame_id(name_);
  message.twist().linear().x(velocity.linear_mps);
  message.twist().angular().z(velocity.angular_rad_s);
  if (command_.write(std::move(message)) == Status::failed) log().warn("a velocity was not sent");
}

}  // namespace tocsin
