// SPDX-License-Identifier: Apache-2.0
// Services as a bus sees them; components use the ports of service_port.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "idl_support/type_info.hpp"

namespace tocsin {

/// One end of a service.
struct ServiceEndpoint {
  /// ROS name without its slash in front: `dock` is `/dock`, in the namespace of the run;
  /// `~/dock` is `/NODE/dock`.
  std::string name;
  const TypeInfo* request;
  const TypeInfo* response;
  std::string node = "";  ///< of ROS 2 that has it; empty: none
  int depth = 10;         ///< requests, or replies, that are kept until they are taken
};

/// `~/dock` of the node `arm` is `arm/dock`.
[[nodiscard]] std::string service_name(const ServiceEndpoint& endpoint);

/// How the two ends say which reply belongs to which request.
enum class Correlation {
  identity,  ///< beside the message, as the sample's related identity: Fast DDS, ours
  header,    ///< in front of the message, 16 bytes: Cyclone DDS
};

/// Who asked what. A server gives it back with its reply, and looks at nothing in it.
struct CallId {
  std::array<std::uint8_t, 16> client{};
  std::array<std::uint8_t, 12> participant{};  ///< that the client belongs to
  std::int64_t number = 0;
  Correlation correlation = Correlation::identity;
};

struct ServiceRequest {
  std::shared_ptr<const void> message;
  CallId id;
};

struct ServiceReply {
  std::shared_ptr<const void> message;
  std::int64_t number = 0;  ///< what ClientEnd::send returned for the request
};

/// Called from any thread; must not block.
struct ServerReceiver {
  virtual ~ServerReceiver() = default;
  virtual void receive(ServiceRequest&& request) = 0;
  /// A reply that waited for its client may go now: call ServerEnd::flush.
  virtual void wake() = 0;
};

/// Called from any thread; must not block.
struct ClientReceiver {
  virtual ~ClientReceiver() = default;
  virtual void receive(ServiceReply&& reply) = 0;
  /// A server came or went.
  virtual void wake() = 0;
};

/// Serves as long as it lives. One thread.
class ServerEnd {
 public:
  virtual ~ServerEnd() = default;
  /// Held back until the client can hear it, or as many others of the same depth have come.
  virtual void reply(const CallId& id, const std::shared_ptr<const void>& message) = 0;
  virtual void flush() {}
};

/// Calls as long as it lives. One thread.
class ClientEnd {
 public:
  virtual ~ClientEnd() = default;
  /// The number of the call, which its reply will have; nothing while no server is there.
  [[nodiscard]] virtual std::optional<std::int64_t> send(
      const std::shared_ptr<const void>& message) = 0;
  /// Whether a server is there.
  [[nodiscard]] virtual bool available() const = 0;
};

}  // namespace tocsin
