// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "runtime/detail/service_ports.hpp"

namespace tocsin {

/// Member of a component that serves:
///
///     struct Reset {
///       using Request = std_srvs::srv::Trigger_Request;
///       using Response = std_srvs::srv::Trigger_Response;
///       static constexpr const char* name = "~/reset";
///     };
///     tocsin::Server<Reset> reset_{*this};
///
/// A tick takes the requests and replies to each, at once or in a later tick. Clients of
/// rmw_fastrtps and rmw_cyclonedds are served alike.
template <class Service>
class Server : public ServerPort {
 public:
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  struct Call {
    std::shared_ptr<const Request> request;
    CallId id;
  };
  explicit Server(Component& owner) : Server(owner, Service::name, owner.node()) {}
  /// Of another node than its owner's, or under a name that is made at run time.
  Server(Component& owner, const std::string& name, const std::string& node, int depth = 10)
      : ServerPort(owner, {name, &type_info<Request>(), &type_info<Response>(), node, depth}) {}

  /// The oldest request that was not taken yet.
  [[nodiscard]] std::optional<Call> take() {
    auto request = take_request();
    if (!request) return std::nullopt;
    return Call{std::static_pointer_cast<const Request>(request->message), request->id};
  }
  /// Never blocks. A client that has gone gets nothing.
  void reply(const CallId& id, Response response) {
    reply_message(id, std::make_shared<const Response>(std::move(response)));
  }
};

/// Member of a component that calls. Asynchronous: a tick calls, a later one takes what came of it.
template <class Service>
class Client : public ClientPort {
 public:
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  struct Outcome {
    CallNumber call;
    std::shared_ptr<const Response> response;  ///< null: nobody answered before the deadline
  };
  explicit Client(Component& owner) : Client(owner, Service::name, owner.node()) {}
  /// Of another node than its owner's, or under a name that is made at run time.
  Client(Component& owner, const std::string& name, const std::string& node)
      : ClientPort(owner, {name, &type_info<Request>(), &type_info<Response>(), node}) {}

  /// Asks as soon as a server is there. The component is ticked at `deadline` at the latest, and
  /// each call has one outcome. A reply that comes after the deadline is dropped.
  CallNumber call(Request request, Time deadline) {
    return call_message(std::make_shared<const Request>(std::move(request)), deadline);
  }
  /// What became of a call; in each tick until there is none.
  [[nodiscard]] std::optional<Outcome> take(Time now) {
    auto outcome = take_outcome(now);
    if (!outcome) return std::nullopt;
    return Outcome{outcome->call, std::static_pointer_cast<const Response>(outcome->message)};
  }
};

}  // namespace tocsin
