// SPDX-License-Identifier: Apache-2.0
#include "velocity_smoother/velocity_smoother_component.hpp"

#include <utility>

#include "runtime/component_entry.hpp"

namespace tocsin {

void VelocitySmootherComponent::tick(Time now) {
  while (const auto wanted = wanted_.take()) {
    smoother_.on_command({wanted->linear().x(), wanted->angular().z()}, now);
  }
  if (const auto velocity = smoother_.update(now)) {
    topic::CmdVelSmoothed::Message message;
    message.linear().x(velocity->linear_mps);
    message.angular().z(velocity->angular_rad_s);
    if (smoothed_.write(std::move(message)) == Status::failed) log().warn("a velocity was lost");
  }
  wake_at(smoother_.next_deadline(now));
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::VelocitySmootherComponent)
