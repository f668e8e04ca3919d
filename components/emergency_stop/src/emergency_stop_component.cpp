// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop/emergency_stop_component.hpp"

#include <utility>

#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr Duration retry = std::chrono::milliseconds(100);

std::string memory_path(const Context& context) {
  const bool nowhere = context.run_dir.empty() || context.devices != nullptr;
  return nowhere ? "" : context.run_dir + "/" + context.name + ".request";
}

}  // namespace

EmergencyStopComponent::EmergencyStopComponent(Context& context, const Params&)
    : Component(context), file_(memory_path(context)), wanted_(file_.load()) {}

void EmergencyStopComponent::tick(Time now) {
  while (const auto request = request_.take()) {
    if (wanted_ == request->data()) continue;
    wanted_ = request->data();
    log().warn("emergency stop {}", *wanted_ ? "ON" : "off");
    if (!file_.save(*wanted_)) log().warn("the request could not be saved for a restart");
  }
  if (wanted_ == sent_) return;
  topic::EmergencyStop::Message message;
  message.data(*wanted_);
  if (stop_.write(std::move(message)) == Status::failed) return wake_at(now + retry);
  sent_ = wanted_;
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::EmergencyStopComponent)
