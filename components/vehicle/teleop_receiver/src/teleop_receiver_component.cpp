// SPDX-License-Identifier: Apache-2.0
#include "teleop_receiver/teleop_receiver_component.hpp"

#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr std::size_t most_devices = 16;  // of a peer that invents names

std::int64_t to_ns(const builtin_interfaces::msg::Time& stamp) {
  return std::int64_t{stamp.sec()} * 1'000'000'000 + stamp.nanosec();
}

}  // namespace

void TeleopReceiverComponent::tick(Time now) {
  while (const auto command = command_.take()) {
    const bool fresh = is_fresh(*command, now);
    if (!fresh && !was_late_) log().warn("velocities from the operator come too late");
    was_late_ = !fresh;
    if (fresh && cmd_vel_.write(command->twist()) == Status::failed) {
      log().warn("a velocity was not sent");
    }
  }
}

bool TeleopReceiverComponent::is_fresh(const topic::TeleopCmdVel::Message& command, Time now) {
  if (devices_.size() >= most_devices) devices_.clear();
  auto& lateness = devices_.try_emplace(command.header().frame_id(), lifespan_).first->second;
  return lateness.is_fresh(to_ns(command.header().stamp()), to_ns(wall(now)));
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::TeleopReceiverComponent)
