// SPDX-License-Identifier: Apache-2.0
// What the server says in the Foxglove WebSocket protocol. Pure.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "operator_server/client_message.hpp"

namespace tocsin::foxglove {

/// Number of a connection; none is used twice.
using ClientId = std::uint64_t;

using SharedBytes = std::shared_ptr<const std::vector<std::uint8_t>>;

/// A WebSocket message. The payload, which follows `head`, is shared by all who get it.
struct Frame {
  enum class Kind { text, binary };
  Kind kind = Kind::text;
  std::string head;
  SharedBytes payload = nullptr;
  [[nodiscard]] std::size_t size() const { return head.size() + (payload ? payload->size() : 0); }
};

/// What a server says of itself first.
struct ServerFacts {
  std::string name;
  std::string session;  ///< another one: a client forgets what it knows of the server
  std::map<std::string, std::string> metadata;
};

/// The type of messages, and how it is written down.
struct Schema {
  std::string name;      ///< `nav_msgs/msg/Odometry`
  std::string encoding;  ///< of the text: `ros2msg`
  std::string text;
};
/// A topic that clients can subscribe to.
struct Channel {
  std::string topic;  ///< `/odom`
  Schema schema;
  bool latched = false;  ///< who subscribes gets the last message
};
struct Service {
  std::string name;  ///< `/dock`
  std::string type;  ///< `std_srvs/srv/Trigger`
  Schema request;
  Schema response;
};

enum class Level { info = 0, warning = 1, error = 2 };

/// Who publishes, subscribes and serves: names of nodes by topic or service.
struct Graph {
  using Users = std::map<std::string, std::set<std::string>>;
  Users publishers;
  Users subscribers;
  Users servers;
};

[[nodiscard]] Frame server_info(const ServerFacts& facts);
[[nodiscard]] Frame advertise(const std::map<std::uint32_t, Channel>& channels);
[[nodiscard]] Frame unadvertise(const std::vector<std::uint32_t>& channels);
[[nodiscard]] Frame advertise_services(const std::map<std::uint32_t, Service>& services);
[[nodiscard]] Frame unadvertise_services(const std::vector<std::uint32_t>& services);
/// `id`: a later status of the same one takes its place; empty: none.
[[nodiscard]] Frame status(Level level, const std::string& text, const std::string& id = "");
[[nodiscard]] Frame remove_status(const std::string& id);
[[nodiscard]] Frame parameter_values(const std::vector<Parameter>& parameters,
                                     const std::optional<std::string>& id);
/// What has changed from one picture to the next.
[[nodiscard]] Frame graph_update(const Graph& before, const Graph& now);
[[nodiscard]] Frame service_failure(std::uint32_t service, std::uint32_t call,
                                    const std::string& reason);
/// `stamp_ns`: [ns] since the Unix epoch, when the message was received.
[[nodiscard]] Frame message_data(std::uint32_t subscription, std::uint64_t stamp_ns,
                                 SharedBytes message);
[[nodiscard]] Frame time(std::uint64_t now_ns);
[[nodiscard]] Frame service_response(const CallService& call, SharedBytes response);

}  // namespace tocsin::foxglove
