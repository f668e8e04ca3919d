// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

#include "operator_server/operator_server_component.hpp"
#include "runtime/sim_bus.hpp"
#include "socket_client.hpp"

namespace tocsin {

/// The component on the bus in memory, at a free port, with clients on real sockets.
class Served {
 public:
  explicit Served(OperatorServerComponent::Params params = {}, foxglove::LookAtHost look = {}) {
    params.port = 0;
    sut = look ? std::make_unique<OperatorServerComponent>(context, params, std::move(look))
               : std::make_unique<OperatorServerComponent>(context, params);
    bus.add(*sut);
  }

  [[nodiscard]] ClientFacts facts() const {
    ClientFacts facts;
    facts.port = sut->port();
    return facts;
  }
  /// Ticks until `done`; false when that takes longer than ten seconds.
  [[nodiscard]] bool until(const std::function<bool()>& done) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!done()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      bus.run_for(std::chrono::milliseconds(10));
      std::this_thread::yield();
    }
    return true;
  }
  /// A client that is open and has heard what there is.
  [[nodiscard]] std::unique_ptr<SocketClient> client() { return client(facts()); }
  [[nodiscard]] std::unique_ptr<SocketClient> client(const ClientFacts& its_facts) {
    auto made = std::make_unique<SocketClient>(its_facts);
    (void)until([&] { return made->ended() || !made->heard("advertise").empty(); });
    return made;
  }
  /// Subscribes, and waits until it holds.
  void subscribe(SocketClient& client, const std::string& topic, std::uint32_t id) {
    client.say(
        {{"op", "subscribe"},
         {"subscriptions", {{{"id", id}, {"channelId", client.channel(topic).value_or(0)}}}}});
    settle(client);
  }
  /// Until the server has dealt with all that the client has said.
  void settle(SocketClient& client) {
    const std::size_t before = client.heard("parameterValues").size();
    client.say(
        {{"op", "getParameters"}, {"parameterNames", nlohmann::json::array()}, {"id", "settled"}});
    (void)until([&] { return client.ended() || client.heard("parameterValues").size() > before; });
  }

  SimBus bus;
  Context context{bus, "operator_server", Role::gcs};
  std::unique_ptr<OperatorServerComponent> sut;
};

}  // namespace tocsin
