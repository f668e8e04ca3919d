// SPDX-License-Identifier: Apache-2.0
#include "container/control_component.hpp"
#include "runtime/host_control.hpp"

#include <algorithm>

namespace tocsin {
namespace {

constexpr Duration neighbour_silence = std::chrono::seconds(3);
constexpr Duration settling = std::chrono::seconds(10);  // allocations of the start are no leak
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
  bus().host_control().watch_callers([this] { schedule().input_arrived(); });
}

ControlComponent::~ControlComponent() { bus().host_control().watch_callers({}); }

void ControlComponent::tick(Time now) {
  bool changed = instances_.settle_failures();
  while (const auto state = neighbours_.take()) note_neighbour(*state, now);
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
    bus().host_control().update_graph();
  }
  wake_at(next_report_);
}

Outcome ControlComponent::load(const LoadOrder& order) {
  const std::string twin = twin_of(order.name);
  if (twin.empty()) return instances_.load(order.library, order.name, order.parameters);
  return {false, order.name + ": two nodes of one name; the name is taken in container " + twin};
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
  for (const EndpointHealth& endpoint : bus().host_control().health()) {
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

void ControlComponent::add_refused(diagnostic_msgs::msg::DiagnosticArray& array) {
  if (!computer_.refused_names) return;
  RefusedNames refused = computer_.refused_names();
  if (refused.total() == 0) return;
  array.status().push_back(diagnose(process_.container, refused, refused_before_));
  refused_before_ = std::move(refused);
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
  add_refused(array);
  for (auto& status : array.status()) status.hardware_id(process_.host);
  if (diagnostics_.write(std::move(array)) == Status::failed) log().warn("health was not sent");
}

}  // namespace tocsin
