// SPDX-License-Identifier: Apache-2.0
#include "velocity_smoother/velocity_smoother_component.hpp"

#include <utility>

#include "runtime/component_entry.hpp"

namespace tocsin {

VelocitySmootherComponent::VelocitySmootherComponent(Context& context, const Params& params)
    : Component(context), smoother_(params.limits) {
  if (params.checked) {
    checked_.emplace(*this);
  } else {
    selected_.emplace(*this);
  }
}

template <class Topic>
void VelocitySmootherComponent::take_from(std::optional<Input<Topic>>& input, Time now) {
  if (!input) return;
  while (const auto wanted = input->take()) {
    smoother_.on_command({wanted->linear().x(), wanted->angular().z()}, now);
  }
}

void VelocitySmootherComponent::tick(Time now) {
  take_from(selected_, now);
  take_from(checked_, now);
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
