// SPDX-License-Identifier: Apache-2.0
#include "velocity_mux/velocity_mux_component.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "foundation/error.hpp"
#include "idl_support/topic_registry.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {

VelocityMuxComponent::VelocityMuxComponent(Context& context, const Params& params)
    : Component(context), mux_(parse_inputs(params.inputs)) {
  make_sources();
  report_inputs();
}

void VelocityMuxComponent::tick(Time now) {
  if (emergency_stop_.take(now)) mux_.on_emergency_stop(emergency_stop_.stands());
  take_list();
  take_commands(now);
  if (mux_.on_time(now)) send(std::make_shared<const topic::CmdVelSelected::Message>());
  report_active();
  wake_at(std::min(mux_.next_deadline(), emergency_stop_.deadline()));
}

/// Ports for new inputs; those of inputs that are gone go, the others keep what waits in them.
void VelocityMuxComponent::make_sources() {
  std::vector<Source> sources;
  for (const MuxInput& input : mux_.inputs()) {
    const auto kept = std::find_if(sources_.begin(), sources_.end(), [&](const Source& source) {
      return source.port && source.name == input.name;
    });
    if (kept != sources_.end()) {
      sources.push_back(std::move(*kept));
      continue;
    }
    const TopicInfo info =
        make_topic_info("cmd_vel/" + input.name, topic::CmdVel::info.qos, Scope::host);
    const Endpoint end{info, &type_info<topic::CmdVel::Message>(), Writers::optional};
    sources.push_back({input.name, std::make_unique<InputPort>(*this, end)});
  }
  sources_ = std::move(sources);
}

void VelocityMuxComponent::take_list() {
  const auto text = set_inputs_.take_latest();
  if (!text) return;
  try {
    mux_.set_inputs(parse_inputs(text->data()));
    make_sources();
    log().info("inputs are now: {}", text->data());
  } catch (const ConfigError& wrong) {  // the list in force is said again below
    log().warn("inputs stay as they are: {}", wrong.what());
  }
  report_inputs();
}

void VelocityMuxComponent::take_commands(Time now) {
  for (const Source& source : sources_) {
    while (const auto sample = source.port->take_sample()) {
      const auto wanted = std::static_pointer_cast<const topic::CmdVel::Message>(sample->message);
      const geometry::Twist velocity{wanted->linear().x(), wanted->angular().z()};
      if (mux_.on_command(source.name, velocity, now)) send(wanted);
    }
  }
}

void VelocityMuxComponent::send(
    const std::shared_ptr<const topic::CmdVelSelected::Message>& velocity) {
  if (selected_.write(velocity) == Status::failed) log().warn("a velocity was not sent");
}

void VelocityMuxComponent::report_active() {
  if (mux_.active() == reported_) return;
  topic::MuxActive::Message message;
  message.data(mux_.active());
  if (active_.write(std::move(message)) != Status::failed) reported_ = mux_.active();
}

void VelocityMuxComponent::report_inputs() {
  topic::MuxInputs::Message message;
  message.data(to_text(mux_.inputs()));
  if (inputs_.write(std::move(message)) == Status::failed) log().warn("the inputs were not told");
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::VelocityMuxComponent)
