// SPDX-License-Identifier: Apache-2.0
#include "container.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <utility>

#include "foundation/error.hpp"
#include "runtime/fast_dds_bus.hpp"
#include "runtime/middleware/component_library.hpp"

namespace tocsin {
namespace {

constexpr Duration interface_timeout = std::chrono::seconds(30);

/// The larger number of containers of the hosts.
int processes_of(const deployment::Deployment& deployment) {
  std::size_t most = 1;
  for (const deployment::Host& host : deployment.hosts) {
    most = std::max(most, host.containers.size());
  }
  return static_cast<int>(most);
}

BusOptions bus_options(const deployment::Deployment& deployment, const deployment::Host& host,
                       const deployment::Container& container) {
  return {host.name + "_" + container.name,
          host.role,
          deployment.ros_namespace,
          deployment.qos,
          deployment.traffic,
          host.local_domain,
          deployment.link_domain,
          host.address,
          host.peers,
          processes_of(deployment)};
}

}  // namespace

Container::Container(const deployment::Deployment& deployment, const deployment::Host& host,
                     const deployment::Container& container, std::function<void(int)> request_exit)
    : deployment_(deployment), host_(host), request_exit_(std::move(request_exit)) {
  if (!host.address.empty() && !wait_for_interface(host.address, interface_timeout)) {
    throw EnvironmentError(host.name + ".address: no interface with " + host.address +
                           " came up within 30 s");
  }
  bus_ = make_fast_dds_bus(bus_options(deployment, host, container));
  for (const deployment::ComponentInstance& one : container.components) {
    const ComponentEntry& entry = load_component(one.component);
    Instance& instance = add_instance(one.name);
    instance.component = entry.create(*instance.context, *one.parameters, deployment.file);
  }
  Instance& gate = add_instance("gate");
  gate.component =
      std::make_unique<GateComponent>(*gate.context, GateComponent::Params{}, container.name);
}

Container::Instance& Container::add_instance(const std::string& name) {
  Instance& instance = instances_.emplace_back();
  instance.context = std::make_unique<Context>(
      Context{*bus_, name, host_.role, deployment_.run_dir, request_exit_});
  return instance;
}

Container::~Container() {
  for (Instance& instance : instances_) instance.runner.reset();
  while (!instances_.empty()) instances_.pop_back();
}

void Container::start() {
  for (Instance& instance : instances_) {
    instance.runner = std::make_unique<Runner>(instance.context->name, *bus_);
    instance.runner->add(*instance.component, instance.account);
  }
  for (Instance& instance : instances_) instance.runner->start();
}

}  // namespace tocsin
