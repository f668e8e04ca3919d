// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "foundation/file_descriptor.hpp"
#include "operator_server/access.hpp"
#include "operator_server/server_message.hpp"

namespace tocsin::foxglove {

struct WebSettings {
  AccessRules access;
  std::string page;           ///< folder of the page's files; empty: there is none
  std::string bags = {};      ///< folder of the recordings; empty: there is none
  std::string recorded = {};  ///< folder of this host's recorder; empty: there is none
  std::string decide = {};    ///< program that decides a recording again; empty: not installed
  std::string certificate;    ///< PEM file with the chain; empty: no TLS
  std::string key;            ///< PEM file
  std::size_t most_connections = 64;
  std::size_t most_frame_bytes = std::size_t{1} << 20U;  ///< of a message from a client
  double ping_s = 5;      ///< a client that is silent for so long is asked, and closed after twice
  double request_s = 10;  ///< a connection that asks nothing for so long is closed
};

/// A client that has connected.
struct WebPeer {
  std::string address;
  UserRole role = UserRole::driver;
};

/// What happens to connections. Called by the server's own thread; must not block.
struct WebEvents {
  std::function<void(ClientId, const WebPeer& peer)> opened;
  /// The next one comes after WebServer::read_on.
  std::function<void(ClientId, Frame::Kind, std::string&& bytes)> received;
  std::function<void(ClientId)> sent;  ///< all that was given to WebServer::send
  std::function<void(ClientId, const std::string& why)> closed;
  std::function<void(const std::string& what)> refused;
};

/// HTTP and WebSocket on Boost.Beast, on a thread of its own. Its functions may be called by any
/// one thread. No compression: the deflate of Beast 1.74 has the flaw CVE-2018-25032.
class WebServer {
 public:
  /// Throws ConfigError naming the file when certificate and key cannot be used.
  WebServer(const WebSettings& settings, WebEvents events);
  /// Closes all connections.
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Accepts connections from now on. Once.
  void start(FileDescriptor listening_socket);
  /// Asks for the next message of a client.
  void read_on(ClientId client);
  /// One call at a time for each client: the next after WebEvents::sent.
  void send(ClientId client, std::vector<Frame> frames);
  /// Says why, as far as a closing frame has room.
  void close(ClientId client, const std::string& why);

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace tocsin::foxglove
