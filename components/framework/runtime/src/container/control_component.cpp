// SPDX-License-Identifier: Apache-2.0
#include "container/control_component.hpp"

#include <algorithm>

#include "foundation/error.hpp"
#include "runtime/middleware/qos_change.hpp"

namespace tocsin {
namespace {

using Command = tocsin_msgs::msg::ContainerCommand;

constexpr Duration neighbour_silence = std::chrono::seconds(3);
constexpr Duration settling = std::chrono::seconds(10);  // allocations of the start are no leak
constexpr std::size_t kept_answers = 8;
constexpr Duration between_drop_lines = std::chrono::minutes(1);  // a flood must not fill the log

}  // namespace

ControlComponent::ControlComponent(Context& context, const HealthLimits& limits,
                                   ProcessName process, Instances& instances, Computer computer)
    : Component(context),
      limits_(limits),
      process_(std::move(process)),
      instances_(instances),
      computer_(std::move(computer)),
      served_(*this, instances, process_.parameter_services) {
  bus().watch_callers([this] { schedule().input_arrived(); });
}

ControlComponent::~ControlComponent() { bus().watch_callers({}); }

void ControlComponent::tick(Time now) {
  bool changed = instances_.settle_failures();
  while (const auto state = neighbours_.take()) note_neighbour(*state, now);
  while (const auto command = command_.take()) {
    if (!command->container().empty() && command->container() != process_.container) continue;
    obey(*command);
    changed = true;
  }
  if (started_ == Time{}) started_ = now;
  if (now >= next_report_) {
    next_report_ = next_instant(seconds(limits_.period_s), now);
    publish_health(now);
    changed = true;
  }
  if (served_.serve([this](const LoadOrder& order) { return load(order); }, now)) changed = true;
  served_.tell_log();
  if (changed) {
    publish_state(now);
    bus().update_graph();
  }
  wake_at(next_report_);
}

void ControlComponent::obey(const Command& command) {
  const auto is_it = [&](const auto& answer) { return answer.id() == command.id(); };
  if (std::any_of(answers_.begin(), answers_.end(), is_it)) return;  // a repetition
  const Outcome outcome = carry_out(command);
  if (!outcome.done) log().warn("{}: {}", command.verb(), outcome.text);
  tocsin_msgs::msg::ContainerAnswer answer;
  answer.id(command.id());
  answer.done(outcome.done);
  answer.text(outcome.text);
  answers_.push_back(std::move(answer));
  if (answers_.size() > kept_answers) answers_.pop_front();
}

Outcome ControlComponent::load(const LoadOrder& order) {
  const std::string twin = twin_of(order.name);
  if (twin.empty()) return instances_.load(order.library, order.name, order.parameters);
  return {false, order.name + ": two nodes of one name; the name is taken in container " + twin};
}

Outcome ControlComponent::carry_out(const Command& command) {
  const std::string& verb = command.verb();
  if (verb == "report") return {true, ""};
  if (verb == "unload") return instances_.unload(command.name());
  if (verb == "load") return load({command.library(), command.name(), command.parameters()});
  if (verb == "set_qos") return set_qos(command);
  const auto transition = to_transition(verb);
  if (!transition) return {false, "'" + verb + "' is not a command"};
  return instances_.change(command.name(), *transition);
}

Outcome ControlComponent::set_qos(const Command& command) {
  QosChange change;
  change.topic = command.name();
  const std::string& ends = command.library();
  change.writers = ends.empty() || ends == "writers";
  change.readers = ends.empty() || ends == "readers";
  change.settings = command.parameters();
  try {
    return {true, std::to_string(bus().change_qos(change))};
  } catch (const ConfigError& error) {
    return {false, error.what()};
  }
}

void ControlComponent::note_neighbour(const tocsin_msgs::msg::ContainerState& state, Time now) {
  const Other other{state.container(), state.pid()};
  if (other == Other{process_.container, process_.pid}) return;
  Heard& heard = heard_[other];
  heard = {now, {}};
  for (const auto& one : state.components()) heard.names.push_back(one.name());
}

std::string ControlComponent::twin_of(const std::string& name) const {
  for (const auto& [other, heard] : heard_) {
    const auto& names = heard.names;
    if (std::find(names.begin(), names.end(), name) == names.end()) continue;
    return other.first + " (process " + std::to_string(other.second) + ")";
  }
  return "";
}

void ControlComponent::publish_state(Time now) {
  tocsin_msgs::msg::ContainerState message;
  message.stamp(wall(now));
  message.host(process_.host);
  message.container(process_.container);
  message.pid(process_.pid);
  for (const Instance& instance : instances_.all()) {
    tocsin_msgs::msg::ComponentState one;
    one.id(instance.id);
    one.library(instance.library);
    one.name(instance.name);
    one.state(to_text(instance.state));
    one.error(instance.error);
    message.components().push_back(std::move(one));
  }
  message.answers().assign(answers_.begin(), answers_.end());
  if (state_.write(std::move(message)) == Status::failed) log().warn("its state was not sent");
}

InstanceHealth ControlComponent::health_of(const Instance& instance, Time now) {
  InstanceHealth health;
  health.name = instance.name;
  health.state = to_text(instance.state);
  health.error = instance.error;
  health.twin = twin_of(instance.name);
  health.now.at = now;
  if (instance.component) {
    health.now.ticks = instance.account->read();
    health.now.overruns = instance.component->schedule().overruns;
    health.now.ports = instance.component->port_health();
  }
  InstanceSums& before = before_[instance.id];
  // A component that was constructed anew counts from zero.
  if (before.ticks.ticks <= health.now.ticks.ticks) health.before = before;
  before = health.now;
  return health;
}

void ControlComponent::add_process(Time now, diagnostic_msgs::msg::DiagnosticArray& array) {
  const std::uint64_t bytes = computer_.resident_bytes();
  const std::string& run_dir = context().run_dir;
  if (now - started_ < settling) first_bytes_ = bytes;
  const auto finding = computer_.finding ? computer_.finding() : std::nullopt;
  array.status().push_back(
      diagnose(process_.container,
               {bytes, first_bytes_, run_dir, computer_.free_bytes(run_dir), finding}, limits_));
  for (const auto& [other, heard] : heard_) {
    if (other.first != process_.container) continue;
    auto& status = array.status().back();
    status.level(diagnostic_msgs::msg::DiagnosticStatus_Constants::ERROR);
    status.message("two containers of one name: also process " + std::to_string(other.second));
  }
}

void ControlComponent::add_endpoints(diagnostic_msgs::msg::DiagnosticArray& array) {
  for (const EndpointHealth& endpoint : bus().health()) {
    if (!is_eventful(endpoint)) continue;
    const std::string key = endpoint.topic + (endpoint.writer ? ">" : "<");
    EndpointHealth& before = endpoints_before_[key];
    array.status().push_back(diagnose(process_.container, endpoint, before));
    before = endpoint;
  }
}

void ControlComponent::add_dropped(Time now, diagnostic_msgs::msg::DiagnosticArray& array) {
  if (!computer_.dropped_packets) return;
  const rtps_filter::DropAccount dropped = computer_.dropped_packets();
  if (dropped.total() == 0) return;
  array.status().push_back(diagnose(process_.container, dropped, dropped_before_));
  const auto& finding = array.status().back();
  const bool more = dropped.total() > dropped_before_.total();
  dropped_before_ = dropped;
  if (!more || now < next_drop_line_) return;
  next_drop_line_ = now + between_drop_lines;
  log().warn("{}", finding.message());
}

void ControlComponent::publish_health(Time now) {
  for (auto it = heard_.begin(); it != heard_.end();) {
    it = now - it->second.at > neighbour_silence ? heard_.erase(it) : std::next(it);
  }
  diagnostic_msgs::msg::DiagnosticArray array;
  array.header().stamp(wall(now));
  add_process(now, array);
  for (const Instance& instance : instances_.all()) {
    array.status().push_back(diagnose(process_.container, health_of(instance, now), limits_));
  }
  add_endpoints(array);
  add_dropped(now, array);
  for (auto& status : array.status()) status.hardware_id(process_.host);
  if (diagnostics_.write(std::move(array)) == Status::failed) log().warn("health was not sent");
}

}  // namespace tocsin
