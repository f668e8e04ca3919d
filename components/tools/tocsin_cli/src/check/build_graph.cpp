// SPDX-License-Identifier: Apache-2.0
#include "build_graph.hpp"

#include <exception>

#include "port_recorder.hpp"
#include "runtime/middleware/component_library.hpp"

namespace tocsin::check {
namespace {

/// Builds what `make` builds and returns its ports; a refusal becomes a finding.
template <class Make>
void probe(Node node, const deployment::Deployment& deployment, BuiltGraph& built, Make make) {
  PortRecorder recorder;
  Computer silent;  // opens no port, sends no packet
  silent.devices = Devices(Devices::Unknown::silent);
  Context context = Context(recorder, node.name, node.role)
                        .with_run_dir(deployment.run_dir)
                        .with_computer(silent);
  try {
    const auto component = make(context);
    node.ports = recorder.ports();
    built.graph.push_back(std::move(node));
  } catch (const std::exception& error) {
    built.findings.push_back({Severity::error, node.path() + ": " + error.what()});
  }
}

void probe_container(const deployment::Deployment& deployment, const deployment::Host& host,
                     const deployment::Container& container, BuiltGraph& built) {
  for (const deployment::ComponentInstance& instance : container.components) {
    probe({host.name, host.role, container.name, instance.name, {}}, deployment, built,
          [&](Context& context) {
            return load_component(instance.component)
                .create(context, *instance.parameters, deployment.sources);
          });
  }
}

}  // namespace

BuiltGraph build_graph(const deployment::Deployment& deployment) {
  BuiltGraph built;
  for (const deployment::Host& host : deployment.hosts) {
    for (const deployment::Container& container : host.containers) {
      probe_container(deployment, host, container, built);
    }
  }
  return built;
}

}  // namespace tocsin::check
