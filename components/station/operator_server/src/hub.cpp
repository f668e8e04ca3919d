// SPDX-License-Identifier: Apache-2.0
// What the host tells: channels, services, messages, answers.
#include "operator_server/hub.hpp"

#include <fmt/format.h>

#include <utility>

#include "foundation/enum_words.hpp"
#include "hub_client.hpp"

namespace tocsin::foxglove {
namespace {

bool same(const Schema& one, const Schema& other) {
  return one.name == other.name && one.encoding == other.encoding && one.text == other.text;
}
bool same(const Channel& one, const Channel& other) {
  return one.topic == other.topic && one.latched == other.latched && same(one.schema, other.schema);
}
bool same(const Service& one, const Service& other) {
  return one.name == other.name && one.type == other.type && same(one.request, other.request) &&
         same(one.response, other.response);
}

/// The numbers of those of `known` that are not among `wanted`.
template <class Known, class Wanted, class Same>
std::vector<std::uint32_t> missing(const Known& known, const Wanted& wanted, const Same& equal) {
  std::vector<std::uint32_t> gone;
  for (const auto& [id, one] : known) {
    const bool there = std::any_of(wanted.begin(), wanted.end(),
                                   [&one = one, &equal](const auto& it) { return equal(one, it); });
    if (!there) gone.push_back(id);
  }
  return gone;
}

}  // namespace

Hub::Hub(const HubSettings& settings) : settings_(settings) {}
Hub::~Hub() = default;

HubClient* Hub::find(ClientId client) {
  const auto found = clients_.find(client);
  return found == clients_.end() ? nullptr : found->second.get();
}

void Hub::add_client(ClientId id, std::uint64_t wall_ns, UserRole role) {
  OutboxLimits limits;
  limits.backlog = settings_.backlog;
  auto client = std::make_unique<HubClient>(limits, role);
  ServerFacts server = settings_.server;
  server.metadata["role"] = word_of(role);
  client->outbox.add_control(server_info(server));
  client->outbox.add_control(time(wall_ns));
  std::map<std::uint32_t, Channel> channels;
  for (const auto& [number, known] : channels_) channels[number] = known.channel;
  if (!channels.empty()) client->outbox.add_control(advertise(channels));
  if (!services_.empty()) client->outbox.add_control(advertise_services(services_));
  clients_[id] = std::move(client);
}

void Hub::remove_client(ClientId client) { clients_.erase(client); }

std::vector<Frame> Hub::take(ClientId id, std::size_t bytes) {
  HubClient* const client = find(id);
  return client == nullptr ? std::vector<Frame>() : client->outbox.take(bytes);
}

std::vector<ClientId> Hub::overflown() const {
  std::vector<ClientId> all;
  for (const auto& [id, client] : clients_) {
    if (client->outbox.overflown()) all.push_back(id);
  }
  return all;
}

void Hub::set_channels(const std::vector<Channel>& channels) {
  const auto gone = missing(channels_, channels, [](const Known& known, const Channel& channel) {
    return same(known.channel, channel);
  });
  for (const std::uint32_t id : gone) {
    channel_ids_.erase(channels_.at(id).channel.topic);
    channels_.erase(id);
  }
  std::map<std::uint32_t, Channel> fresh;
  for (const Channel& channel : channels) {
    if (channel_ids_.count(channel.topic) != 0) continue;
    fresh[++last_id_] = channel;
    channels_[last_id_].channel = channel;
    channel_ids_[channel.topic] = last_id_;
  }
  for (const auto& [id, client] : clients_) {
    for (const std::uint32_t channel : gone) client->forget_channel(channel);
    if (!gone.empty()) client->outbox.add_control(unadvertise(gone));
    if (!fresh.empty()) client->outbox.add_control(advertise(fresh));
  }
}

void Hub::set_services(const std::vector<Service>& services) {
  const auto gone = missing(services_, services, [](const Service& known, const Service& service) {
    return same(known, service);
  });
  for (const std::uint32_t id : gone) services_.erase(id);
  std::map<std::uint32_t, Service> fresh;
  for (const Service& service : services) {
    const bool there = std::any_of(services_.begin(), services_.end(), [&](const auto& known) {
      return known.second.name == service.name;
    });
    if (there) continue;
    fresh[++last_id_] = service;
    services_[last_id_] = service;
  }
  for (const auto& [id, client] : clients_) {
    if (!gone.empty()) client->outbox.add_control(unadvertise_services(gone));
    if (!fresh.empty()) client->outbox.add_control(advertise_services(fresh));
  }
}

void Hub::set_graph(const Graph& graph) {
  const bool same_graph = graph.publishers == graph_.publishers &&
                          graph.subscribers == graph_.subscribers &&
                          graph.servers == graph_.servers;
  if (same_graph) return;
  const Frame update = graph_update(graph_, graph);
  for (const auto& [id, client] : clients_) {
    if (client->hears_graph) client->outbox.add_control(update);
  }
  graph_ = graph;
}

void Hub::on_message(const std::string& topic, std::uint64_t stamp_ns, const SharedBytes& message,
                     std::uint64_t writer) {
  const auto found = channel_ids_.find(topic);
  if (found == channel_ids_.end()) return;
  Known& known = channels_.at(found->second);
  if (known.channel.latched) known.last[writer] = {message, stamp_ns};
  for (const auto& [id, client] : clients_) {
    for (const auto& [subscription, channel] : client->subscriptions) {
      if (channel != found->second) continue;
      client->outbox.add_data(subscription, message_data(subscription, stamp_ns, message));
    }
  }
}

void Hub::tell_time(std::uint64_t wall_ns) {
  for (const auto& [id, client] : clients_) client->outbox.set_time(time(wall_ns));
}

void Hub::tell_drops() {
  constexpr const char* drops_status = "drops";
  for (const auto& [id, client] : clients_) {
    std::string text;
    for (const auto& [subscription, count] : client->outbox.take_drops()) {
      drops_ += count;
      const std::string& topic = channels_.at(client->subscriptions.at(subscription)).channel.topic;
      text += fmt::format("{} {} of {}", text.empty() ? "" : ",", count, topic);
    }
    if (!text.empty()) {
      client->outbox.add_control(status(
          Level::warning, "this connection is too slow; messages dropped:" + text, drops_status));
    } else if (client->was_slow) {
      client->outbox.add_control(remove_status(drops_status));
    }
    client->was_slow = !text.empty();
  }
}

void Hub::refuse_topic(ClientId id, std::uint32_t channel, const std::string& reason) {
  HubClient* const client = find(id);
  if (client == nullptr) return;
  client->channels.erase(channel);
  client->fault(reason);
}

void Hub::tell(ClientId id, Level level, const std::string& text) {
  HubClient* const client = find(id);
  if (client != nullptr) client->outbox.add_control(status(level, text));
}

void Hub::answer_parameters(ClientId id, const std::vector<Parameter>& values,
                            const std::optional<std::string>& request) {
  HubClient* const client = find(id);
  if (client != nullptr) client->outbox.add_control(parameter_values(values, request));
}

void Hub::answer_service(ClientId id, const CallService& call, const SharedBytes& response) {
  HubClient* const client = find(id);
  if (client != nullptr) client->outbox.add_control(service_response(call, response));
}

void Hub::fail_service(ClientId id, const CallService& call, const std::string& reason) {
  HubClient* const client = find(id);
  if (client != nullptr) {
    client->outbox.add_control(service_failure(call.service, call.call, reason));
  }
}

void Hub::on_parameters(const std::vector<Parameter>& values) {
  for (const auto& [id, client] : clients_) {
    std::vector<Parameter> heard;
    for (const Parameter& value : values) {
      if (client->hears_parameter(value.name)) heard.push_back(value);
    }
    if (!heard.empty()) client->outbox.add_control(parameter_values(heard, std::nullopt));
  }
}

std::set<std::string> Hub::heard() const {
  std::set<std::string> topics;
  for (const auto& [id, client] : clients_) {
    for (const auto& one : client->subscriptions) {
      topics.insert(channels_.at(one.second).channel.topic);
    }
  }
  return topics;
}

std::set<std::string> Hub::written() const {
  std::set<std::string> topics;
  for (const auto& [id, client] : clients_) {
    for (const auto& one : client->channels) topics.insert(one.second.topic);
  }
  return topics;
}

bool Hub::wants_parameters() const {
  return std::any_of(clients_.begin(), clients_.end(), [](const auto& one) {
    return one.second->all_parameters || !one.second->parameters.empty();
  });
}

}  // namespace tocsin::foxglove
