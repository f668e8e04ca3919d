// SPDX-License-Identifier: Apache-2.0
#include "container/served_nodes.hpp"

#include <utility>

#include "runtime/host_control.hpp"
#include "runtime/middleware/ros_stamp.hpp"

namespace tocsin {
namespace {

constexpr Duration unasked = std::chrono::seconds(10);  // a command of a person comes again

}  // namespace

ServedNodes::ServedNodes(Component& owner, Instances& instances, Mode mode)
    : owner_(owner),
      instances_(instances),
      mode_(mode),
      log_(owner.name(), owner.node()),
      rosout_(owner) {}

bool ServedNodes::is_asked(bool called, const Callers& callers) const {
  if (mode_ != Mode::on_demand) return mode_ == Mode::always;
  return callers.ros2 || called;
}

void ServedNodes::note_callers(Time now) {
  const Callers callers = owner_.bus().host_control().callers();
  for (const Instance& instance : instances_.all()) {
    if (!is_asked(calls_services_of(instance.name, callers.services), callers)) continue;
    Served& served = served_[instance.id];
    served.asked = now;
    if (served.services) continue;
    served.services = std::make_unique<NodeServices>(owner_, instance.name, instance.state);
    served.events =
        owner_.bus().advertise({ParameterEvents::info, &type_info<ParameterEvents::Message>(),
                                Writers::needed, "", instance.name});
  }
  for (auto it = served_.begin(); it != served_.end();) {
    const bool over = now - it->second.asked > unasked || !instances_.has(it->first);
    it = over ? served_.erase(it) : std::next(it);
  }
  const bool container_is_called = calls_composition_of(owner_.node(), callers.services) ||
                                   calls_services_of(owner_.node(), callers.services);
  if (is_asked(container_is_called, callers)) {
    container_.asked = now;
    if (!container_.services) {
      container_.services = std::make_unique<ContainerServices>(owner_, instances_);
    }
  } else if (now - container_.asked > unasked) {
    container_.services.reset();
  }
}

bool ServedNodes::serve(const CompositionServices::Load& load, Time now) {
  const std::size_t before = served_.size();
  const bool had_container = container_.services != nullptr;
  note_callers(now);
  for (const Instance& instance : instances_.all()) {
    const auto served = served_.find(instance.id);
    if (served == served_.end()) continue;
    NodeServices& services = *served->second.services;
    services.parameters.answer(parameters_of(instance, now));
    services.loggers.answer([this](const std::string& name) { return has_logger(name); });
    services.lifecycle.answer(lifecycle_of(instance));
    services.types.answer();
  }
  if (container_.services && serve_container(load)) changed_ = true;
  const bool ends = served_.size() != before || had_container != (container_.services != nullptr);
  return std::exchange(changed_, false) || ends;
}

bool ServedNodes::has_logger(const std::string& name) const {
  return nodes_.count(name) != 0 || name == owner_.node();
}

/// True when that has changed what the process has.
bool ServedNodes::serve_container(const CompositionServices::Load& load) {
  static const ParameterSource none{
      [] { return std::vector<ParameterFacts>(); },
      [](const auto& given) {
        return Outcome{given.empty(), "a container has no parameters"};
      }};
  container_.services->parameters.answer(none);
  container_.services->loggers.answer([this](const std::string& name) { return has_logger(name); });
  container_.services->types.answer();
  return container_.services->composition.answer(load);
}

void ServedNodes::tell_log() {
  std::set<std::string> nodes;
  for (const Instance& instance : instances_.all()) nodes.insert(instance.name);
  if (nodes != nodes_) rosout_.serve(nodes);
  nodes_ = std::move(nodes);
  rosout_.tell();
}

ParameterSource ServedNodes::parameters_of(const Instance& instance, Time now) {
  return {[this, &instance] { return instances_.parameters(instance); },
          [this, &instance, now](const auto& given) {
            const Outcome outcome = instances_.set_parameters(instance.id, given);
            if (outcome.done) tell_change(instance, instances_.live_of(instance, given), now);
            return outcome;
          }};
}

LifecycleSource ServedNodes::lifecycle_of(const Instance& instance) {
  return {[&instance] { return instance.state; },
          [this, &instance](Transition transition) {
            Outcome outcome = instances_.change(instance.name, transition);
            if (!outcome.done) log_.warn("{}: {}", to_text(transition), outcome.text);
            changed_ = true;
            return outcome;
          }};
}

void ServedNodes::tell_change(const Instance& instance,
                              const std::vector<rcl_interfaces::msg::Parameter>& changed,
                              Time now) {
  if (changed.empty()) return;
  const std::string& home = owner_.bus().host_control().ros_namespace();
  rcl_interfaces::msg::ParameterEvent event;
  event.stamp(ros_stamp(owner_.bus().wall_ns(now)));
  event.node((home.empty() ? "/" : "/" + home + "/") + instance.name);
  event.changed_parameters(changed);
  for (const auto& one : changed) log_.info("{}: parameter {} set", instance.name, one.name());
  auto& events = *served_.at(instance.id).events;
  const auto told = std::make_shared<const ParameterEvents::Message>(std::move(event));
  if (events.write(told) == Status::failed) log_.warn("a change was not told");
}

}  // namespace tocsin
