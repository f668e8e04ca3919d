// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "container/lifecycle_services.hpp"
#include "container/logger_services.hpp"
#include "container/parameter_services.hpp"

namespace tocsin {

/// The services that a node of ROS 2 has, of one component.
struct NodeServices {
  NodeServices(Component& owner, const std::string& node, LifecycleState state)
      : parameters(owner, node), loggers(owner, node), lifecycle(owner, node, state) {}
  ParameterServices parameters;
  LoggerServices loggers;
  LifecycleServices lifecycle;
};

/// Whether a client calls one of them: `called` are names of services, without slash in front.
[[nodiscard]] bool calls_services_of(const std::string& node,
                                     const std::vector<std::string>& called);
/// The same for the services by which a container takes nodes in, of the container's node.
[[nodiscard]] bool calls_composition_of(const std::string& node,
                                        const std::vector<std::string>& called);

}  // namespace tocsin
