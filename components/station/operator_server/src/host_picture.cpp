// SPDX-License-Identifier: Apache-2.0
#include "operator_server/host_picture.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "bag/topic.hpp"
#include "foundation/ends_with.hpp"
#include "foundation/ros_names.hpp"
#include "idl_support/topic_registry.hpp"
#include "idl_support/type_definition.hpp"
#include "idl_support/type_registry.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin::foxglove {
namespace {

/// A profile that asks for no more than these writers offer.
const char* modest_qos(const std::vector<const GraphEnd*>& writers) {
  const RawTopic topic = readable(writers);
  if (topic.transient_local) return "state";
  return topic.reliable ? "event" : "sensor";
}

/// Whether who comes late gets the last sample, by the built-in profile of that name.
bool keeps_last(const TopicInfo& topic) {
  static const QosProfiles profiles;
  const auto found = profiles.all().find(topic.qos);
  return found != profiles.all().end() && found->second.keeps_last() &&
         topic.requests == Requests::profile;
}

std::vector<SeenTopic> topics_of(const std::vector<GraphEnd>& ends,
                                 const std::string& ros_namespace) {
  std::map<std::string, std::vector<const GraphEnd*>> writers;
  for (const GraphEnd& end : ends) {
    if (const auto name = ros_topic(end.topic); name && end.writer) writers[*name].push_back(&end);
  }
  std::vector<SeenTopic> topics;
  for (const auto& [name, all] : writers) {
    const TypeInfo* const type = find_type(all.front()->type);
    if (type == nullptr) continue;
    const TopicInfo info = bus_topic(name, *type, modest_qos(all), ros_namespace);
    topics.push_back({name, info, type, keeps_last(info)});
  }
  return topics;
}

/// `std_srvs::srv::dds_::Trigger_Response_` of `..._Request_`.
const TypeInfo* response_type(const std::string& request) {
  const std::string end = "_Request_";
  if (!ends_with(request, end)) return nullptr;
  return find_type(request.substr(0, request.size() - end.size()) + "_Response_");
}

std::vector<SeenService> services_of(const std::vector<GraphEnd>& ends) {
  std::map<std::string, SeenService> services;
  for (const GraphEnd& end : ends) {
    const auto service = ros_service(end.topic);
    if (!service || service->half != ServiceHalf::request || end.writer) continue;
    const TypeInfo* const request = find_type(end.type);
    const TypeInfo* const response = response_type(end.type);
    if (request == nullptr || response == nullptr) continue;
    services[service->name] = {service->name, ros_service_type(end.type), request, response};
  }
  std::vector<SeenService> all;
  for (auto& entry : services) all.push_back(std::move(entry.second));
  return all;
}

/// Who has each end: its node, else its participant.
std::map<Gid, std::string> owners_of(const std::vector<GraphNode>& nodes) {
  std::map<Gid, std::string> owners;
  for (const GraphNode& node : nodes) {
    for (const Gid& gid : node.readers) owners[gid] = node.path();
    for (const Gid& gid : node.writers) owners[gid] = node.path();
  }
  return owners;
}

Graph graph_of(const std::vector<GraphEnd>& ends, const std::vector<GraphNode>& nodes) {
  const auto owners = owners_of(nodes);
  Graph graph;
  for (const GraphEnd& end : ends) {
    const auto owner = owners.find(end.gid);
    const std::string& who = owner == owners.end() ? end.participant : owner->second;
    if (const auto topic = ros_topic(end.topic)) {
      (end.writer ? graph.publishers : graph.subscribers)[*topic].insert(who);
    }
    const auto service = ros_service(end.topic);
    if (service && service->half == ServiceHalf::request && !end.writer) {
      graph.servers[service->name].insert(who);
    }
  }
  return graph;
}

Schema schema_of(const TypeInfo& type) {
  const bag::Topic topic = bag::make_topic("", type.name);
  return {topic.type, topic.definition_encoding, topic.definition};
}

std::string full_name(const std::string& name, const std::string& ros_namespace) {
  if (name.front() == '/') return name;
  return ros_namespace.empty() ? "/" + name : "/" + ros_namespace + "/" + name;
}

}  // namespace

std::string bus_name(const std::string& name, const std::string& ros_namespace) {
  const std::string home = ros_namespace.empty() ? "/" : "/" + ros_namespace + "/";
  return name.compare(0, home.size(), home) == 0 ? name.substr(home.size()) : name;
}

std::string writable_in(const std::string& ros_namespace, const std::string& topic) {
  return ros_namespace.empty() ? topic : "/" + ros_namespace + topic;
}

TopicInfo bus_topic(const std::string& name, const TypeInfo& type, const char* qos,
                    const std::string& ros_namespace) {
  const std::string known_as = bus_name(name, ros_namespace);
  for (const KnownTopic& known : known_topics()) {
    if (known.info.name == known_as && known.type == &type) return known.info;
  }
  return make_topic_info(known_as, qos, Scope::host);
}

HostPicture picture_of(const std::vector<GraphEnd>& ends, const std::vector<GraphNode>& nodes,
                       const std::string& ros_namespace) {
  return {topics_of(ends, ros_namespace), services_of(ends), graph_of(ends, nodes)};
}

HostPicture stated_picture(const std::string& ros_namespace) {
  HostPicture picture;
  for (const KnownTopic& known : known_topics()) {
    picture.topics.push_back({full_name(known.info.name, ros_namespace), known.info, known.type,
                              keeps_last(known.info)});
  }
  return picture;
}

Channel channel_of(const SeenTopic& topic) {
  return {topic.name, schema_of(*topic.type), topic.latched};
}

Service service_of(const SeenService& service) {
  return {service.name, service.type, schema_of(*service.request), schema_of(*service.response)};
}

}  // namespace tocsin::foxglove
