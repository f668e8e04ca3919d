// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "operator_server/server_message.hpp"
#include "runtime/bus.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin::foxglove {

/// A topic of the host whose type is known here.
struct SeenTopic {
  std::string name;  ///< with its namespace: `/uxv/odom`
  TopicInfo info;    ///< by which the bus knows it
  const TypeInfo* type;
  bool latched = false;
};
struct SeenService {
  std::string name;  ///< with its namespace
  std::string type;  ///< `std_srvs/srv/Trigger`
  const TypeInfo* request;
  const TypeInfo* response;
};

/// What is on a host's domain now.
struct HostPicture {
  std::vector<SeenTopic> topics;
  std::vector<SeenService> services;
  Graph graph;
};
using LookAtHost = std::function<HostPicture()>;

/// Of the ends and nodes that were heard: topics that somebody writes, and services that somebody
/// serves. What has a type that no installed IDL library has is left out, but for the graph.
[[nodiscard]] HostPicture picture_of(const std::vector<GraphEnd>& ends,
                                     const std::vector<GraphNode>& nodes,
                                     const std::string& ros_namespace);
/// Where nobody can be heard, as on the bus of tests: all topics that the loaded libraries state.
[[nodiscard]] HostPicture stated_picture(const std::string& ros_namespace);

[[nodiscard]] Channel channel_of(const SeenTopic& topic);
[[nodiscard]] Service service_of(const SeenService& service);

/// `odom` of `/uxv/odom` in the namespace `uxv`; an absolute name of what is not in it.
[[nodiscard]] std::string bus_name(const std::string& name, const std::string& ros_namespace);

/// A topic, or a pattern, of the parameter `writable` as clients name it: within the namespace.
[[nodiscard]] std::string writable_in(const std::string& ros_namespace, const std::string& topic);

/// The topic by which the bus knows `name`: as a library states it for this type, else made of what
/// its writers offer (`qos`).
[[nodiscard]] TopicInfo bus_topic(const std::string& name, const TypeInfo& type, const char* qos,
                                  const std::string& ros_namespace);

}  // namespace tocsin::foxglove
