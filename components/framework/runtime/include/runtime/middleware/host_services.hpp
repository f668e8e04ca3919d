// SPDX-License-Identifier: Apache-2.0
// Services of any type on a host, for a router that carries their calls to other hosts.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "runtime/detail/services.hpp"

namespace tocsin {

/// A service as people of ROS 2 name it.
struct HostService {
  std::string name;  ///< without the slash in front, in the namespace of the run
  std::string type;  ///< `std_srvs/srv/Trigger`
};
[[nodiscard]] inline bool operator<(const HostService& one, const HostService& other) {
  return std::tie(one.name, one.type) < std::tie(other.name, other.type);
}
[[nodiscard]] inline bool operator==(const HostService& one, const HostService& other) {
  return one.name == other.name && one.type == other.type;
}

/// What happens at HostServices. Messages have their encapsulation header, and nothing of what one
/// maker's clients put in front of them.
namespace host_service_event {
struct Server {  ///< somebody else on this host begins or ends to serve
  HostService what;
  bool there;
};
struct Client {  ///< somebody else on this host begins or ends to call
  HostService what;
  bool there;
};
struct Request {  ///< to a service of `serve`
  std::string service;
  CallId id;
  std::vector<std::uint8_t> message;
};
struct Reply {  ///< to what was asked of a service of `call`
  std::string service;
  std::int64_t number;
  std::vector<std::uint8_t> message;
};
struct Changed {  ///< a client or server came or went: what waited may go
  std::string service;
};
}  // namespace host_service_event
using HostServiceEvent = std::variant<host_service_event::Server, host_service_event::Client,
                                      host_service_event::Request, host_service_event::Reply,
                                      host_service_event::Changed>;

/// Serves and calls on a host on behalf of others. One thread; who opened it is told, from any
/// thread, when `take` has something.
class HostServices {
 public:
  virtual ~HostServices() = default;
  /// The oldest thing that happened and was not taken yet.
  [[nodiscard]] virtual std::optional<HostServiceEvent> take() = 0;

  /// Serves it until `end_serving`. Once for each name.
  virtual void serve(const HostService& service) = 0;
  virtual void end_serving(const std::string& name) = 0;
  /// Services that peers offer, served here or not: the nodes whose own they are stand in the graph
  /// of this host, since clients of a node look for it there before they call.
  virtual void know(const std::set<std::string>& /*services*/) {}
  /// To a request of a service of `serve`; waits for a client that cannot hear it yet.
  virtual void reply(const std::string& service, const CallId& id,
                     std::vector<std::uint8_t> message) = 0;

  /// Is a client of it until `end_calling`. Once for each name.
  virtual void call(const HostService& service) = 0;
  virtual void end_calling(const std::string& name) = 0;
  /// The number that the reply will have; nothing while no server is there.
  [[nodiscard]] virtual std::optional<std::int64_t> ask(const std::string& service,
                                                        std::vector<std::uint8_t> message) = 0;
};

}  // namespace tocsin
