// SPDX-License-Identifier: Apache-2.0
#include "container/container.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/free_space.hpp"
#include "graph/ros_graph.hpp"
#include "runtime/middleware/component_library.hpp"
#include "runtime/middleware/container_states.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/middleware/refused_names.hpp"
#include "watch/dropped_packets.hpp"
#include "watch/resident_memory.hpp"

namespace tocsin {
namespace {

BusOptions bus_options(const deployment::Deployment& whole, const deployment::Host& host_of_all,
                       const deployment::Container& container) {
  const auto deployment = part_of(whole, vehicle_of(whole, host_of_all, container));
  const deployment::Host& host = *find_host(deployment, host_of_all.name);
  BusOptions options{host.name + "_" + container.name,
                     host.role,
                     namespace_of(deployment, host, container),
                     deployment.qos,
                     deployment.traffic,
                     host.local_domain,
                     deployment.link_domain,
                     host.address,
                     host.peers,
                     host.name,
                     gid_size_of_environment(),
                     enclave_of(deployment, host)};
  if (host.second) {
    options.second_address = host.second->address;
    options.second_peers = host.second->peers;
  }
  options.routed_namespace = routed_namespace_of(deployment, container);
  options.vehicle = container.vehicle;
  options.peer_names = peer_names_of(deployment, host, container);
  options.sites = host.sites;
  options.chain = drives_a_vehicle(deployment) ? VehicleChain::ours : VehicleChain::foreign;
  return options;
}

WatchLimits watch_limits(const deployment::HealthLimits& health) {
  return {seconds(health.stuck_s), static_cast<std::uint64_t>(health.memory_mib * mib)};
}

/// Without a lock, an allocator or a destructor that the thread which stands still could hold.
void tell_and_end(const WatchFinding& finding) {
  std::fprintf(stderr, "watchdog: %s%s\n", finding.text.c_str(),
               finding.is_final ? "; ends, to be started again" : "");
  if (finding.is_final) _exit(start_me_again);
}

}  // namespace

Container::Container(const deployment::Deployment& deployment, const deployment::Host& host,
                     const deployment::Container& container, std::function<void(int)> request_exit)
    : bus_(make_fast_dds_bus(bus_options(deployment, host, container))),
      context_(Context(*bus_, "control", host.role)
                   .with_run_dir(run_dir_of(deployment, host, container))
                   .with_request_exit(std::move(request_exit))
                   .with_seed(process_seed(deployment.seed, host.name, container.name))
                   .with_node(container_node(container.name))),
      watch_(watch_limits(container.health), tell_and_end) {
  const auto notice_failure = [this] { control_->schedule().input_arrived(); };
  threads_ = std::make_unique<RunnerThreads>(*bus_, notice_failure);
  instances_ = std::make_unique<Instances>(context_, *threads_, load_component);
  control_ = std::make_unique<ControlComponent>(
      context_, container.health,
      ProcessName{host.name, container.name, static_cast<int>(getpid()),
                  container.parameter_services},
      *instances_,
      ControlComponent::Computer{resident_bytes, free_bytes, dropped_packets,
                                 [this] { return watch_.finding(); }, refused_names});
  for (const deployment::ComponentInstance& one : container.components) {
    instances_->add(one.component, one.name, one.parameters, deployment.sources);
  }
}

Container::~Container() {
  control_runner_.reset();
  instances_.reset();
  threads_.reset();
}

void Container::start() {
  instances_->activate_all();
  control_runner_ = std::make_unique<Runner>(control_->name(), *bus_, *control_, control_account_);
}

}  // namespace tocsin
