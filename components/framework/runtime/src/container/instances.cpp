// SPDX-License-Identifier: Apache-2.0
#include "container/instances.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "foundation/printable.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {
namespace {

const char* const command = "the command";

/// What `body` threw, empty when nothing.
template <class Body>
std::string error_of(Body body) {
  try {
    body();
    return "";
  } catch (const std::exception& error) {
    return error_line(error.what());
  } catch (...) {
    return "something that is no std::exception";
  }
}

}  // namespace

Instances::Instances(Context home, Ticker& ticker, Find find)
    : home_(std::move(home)), ticker_(ticker), find_(std::move(find)) {}

Instances::~Instances() {
  for (Instance& one : all_) {
    // One that blocks is used by its thread still: it ends with the process.
    if (!quieten(one)) (void)one.component.release();
  }
  while (!all_.empty()) all_.pop_back();
}

Instance& Instances::append(const std::string& library, const std::string& name) {
  Instance& instance = all_.emplace_back();
  instance.id = ++last_id_;
  instance.library = library;
  instance.name = name;
  instance.context = std::make_unique<Context>(home_);
  instance.context->name = name;
  instance.context->node.clear();  // its own, not that of its home
  return instance;
}

Instance* Instances::find(const std::string& name) {
  for (Instance& one : all_) {
    if (one.name == name || std::to_string(one.id) == name) return &one;
  }
  return nullptr;
}

void Instances::construct(Instance& instance) {
  const ComponentEntry& entry = find_(instance.library);
  instance.component = entry.create(*instance.context, *instance.parameters, instance.sources);
  instance.account = std::make_unique<TickAccount>();
  instance.error.clear();
  instance.state = LifecycleState::inactive;
}

void Instances::add(const std::string& library, const std::string& name,
                    std::shared_ptr<const YAML::Node> parameters, const YamlSources& sources) {
  Instance& instance = append(library, name);
  instance.parameters = std::move(parameters);
  instance.sources = sources;
  construct(instance);
}

void Instances::activate_all() {
  for (Instance& one : all_) (void)apply(one, Transition::activate);
}

Outcome Instances::load(const std::string& library, const std::string& name,
                        const std::string& parameters) {
  if (!is_name(name)) {
    return {false, "'" + printable(name) + "' is not a name (" + name_rule + ")"};
  }
  if (find(name) != nullptr) return {false, name + ": two nodes of one name; the name is taken"};
  Instance next;
  const std::string wrong = error_of([&] {
    (void)find_(library);
    next.parameters = std::make_shared<const YAML::Node>(
        parameters.empty() ? YAML::Node(YAML::NodeType::Map)
                           : next.sources.parse(parameters, command));
    find_(library).check(name, *next.parameters, next.sources);
  });
  if (!wrong.empty()) return {false, wrong};
  Instance& instance = append(library, name);
  instance.parameters = next.parameters;
  instance.sources = next.sources;
  Outcome configured = configure(instance);
  if (!configured.done) return configured;
  const Outcome activated = apply(instance, Transition::activate);
  if (!activated.done) return activated;
  return {true, "Loaded component " + std::to_string(instance.id) + " as '" + name + "'"};
}

Outcome Instances::unload(const std::string& name) {
  Instance* const instance = find(name);
  if (instance == nullptr) return {false, name + ": no component of this name is loaded"};
  if (!quieten(*instance)) return {false, name + ": its tick does not end; it cannot be unloaded"};
  const std::string id = std::to_string(instance->id);
  all_.remove_if([&](const Instance& one) { return &one == instance; });
  return {true, "Unloaded component " + id};
}

Outcome Instances::change(const std::string& name, Transition transition) {
  Instance* const instance = find(name);
  if (instance == nullptr) return {false, name + ": no component of this name is loaded"};
  return apply(*instance, transition);
}

std::vector<ParameterFacts> Instances::parameters(const Instance& instance) const {
  std::vector<ParameterFacts> facts;
  (void)error_of([&] {
    facts = find_(instance.library).facts(instance.name, *instance.parameters, instance.sources);
  });
  return facts;
}

/// Why some of these cannot be set, whatever their values; empty: they can.
std::string Instances::refusal(const Instance& instance,
                               const std::vector<rcl_interfaces::msg::Parameter>& given) const {
  const std::vector<ParameterFacts> facts = parameters(instance);
  for (const auto& one : given) {
    const ParameterFacts* const known = find_parameter(facts, one.name());
    const std::string owner = instance.name + "." + printable(one.name()) + ": ";
    if (known == nullptr) return owner + "there is no such parameter";
    if (!known->live && has_value(known->value, one.value())) continue;
    if (!known->live)
      return owner + "is fixed while the component runs; set it in the bringup file";
    const std::string fault = type_fault(known->value, one.value());
    if (!fault.empty()) return owner + fault;
  }
  return "";
}

std::vector<rcl_interfaces::msg::Parameter> Instances::live_of(
    const Instance& instance, const std::vector<rcl_interfaces::msg::Parameter>& given) const {
  const std::vector<ParameterFacts> facts = parameters(instance);
  std::vector<rcl_interfaces::msg::Parameter> live;
  for (const auto& one : given) {
    const ParameterFacts* const known = find_parameter(facts, one.name());
    if (known != nullptr && known->live) live.push_back(one);
  }
  return live;
}

Outcome Instances::set_parameters(std::uint32_t id,
                                  const std::vector<rcl_interfaces::msg::Parameter>& given) {
  const auto found =
      std::find_if(all_.begin(), all_.end(), [&](const Instance& one) { return one.id == id; });
  if (found == all_.end()) return {false, "the component is gone"};
  const std::string refused = refusal(*found, given);
  if (!refused.empty()) return {false, refused};
  YAML::Node merged = YAML::Clone(*found->parameters);
  const std::string wrong = error_of([&] {
    for (const auto& one : live_of(*found, given)) {
      merged[one.name()] = yaml_of(one.value()).value();
    }
    const ComponentEntry& entry = find_(found->library);
    entry.check(found->name, merged, found->sources);
    if (found->component) entry.change(*found->component, merged, found->sources);
  });
  if (!wrong.empty()) return {false, wrong};
  found->parameters = std::make_shared<const YAML::Node>(merged);
  return {true, ""};
}

Outcome Instances::apply(Instance& instance, Transition transition) {
  const auto next = after(instance.state, transition);
  if (!next) {
    return {false, instance.name + ": " + to_text(transition) + " is not allowed from the state " +
                       to_text(instance.state)};
  }
  if (transition == Transition::configure) return configure(instance);
  if (transition == Transition::activate) {
    instance.component->listen(true);
    ticker_.add(*instance.component, *instance.account);
  } else if (!quieten(instance)) {
    return {false, instance.name + ": its tick does not end"};
  }
  if (transition == Transition::cleanup || transition == Transition::shutdown) {
    instance.component.reset();
    instance.error.clear();
  }
  instance.state = *next;
  return {true, "Transitioning successful"};
}

Outcome Instances::configure(Instance& instance) {
  const std::string error = error_of([&] { construct(instance); });
  if (error.empty()) {
    instance.component->listen(false);
    return {true, "Transitioning successful"};
  }
  instance.state = LifecycleState::error;
  instance.error = error;
  return {false, instance.name + ": threw: " + error};
}

/// No ticks from now on, and nothing arrives.
bool Instances::quieten(Instance& instance) {
  if (!instance.component) return true;
  const bool ticked = instance.state == LifecycleState::active;
  if (ticked && !ticker_.remove(*instance.component)) return false;
  instance.component->listen(false);
  return true;
}

bool Instances::settle_failures() {
  bool any = false;
  for (Instance& one : all_) {
    if (one.state != LifecycleState::active || !one.account->failed()) continue;
    one.error = one.account->read().error.value_or("");
    (void)quieten(one);
    one.state = LifecycleState::error;
    any = true;
  }
  return any;
}

}  // namespace tocsin
