// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin {

/// The node whose own service this is: `navigator` of `navigator/get_parameters`. Empty when it is
/// none of the services that every node of ROS 2 has: parameters, loggers, life cycle. Pure.
[[nodiscard]] std::string node_of_service(const std::string& service);

}  // namespace tocsin
