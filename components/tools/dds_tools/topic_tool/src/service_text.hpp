// SPDX-License-Identifier: Apache-2.0
// What `ros2 service` prints, from who is on a host's domain.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "idl_support/type_info.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin::topic_tool {

struct ServiceListOptions {
  bool types = false;   ///< -t: each with its types
  bool count = false;   ///< -c: how many there are
  bool hidden = false;  ///< --include-hidden-services: those with a part that begins with _, too
};

/// The services that somebody serves or calls, with their ROS types.
[[nodiscard]] std::map<std::string, std::set<std::string>> services_in(
    const std::vector<GraphEnd>& ends);

/// Services by name; a line each.
[[nodiscard]] std::string service_list_text(const std::vector<GraphEnd>& ends,
                                            const ServiceListOptions& options);

/// A message as Python shows it, which `ros2 service call` prints:
/// `std_srvs.srv.SetBool_Request(data=True)`. A message in it stands without its type's name.
[[nodiscard]] std::string python_text(const TypeInfo& type, const void* message);

}  // namespace tocsin::topic_tool
