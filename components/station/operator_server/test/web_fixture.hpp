// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <condition_variable>
#include <cstdlib>
#include <mutex>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "listening_socket.hpp"
#include "web_server.hpp"

namespace tocsin::foxglove {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;

/// What the server has told of its connections.
class Heard {
 public:
  WebEvents events() {
    WebEvents made;
    made.opened = [this](ClientId client, const WebPeer&) { add("opened", client); };
    made.received = [this](ClientId client, Frame::Kind, std::string&& bytes) {
      add("received " + bytes, client);
    };
    made.sent = [this](ClientId client) { add("sent", client); };
    made.closed = [this](ClientId client, const std::string&) { add("closed", client); };
    made.refused = [this](const std::string& what) { add("refused " + what, 0); };
    return made;
  }
  /// The client of the first event with these words, once it came.
  std::optional<ClientId> wait_for(const std::string& words) {
    std::unique_lock<std::mutex> lock(mutex_);
    std::optional<ClientId> found;
    changed_.wait_for(lock, std::chrono::seconds(10), [&] {
      for (const auto& [text, client] : all_) {
        if (!found && text.find(words) == 0) found = client;
      }
      return found.has_value();
    });
    return found;
  }

 private:
  void add(const std::string& text, ClientId client) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      all_.emplace_back(text, client);
    }
    changed_.notify_all();
  }
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::pair<std::string, ClientId>> all_;
};

class WebServerTest : public ::testing::Test {
 protected:
  WebServerTest() {
    settings_.access.address = "127.0.0.1";
    settings_.request_s = 0.3;
  }
  void start() {
    auto listening = open_listening_socket("127.0.0.1", 0);
    port_ = listening.port;
    sut_ = std::make_unique<WebServer>(settings_, heard_.events());
    sut_->start(std::move(listening.socket));
  }
  [[nodiscard]] tcp::endpoint endpoint() const {
    return {asio::ip::make_address("127.0.0.1"), static_cast<std::uint16_t>(port_)};
  }
  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(port_); }
  tcp::socket connect() {
    tcp::socket socket(io_);
    socket.connect(endpoint());
    return socket;
  }
  /// Blocks until the other end closes; what it said before.
  static std::string rest_of(tcp::socket& socket) {
    std::string text;
    std::array<char, 4096> part{};
    boost::system::error_code error;
    while (!error) text.append(part.data(), socket.read_some(asio::buffer(part), error));
    return text;
  }
  /// A certificate of its own for 127.0.0.1; false when there is no openssl.
  bool make_certificate() {
    settings_.certificate = folder_.path("certificate.pem");
    settings_.key = folder_.path("key.pem");
    settings_.access.encrypted = true;
    const std::string command =
        "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 "
        "-subj /CN=station -keyout " +
        settings_.key + " -out " + settings_.certificate + " 2>/dev/null";
    return std::system(command.c_str()) == 0;
  }
  const TemporaryFolder folder_;
  Heard heard_;
  WebSettings settings_;
  int port_ = 0;
  asio::io_context io_;
  std::unique_ptr<WebServer> sut_;
};

inline http::request<http::empty_body> request_for(const std::string& host, const char* target) {
  http::request<http::empty_body> request{http::verb::get, target, 11};
  request.set(http::field::host, host);
  return request;
}

}  // namespace tocsin::foxglove
