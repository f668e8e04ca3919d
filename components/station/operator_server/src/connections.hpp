// SPDX-License-Identifier: Apache-2.0
// Connections of the web server. For web_server.cpp only.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "answers.hpp"
#include "client_stream.hpp"
#include "web_server.hpp"

namespace tocsin::foxglove {

/// A client as the server knows it.
class Socket {
 public:
  virtual ~Socket() = default;
  virtual void read_on() = 0;
  virtual void send(std::vector<Frame> frames) = 0;
  virtual void close(const std::string& why) = 0;
};

/// What connections need of their server. One thread.
class Home {
 public:
  virtual ~Home() = default;
  [[nodiscard]] virtual const WebSettings& settings() const = 0;
  [[nodiscard]] virtual const WebEvents& events() const = 0;
  [[nodiscard]] virtual Answer answer(const Request& request, bool wants_socket) = 0;
  /// Calls `done` with what `make` has made, later.
  virtual void make_slowly(SlowResponse make, std::function<void(Response&&)> done) = 0;
  [[nodiscard]] virtual ClientId add(const std::shared_ptr<Socket>& socket) = 0;
  virtual void remove(ClientId client, const std::string& why) = 0;
};

/// A lease on one of the server's connections.
using Lease = std::shared_ptr<void>;

inline std::chrono::milliseconds milliseconds_of(double seconds) {
  return std::chrono::milliseconds(static_cast<long>(seconds * 1000));
}

/// Answers requests for files, one after the other, until one asks for a WebSocket.
void serve_http(Home& home, ClientStream stream, Lease lease);
/// Tells a connection that is one too many why, for a second at most, whatever it wants.
void turn_away(const std::string& why, ClientStream stream, Lease lease);
/// Makes a WebSocket of a connection that has asked for it by `request`.
void open_socket(Home& home, ClientStream stream, Lease lease, const Request& request,
                 const OpenSocket& verdict);

}  // namespace tocsin::foxglove
