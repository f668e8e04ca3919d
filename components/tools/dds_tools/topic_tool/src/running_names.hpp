// SPDX-License-Identifier: Apache-2.0
// What a command says about a name that the running system has not.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "runtime/middleware/service_caller.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {

/// "; did you mean '/uxv/odom'?" with those of `names` that are like `given`, as a whole, or in
/// their last word where `given` has one word. Empty when there are none.
[[nodiscard]] std::string suggested_names(const std::vector<std::string>& names,
                                          const std::string& given);

/// Paths of the nodes that were heard so far.
[[nodiscard]] std::vector<std::string> node_paths(const HostGraph& graph);

template <class Value>
std::vector<std::string> keys_of(const std::map<std::string, Value>& map) {
  std::vector<std::string> keys;
  for (const auto& one : map) keys.push_back(one.first);
  return keys;
}

/// Calls a service of `node`, "/uxv/talker". Where nobody answers and there is no such node, the
/// EnvironmentError names those that are like it.
template <class Service>
std::shared_ptr<const typename Service::Response> call_node(HostGraph& graph,
                                                            const std::string& node,
                                                            typename Service::Request request,
                                                            Duration patience) {
  try {
    return call_service<Service>(graph, node, std::move(request), patience);
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(error.what() + suggested_names(node_paths(graph), node));
  }
}

}  // namespace tocsin::topic_tool
