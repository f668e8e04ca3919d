// SPDX-License-Identifier: Apache-2.0
#include "runtime/component.hpp"

#include <utility>

#include "runtime/middleware/ros_stamp.hpp"
#include "runtime/port.hpp"

namespace tocsin {

Context Context::with_run_dir(std::string folder) const {
  Context other = *this;
  other.run_dir = std::move(folder);
  return other;
}

Context Context::with_request_exit(std::function<void(int)> request) const {
  Context other = *this;
  other.request_exit = std::move(request);
  return other;
}

Context Context::with_computer(const Computer& its_computer) const {
  Context other = *this;
  other.computer = its_computer;
  return other;
}

Context Context::with_seed(std::uint64_t its_seed) const {
  Context other = *this;
  other.seed = its_seed;
  return other;
}

Context Context::with_node(std::string its_node) const {
  Context other = *this;
  other.node = std::move(its_node);
  return other;
}

std::string Context::state_path(const std::string& extension) const {
  if (run_dir.empty() || !computer.get().keeps_files) return {};
  return run_dir + "/" + name + extension;
}

Component::Component(Context& context)
    : context_(context), phase_(phase_of(context.seed, context.name)), log_(context.name, node()) {}

Time Component::next_instant(Duration period, Time now) const {
  return PeriodicInstants{period, phase_}.after(now);
}

void Component::wake_at(Time deadline) {
  schedule_.deadline = std::min(schedule_.deadline, deadline);
}

void Component::wake_on(std::optional<int> descriptor) {
  if (descriptor) schedule_.descriptors.push_back(*descriptor);
}

Devices::Readable Component::when_readable() {
  return [this] { schedule_.input_arrived(); };
}

void Component::forget(std::optional<int> descriptor) {
  auto& all = schedule_.descriptors;
  all.erase(std::remove(all.begin(), all.end(), descriptor), all.end());
}

void Component::add_port(InputPort& port) {
  const std::lock_guard<std::mutex> lock(ports_mutex_);
  ports_.push_back(&port);
}

void Component::remove_port(InputPort& port) {
  const std::lock_guard<std::mutex> lock(ports_mutex_);
  ports_.erase(std::remove(ports_.begin(), ports_.end(), &port), ports_.end());
}

std::vector<PortHealth> Component::port_health() const {
  std::vector<PortHealth> all;
  const std::lock_guard<std::mutex> lock(ports_mutex_);
  for (const InputPort* port : ports_) all.push_back(port->health());
  return all;
}

void Component::listen(bool on) {
  const std::lock_guard<std::mutex> lock(ports_mutex_);
  for (InputPort* port : ports_) port->listen(on);
}

void Component::post(std::function<void()> change) {
  {
    const std::lock_guard<std::mutex> lock(changes_mutex_);
    changes_.push_back(std::move(change));
    has_changes_ = true;
  }
  schedule_.input_arrived();
}

void Component::do_changes() {
  std::vector<std::function<void()>> changes;
  {
    const std::lock_guard<std::mutex> lock(changes_mutex_);
    changes.swap(changes_);
    has_changes_ = false;
  }
  for (const auto& change : changes) change();
}

builtin_interfaces::msg::Time Component::wall(Time now) const {
  return ros_stamp(context_.bus.wall_ns(now));
}

}  // namespace tocsin
