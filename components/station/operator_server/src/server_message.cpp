// SPDX-License-Identifier: Apache-2.0
#include "operator_server/server_message.hpp"

#include <utility>

#include "little_endian.hpp"

namespace tocsin::foxglove {
namespace {

using nlohmann::json;

enum Opcode : std::uint8_t { message_data_opcode = 1, time_opcode = 2, response_opcode = 3 };

/// Texts of others may hold bytes that are not UTF-8; those are replaced.
Frame text(const json& message) {
  return {Frame::Kind::text, message.dump(-1, ' ', false, json::error_handler_t::replace)};
}

Frame binary(Opcode opcode) {
  return {Frame::Kind::binary, std::string(1, static_cast<char>(opcode))};
}

/// One direction of a service, as newer clients read it.
json half_of(const Schema& schema) {
  return {{"encoding", "cdr"},
          {"schemaName", schema.name},
          {"schemaEncoding", schema.encoding},
          {"schema", schema.text}};
}

/// The entries of `now` that `before` has not, or with others.
json changed(const Graph::Users& before, const Graph::Users& now, const char* key) {
  json list = json::array();
  for (const auto& [name, users] : now) {
    const auto found = before.find(name);
    if (found == before.end() || found->second != users) {
      list.push_back({{"name", name}, {key, users}});
    }
  }
  return list;
}

void add_removed(const Graph::Users& before, const Graph::Users& now, std::set<std::string>& gone) {
  for (const auto& entry : before) {
    if (now.count(entry.first) == 0) gone.insert(entry.first);
  }
}

}  // namespace

Frame server_info(const ServerFacts& facts) {
  return text({{"op", "serverInfo"},
               {"name", facts.name},
               {"capabilities",
                {"clientPublish", "parameters", "parametersSubscribe", "services",
                 "connectionGraph", "time"}},
               {"supportedEncodings", {"cdr", "json"}},
               {"metadata", facts.metadata},
               {"sessionId", facts.session}});
}

Frame advertise(const std::map<std::uint32_t, Channel>& channels) {
  json list = json::array();
  for (const auto& [id, channel] : channels) {
    list.push_back({{"id", id},
                    {"topic", channel.topic},
                    {"encoding", "cdr"},
                    {"schemaName", channel.schema.name},
                    {"schemaEncoding", channel.schema.encoding},
                    {"schema", channel.schema.text}});
  }
  return text({{"op", "advertise"}, {"channels", list}});
}

Frame unadvertise(const std::vector<std::uint32_t>& channels) {
  return text({{"op", "unadvertise"}, {"channelIds", channels}});
}

Frame advertise_services(const std::map<std::uint32_t, Service>& services) {
  json list = json::array();
  for (const auto& [id, service] : services) {
    list.push_back({{"id", id},
                    {"name", service.name},
                    {"type", service.type},
                    {"request", half_of(service.request)},
                    {"response", half_of(service.response)},
                    {"requestSchema", service.request.text},  // as older clients read it
                    {"responseSchema", service.response.text}});
  }
  return text({{"op", "advertiseServices"}, {"services", list}});
}

Frame unadvertise_services(const std::vector<std::uint32_t>& services) {
  return text({{"op", "unadvertiseServices"}, {"serviceIds", services}});
}

Frame status(Level level, const std::string& message, const std::string& id) {
  json object{{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}};
  if (!id.empty()) object["id"] = id;
  return text(object);
}

Frame remove_status(const std::string& id) {
  return text({{"op", "removeStatus"}, {"statusIds", {id}}});
}

Frame parameter_values(const std::vector<Parameter>& parameters,
                       const std::optional<std::string>& id) {
  json list = json::array();
  for (const Parameter& parameter : parameters) {
    json one{{"name", parameter.name}};
    if (!parameter.value.is_null()) one["value"] = parameter.value;
    if (!parameter.type.empty()) one["type"] = parameter.type;
    list.push_back(one);
  }
  json object{{"op", "parameterValues"}, {"parameters", list}};
  if (id) object["id"] = *id;
  return text(object);
}

Frame graph_update(const Graph& before, const Graph& now) {
  std::set<std::string> topics;
  add_removed(before.publishers, now.publishers, topics);
  add_removed(before.subscribers, now.subscribers, topics);
  std::set<std::string> services;
  add_removed(before.servers, now.servers, services);
  json published = changed(before.publishers, now.publishers, "publisherIds");
  json subscribed = changed(before.subscribers, now.subscribers, "subscriberIds");
  // A topic that lost all of one kind only is not gone: it has an empty list of them.
  for (auto topic = topics.begin(); topic != topics.end();) {
    const bool still = now.publishers.count(*topic) != 0 || now.subscribers.count(*topic) != 0;
    if (!still) {
      ++topic;
      continue;
    }
    if (now.publishers.count(*topic) == 0) {
      published.push_back({{"name", *topic}, {"publisherIds", json::array()}});
    } else {
      subscribed.push_back({{"name", *topic}, {"subscriberIds", json::array()}});
    }
    topic = topics.erase(topic);
  }
  return text({{"op", "connectionGraphUpdate"},
               {"publishedTopics", published},
               {"subscribedTopics", subscribed},
               {"advertisedServices", changed(before.servers, now.servers, "providerIds")},
               {"removedTopics", topics},
               {"removedServices", services}});
}

Frame service_failure(std::uint32_t service, std::uint32_t call, const std::string& reason) {
  return text({{"op", "serviceCallFailure"},
               {"serviceId", service},
               {"callId", call},
               {"message", reason}});
}

Frame message_data(std::uint32_t subscription, std::uint64_t stamp_ns, SharedBytes message) {
  Frame frame = binary(message_data_opcode);
  append(frame.head, subscription);
  append(frame.head, stamp_ns);
  frame.payload = std::move(message);
  return frame;
}

Frame time(std::uint64_t now_ns) {
  Frame frame = binary(time_opcode);
  append(frame.head, now_ns);
  return frame;
}

Frame service_response(const CallService& call, SharedBytes response) {
  Frame frame = binary(response_opcode);
  append(frame.head, call.service);
  append(frame.head, call.call);
  append(frame.head, static_cast<std::uint32_t>(call.encoding.size()));
  frame.head += call.encoding;
  frame.payload = std::move(response);
  return frame;
}

}  // namespace tocsin::foxglove
