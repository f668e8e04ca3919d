// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "container/composition_services.hpp"
#include "container/lifecycle_services.hpp"
#include "container/logger_services.hpp"
#include "container/parameter_services.hpp"
#include "container/type_description_service.hpp"

namespace tocsin {

/// The services that a node of ROS 2 has, of one component.
struct NodeServices {
  NodeServices(Component& owner, const std::string& node, LifecycleState state)
      : parameters(owner, node),
        loggers(owner, node),
        lifecycle(owner, node, state),
        types(owner, node) {}
  ParameterServices parameters;
  LoggerServices loggers;
  LifecycleServices lifecycle;
  TypeDescriptionService types;
};

/// Those of the container's own node: ROS 2's tools wait for the parameters of every node.
struct ContainerServices {
  ContainerServices(Component& owner, Instances& instances)
      : composition(owner, instances),
        parameters(owner, owner.node()),
        loggers(owner, owner.node()),
        types(owner, owner.node()) {}
  CompositionServices composition;
  ParameterServices parameters;  ///< there are none
  LoggerServices loggers;
  TypeDescriptionService types;
};

/// Whether a client calls one of them: `called` are names of services, without slash in front.
[[nodiscard]] bool calls_services_of(const std::string& node,
                                     const std::vector<std::string>& called);
/// The same for the services by which a container takes nodes in, of the container's node.
[[nodiscard]] bool calls_composition_of(const std::string& node,
                                        const std::vector<std::string>& called);

}  // namespace tocsin
