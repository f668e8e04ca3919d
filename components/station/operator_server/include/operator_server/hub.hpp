// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "operator_server/client_message.hpp"
#include "operator_server/server_message.hpp"
#include "operator_server/user_role.hpp"

namespace tocsin::foxglove {

class HubClient;

struct HubSettings {
  ServerFacts server;
  std::size_t backlog = 2;                 ///< messages of a subscription that wait for a client
  std::vector<std::string> writable = {};  ///< topics, or patterns, on which clients may publish
};

/// What the hub asks of the host for a client.
struct OpenTopic {
  ClientId client;
  ClientChannel channel;
};
struct WriteMessage {
  ClientId client;
  std::string topic;
  std::string encoding;
  std::string payload;
  UserRole role = UserRole::driver;  ///< of the client
};
struct AskParameters {
  ClientId client;
  GetParameters wish;
};
struct ChangeParameters {
  ClientId client;
  SetParameters wish;
};
struct AskService {
  ClientId client;
  std::string name;
  CallService call;
};
using Order = std::variant<OpenTopic, WriteMessage, AskParameters, ChangeParameters, AskService>;

/// All clients of the server: who hears what, who may say what, and what waits for each. Pure: it
/// has no socket and no clock. Bad input of a client is answered by one
/// status to that client, and changes nothing.
class Hub {
 public:
  explicit Hub(const HubSettings& settings);
  ~Hub();

  /// `wall_ns` [ns since the Unix epoch] is told at once: clients begin their time axis with it.
  /// The role is told, too.
  void add_client(ClientId client, std::uint64_t wall_ns, UserRole role = UserRole::driver);
  void remove_client(ClientId client);
  [[nodiscard]] std::size_t clients() const { return clients_.size(); }

  /// What the host has to do about a frame of a client.
  [[nodiscard]] std::vector<Order> on_frame(ClientId client, Frame::Kind kind,
                                            std::string_view frame);
  /// The frames to be sent next, about `bytes` together.
  [[nodiscard]] std::vector<Frame> take(ClientId client, std::size_t bytes);
  /// Clients that do not read and have to go.
  [[nodiscard]] std::vector<ClientId> overflown() const;

  /// All channels and services that there are now; what is new or gone is told to all clients. One
  /// whose type has changed is another one.
  void set_channels(const std::vector<Channel>& channels);
  void set_services(const std::vector<Service>& services);
  void set_graph(const Graph& graph);
  /// A message of a channel, for its subscribers. `writer` tells its writers apart.
  void on_message(const std::string& topic, std::uint64_t stamp_ns, const SharedBytes& message,
                  std::uint64_t writer = 0);
  /// [ns] since the Unix epoch, for all clients; tells those that are slow what they miss.
  void tell_time(std::uint64_t wall_ns);
  void tell_drops();

  /// Answers to orders. A client that has gone gets none.
  void refuse_topic(ClientId client, std::uint32_t channel, const std::string& reason);
  void tell(ClientId client, Level level, const std::string& text);
  void answer_parameters(ClientId client, const std::vector<Parameter>& values,
                         const std::optional<std::string>& id);
  void answer_service(ClientId client, const CallService& call, const SharedBytes& response);
  void fail_service(ClientId client, const CallService& call, const std::string& reason);
  /// For the subscribers of parameters.
  void on_parameters(const std::vector<Parameter>& values);

  /// Topics that somebody hears.
  [[nodiscard]] std::set<std::string> heard() const;
  /// Topics that somebody has open for writing.
  [[nodiscard]] std::set<std::string> written() const;
  [[nodiscard]] bool wants_parameters() const;
  /// Messages that slow clients missed, since the beginning.
  [[nodiscard]] std::uint64_t drops() const { return drops_; }

 private:
  struct Handler;
  using Orders = std::vector<Order>;
  void subscribe(HubClient& client, const Subscribe& message);
  [[nodiscard]] Orders open_topics(ClientId id, HubClient& client, const Advertise& message);
  [[nodiscard]] Orders write(ClientId id, HubClient& client, Publish& message);
  [[nodiscard]] Orders call(ClientId id, HubClient& client, const CallService& message);
  [[nodiscard]] std::string fault_of(const HubClient& client, const ClientChannel& channel) const;
  [[nodiscard]] bool may_write(const std::string& topic) const;
  static void tell_unheard(HubClient& client, const std::string& topic);
  [[nodiscard]] bool is_heard(std::uint32_t channel) const;
  HubClient* find(ClientId client);

  struct Known {
    Channel channel;
    struct Last {
      SharedBytes message;
      std::uint64_t stamp_ns;
    };
    std::map<std::uint64_t, Last> last;  ///< of a latched channel, by writer
  };
  const HubSettings settings_;
  std::uint32_t last_id_ = 0;  ///< of channels and services
  std::map<std::uint32_t, Known> channels_;
  std::map<std::uint32_t, Service> services_;
  std::map<std::string, std::uint32_t> channel_ids_;  ///< by topic
  Graph graph_;
  std::map<ClientId, std::unique_ptr<HubClient>> clients_;
  std::uint64_t drops_ = 0;
};

}  // namespace tocsin::foxglove
