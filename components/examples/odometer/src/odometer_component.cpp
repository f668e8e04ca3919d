// SPDX-License-Identifier: Apache-2.0
#include "odometer/odometer_component.hpp"

#include <utility>

#include "runtime/component_entry.hpp"

namespace example {

OdometerComponent::OdometerComponent(tocsin::Context& context, const Params& params)
    : Component(context), meter_(params.step_m, params.jump_m) {
  wake_every(tocsin::seconds(params.period_s));
}

void OdometerComponent::tick(tocsin::Time now) {
  while (const auto odom = odom_.take()) {
    const auto& position = odom->pose().pose().position();
    meter_.on_position(position.x(), position.y());
  }
  DistanceDriven::Message message;
  message.stamp(wall(now));
  message.driven_m(meter_.driven_m());
  if (distance_.write(std::move(message)) == tocsin::Status::failed) {
    log().warn("the distance was not sent");
  }
}

}  // namespace example

TOCSIN_COMPONENT(example::OdometerComponent)
