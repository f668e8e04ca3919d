// SPDX-License-Identifier: Apache-2.0
#include "teleop_receiver/teleop_receiver_component.hpp"

#include <algorithm>

#include "foundation/enum_words.hpp"
#include "foundation/printable.hpp"
#include "runtime/component_entry.hpp"
#include "tocsin_idl/control_verb.hpp"

namespace tocsin {
namespace {

constexpr std::size_t most_devices = 16;  // of a peer that invents names

std::int64_t to_ns(const builtin_interfaces::msg::Time& stamp) {
  return std::int64_t{stamp.sec()} * 1'000'000'000 + stamp.nanosec();
}

/// Of an operator, for other operators.
std::string name_of(const std::string& given) {
  return given.empty() ? "unnamed" : printable(given, 60);
}

}  // namespace

void TeleopReceiverComponent::tick(Time now) {
  while (const auto request = request_.take()) obey(*request, now);
  while (const auto command = command_.take()) follow(*command, now);
  authority_.settle(now);
  const bool changed = authority_.driver() != driver_ || authority_.asked_by() != asked_by_;
  if (changed || (authority_.driver() && now >= next_report_)) publish_driver(now);
  wake_at(authority_.driver() ? std::min(authority_.next_deadline(), next_report_) : never);
}

void TeleopReceiverComponent::follow(const topic::TeleopCmdVel::Message& command, Time now) {
  const bool fresh = is_fresh(command, now);
  if (!fresh && !was_late_) log().warn("velocities from the operator are too late");
  was_late_ = !fresh;
  if (!fresh || !authority_.follows(name_of(command.header().frame_id()), now)) return;
  if (cmd_vel_.write(command.twist()) == Status::failed) log().warn("a velocity was not sent");
}

void TeleopReceiverComponent::obey(const topic::DriverRequest::Message& request, Time now) {
  const std::string name = name_of(request.name());
  const auto verb = value_of<ControlVerb>(request.verb());
  if (verb == ControlVerb::ask) return authority_.ask(name, now);
  if (verb == ControlVerb::give) return authority_.give(name, now);
  if (verb == ControlVerb::keep) return authority_.keep(name);
  if (verb == ControlVerb::take) return authority_.take(name, now);
  log().warn("{} asks for '{}', which is none of ask, give, keep, take", name,
             printable(request.verb(), 20));
}

/// Leaves the vehicle standing when another takes control, whatever the one before wanted last.
void TeleopReceiverComponent::publish_driver(Time now) {
  if (driver_ && authority_.driver() && authority_.driver() != driver_) {
    if (cmd_vel_.write(topic::CmdVelTeleop::Message{}) == Status::failed)
      log().warn("a velocity was not sent");
  }
  if (authority_.driver() != driver_) {
    log().info("{}", authority_.driver() ? *authority_.driver() + " drives" : "nobody drives");
  }
  driver_ = authority_.driver();
  asked_by_ = authority_.asked_by();
  next_report_ = now + seconds(1);
  topic::DriverState::Message state;
  state.stamp(wall(now));
  state.driver(driver_.value_or(""));
  state.asked_by(asked_by_.value_or(""));
  state.refused(authority_.refused());
  if (state_.write(std::move(state)) == Status::failed) log().warn("the driver was not published");
}

bool TeleopReceiverComponent::is_fresh(const topic::TeleopCmdVel::Message& command, Time now) {
  if (devices_.size() >= most_devices) devices_.clear();
  auto& lateness = devices_.try_emplace(command.header().frame_id(), lifespan_).first->second;
  return lateness.is_fresh(to_ns(command.header().stamp()), to_ns(wall(now)));
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::TeleopReceiverComponent)
