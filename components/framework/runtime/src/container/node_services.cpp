// SPDX-License-Identifier: Apache-2.0
#include "container/node_services.hpp"

#include <algorithm>
#include <array>

#include "graph/node_of_service.hpp"
#include "runtime/middleware/ros_services.hpp"

namespace tocsin {
namespace {

/// Whether one of `names`, as "~/get_parameters", is called of this node.
template <class Names>
bool calls_one_of(const Names& names, const std::string& node,
                  const std::vector<std::string>& called) {
  return std::any_of(called.begin(), called.end(), [&](const std::string& service) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return service == node + name.substr(1); });
  });
}

}  // namespace

bool calls_services_of(const std::string& node, const std::vector<std::string>& called) {
  return std::any_of(called.begin(), called.end(),
                     [&](const std::string& service) { return node_of_service(service) == node; });
}

bool calls_composition_of(const std::string& node, const std::vector<std::string>& called) {
  static const std::array<std::string, 4> names{
      composition_service::LoadNode::name, composition_service::UnloadNode::name,
      composition_service::ListNodes::name, composition_service::SetQos::name};
  return calls_one_of(names, node, called);
}

}  // namespace tocsin
