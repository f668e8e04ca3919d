// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "container/logger_services.hpp"
#include "container/parameter_services.hpp"

namespace tocsin {

/// The services that every node of ROS 2 has, of one component.
struct NodeServices {
  NodeServices(Component& owner, const std::string& node)
      : parameters(owner, node), loggers(owner, node) {}
  ParameterServices parameters;
  LoggerServices loggers;
};

/// Whether a client calls one of them: `called` are names of services, without slash in front.
[[nodiscard]] bool calls_services_of(const std::string& node,
                                     const std::vector<std::string>& called);

}  // namespace tocsin
