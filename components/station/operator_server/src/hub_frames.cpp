// SPDX-License-Identifier: Apache-2.0
// What clients ask of the hub.
#include <fmt/format.h>
#include <fnmatch.h>

#include <utility>

#include "foundation/ends_with.hpp"
#include "foundation/printable.hpp"
#include "hub_client.hpp"
#include "operator_server/hub.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::foxglove {
namespace {

constexpr std::size_t most_subscriptions = 1000;  ///< of one client
constexpr std::size_t most_channels = 100;        ///< that one client publishes

/// What the 3D panels of Foxglove and Lichtblick have open whether anybody publishes there or not.
bool is_customary(const std::string& topic) {
  return topic == "/move_base_simple/goal" || topic == "/clicked_point" || topic == "/initialpose";
}

/// What an observer may publish.
bool is_emergency_stop(const std::string& topic) {
  return ends_with(topic, std::string("/") + topic::EmergencyStopRequest::info.name);
}

bool is_known_encoding(const std::string& encoding) {
  return encoding == "cdr" || encoding == "json";
}

}  // namespace

/// Does what each kind of message says.
struct Hub::Handler {
  Hub& hub;
  ClientId id;
  HubClient& client;

  Orders operator()(const ProtocolFault& fault) const {
    client.fault(fault.reason);
    return {};
  }
  Orders operator()(const Subscribe& message) const {
    hub.subscribe(client, message);
    return {};
  }
  Orders operator()(const Unsubscribe& message) const {
    for (const std::uint32_t one : message.ids) {
      if (client.subscriptions.erase(one) == 0) {
        client.fault(fmt::format("unsubscribe: there is no subscription {}", one));
      }
      client.outbox.forget(one);
    }
    return {};
  }
  Orders operator()(const Advertise& message) const { return hub.open_topics(id, client, message); }
  Orders operator()(const Unadvertise& message) const {
    for (const std::uint32_t channel : message.ids) {
      if (client.channels.erase(channel) + client.unheard.erase(channel) == 0) {
        client.fault(fmt::format("unadvertise: there is no channel {} of this client", channel));
      }
    }
    return {};
  }
  Orders operator()(Publish& message) const { return hub.write(id, client, message); }
  Orders operator()(GetParameters& message) const {
    return {AskParameters{id, std::move(message)}};
  }
  Orders operator()(SetParameters& message) const {
    if (client.role == UserRole::observer) {
      client.fault("parameters: an observer may not set them");
      return {};
    }
    return {ChangeParameters{id, std::move(message)}};
  }
  Orders operator()(const SubscribeParameters& message) const {
    client.all_parameters = client.all_parameters || message.names.empty();
    client.parameters.insert(message.names.begin(), message.names.end());
    return {};
  }
  Orders operator()(const UnsubscribeParameters& message) const {
    if (message.names.empty()) {
      client.all_parameters = false;
      client.parameters.clear();
    }
    for (const std::string& name : message.names) client.parameters.erase(name);
    return {};
  }
  Orders operator()(const SubscribeGraph& /*message*/) const {
    client.hears_graph = true;
    client.outbox.add_control(graph_update({}, hub.graph_));
    return {};
  }
  Orders operator()(const UnsubscribeGraph& /*message*/) const {
    client.hears_graph = false;
    return {};
  }
  Orders operator()(const CallService& message) const { return hub.call(id, client, message); }
};

std::vector<Order> Hub::on_frame(ClientId id, Frame::Kind kind, std::string_view frame) {
  HubClient* const client = find(id);
  if (client == nullptr) return {};
  ClientMessage message = kind == Frame::Kind::text ? parse_text(frame) : parse_binary(frame);
  return std::visit(Handler{*this, id, *client}, message);
}

void Hub::subscribe(HubClient& client, const Subscribe& message) {
  for (const Subscribe::Wish& wish : message.wishes) {
    const auto found = channels_.find(wish.channel);
    if (found == channels_.end()) {
      client.fault(fmt::format("subscribe: there is no channel {}", wish.channel));
    } else if (client.subscriptions.count(wish.id) != 0) {
      client.fault(fmt::format("subscribe: subscription {} is there already", wish.id));
    } else if (client.subscriptions.size() >= most_subscriptions) {
      client.fault(fmt::format("subscribe: more than {} subscriptions", most_subscriptions));
    } else {
      Known& known = found->second;
      // Nobody has heard it since: it may be old, and the host's port is about to get the last one.
      if (!is_heard(wish.channel)) known.last.clear();
      client.subscriptions[wish.id] = wish.channel;
      // The newest comes last: a writer that has gone has not the last word.
      std::multimap<std::uint64_t, SharedBytes> by_time;
      for (const auto& one : known.last) by_time.emplace(one.second.stamp_ns, one.second.message);
      for (const auto& [stamp_ns, last] : by_time) {
        client.outbox.add_data(wish.id, message_data(wish.id, stamp_ns, last));
      }
    }
  }
}

bool Hub::is_heard(std::uint32_t channel) const {
  return std::any_of(clients_.begin(), clients_.end(), [channel](const auto& client) {
    const auto& all = client.second->subscriptions;
    return std::any_of(all.begin(), all.end(),
                       [channel](const auto& one) { return one.second == channel; });
  });
}

bool Hub::may_write(const std::string& topic) const {
  return std::any_of(settings_.writable.begin(), settings_.writable.end(),
                     [&topic](const std::string& pattern) {
                       return ::fnmatch(pattern.c_str(), topic.c_str(), 0) == 0;
                     });
}

std::string Hub::fault_of(const HubClient& client, const ClientChannel& channel) const {
  const std::string topic = printable(channel.topic);
  if (!may_write(channel.topic))
    return topic + ": clients may not publish here (parameter writable)";
  if (client.role == UserRole::observer && !is_emergency_stop(channel.topic))
    return topic + ": an observer may not publish here";
  if (client.channels.count(channel.id) != 0) {
    return fmt::format("advertise: channel {} of this client is there already", channel.id);
  }
  if (!is_known_encoding(channel.encoding)) {
    return topic + ": encoding '" + printable(channel.encoding, 50) + "' is not one of: cdr, json";
  }
  if (client.channels.size() >= most_channels) {
    return fmt::format("advertise: more than {} channels", most_channels);
  }
  return {};
}

std::vector<Order> Hub::open_topics(ClientId id, HubClient& client, const Advertise& message) {
  Orders orders;
  for (const ClientChannel& channel : message.channels) {
    if (is_customary(channel.topic) && !may_write(channel.topic) &&
        client.unheard.size() < most_channels) {
      client.unheard[channel.id] = channel.topic;
      continue;
    }
    const std::string fault = fault_of(client, channel);
    if (!fault.empty()) {
      client.fault(fault);
      continue;
    }
    client.channels[channel.id] = channel;
    orders.emplace_back(OpenTopic{id, channel});
  }
  return orders;
}

/// Once for each topic: every click would repeat it.
void Hub::tell_unheard(HubClient& client, const std::string& topic) {
  if (!client.told_unheard.insert(topic).second) return;
  client.outbox.add_control(status(
      Level::warning, topic + ": nobody here takes it, nothing was published; a goal goes to /goal "
                              "(parameter writable lets clients publish it)"));
}

std::vector<Order> Hub::write(ClientId id, HubClient& client, Publish& message) {
  const auto unheard = client.unheard.find(message.channel);
  if (unheard != client.unheard.end()) {
    tell_unheard(client, unheard->second);
    return {};
  }
  const auto found = client.channels.find(message.channel);
  if (found == client.channels.end()) {
    client.fault(
        fmt::format("message data: there is no channel {} of this client", message.channel));
    return {};
  }
  const ClientChannel& channel = found->second;
  return {
      WriteMessage{id, channel.topic, channel.encoding, std::move(message.payload), client.role}};
}

std::vector<Order> Hub::call(ClientId id, HubClient& client, const CallService& message) {
  const auto found = services_.find(message.service);
  std::string fault;
  if (found == services_.end()) {
    fault = fmt::format("there is no service {}", message.service);
  } else if (client.role == UserRole::observer) {
    fault = "an observer may not call services";
  } else if (!is_known_encoding(message.encoding)) {
    fault = "encoding '" + printable(message.encoding, 50) + "' is not one of: cdr, json";
  }
  if (fault.empty()) return {AskService{id, found->second.name, message}};
  client.outbox.add_control(service_failure(message.service, message.call, fault));
  return {};
}

}  // namespace tocsin::foxglove
