// SPDX-License-Identifier: Apache-2.0
// HTTP, WebSocket and TLS alone, without a component behind them.
#include "web_server.hpp"

#include <gmock/gmock.h>
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

namespace tocsin::foxglove {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using ::testing::HasSubstr;

/// What the server has told of its connections.
class Heard {
 public:
  WebEvents events() {
    WebEvents made;
    made.opened = [this](ClientId client, const std::string&) { add("opened", client); };
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

http::request<http::empty_body> request_for(const std::string& host, const char* target) {
  http::request<http::empty_body> request{http::verb::get, target, 11};
  request.set(http::field::host, host);
  return request;
}

TEST_F(WebServerTest, SendsAndReceivesMessages) {
  start();
  websocket::stream<tcp::socket> client(connect());
  client.set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
    request.set(http::field::sec_websocket_protocol, "foxglove.websocket.v1");
  }));
  client.handshake(host(), "/any/path");
  const auto id = heard_.wait_for("opened");
  ASSERT_TRUE(id);
  client.write(asio::buffer(std::string("hello")));
  EXPECT_TRUE(heard_.wait_for("received hello"));
  client.write(asio::buffer(std::string("again")));
  sut_->read_on(*id);
  EXPECT_TRUE(heard_.wait_for("received again"));
  const auto payload = std::make_shared<const std::vector<std::uint8_t>>(3, std::uint8_t{'x'});
  sut_->send(*id, {{Frame::Kind::text, "one", nullptr}, {Frame::Kind::binary, "two ", payload}});
  beast::flat_buffer buffer;
  client.read(buffer);
  EXPECT_TRUE(client.got_text());
  EXPECT_EQ(beast::buffers_to_string(buffer.data()), "one");
  buffer.clear();
  client.read(buffer);
  EXPECT_TRUE(client.got_binary());
  EXPECT_EQ(beast::buffers_to_string(buffer.data()), "two xxx");
  EXPECT_TRUE(heard_.wait_for("sent"));
}

TEST_F(WebServerTest, SaysWhyItClosesAClient) {
  start();
  websocket::stream<tcp::socket> client(connect());
  client.set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
    request.set(http::field::sec_websocket_protocol, "foxglove.sdk.v1");
  }));
  client.handshake(host(), "/");
  sut_->close(heard_.wait_for("opened").value_or(0), "it does not read");
  beast::flat_buffer buffer;
  boost::system::error_code error;
  client.read(buffer, error);
  EXPECT_EQ(error, websocket::error::closed);
  EXPECT_EQ(std::string(client.reason().reason.c_str()), "it does not read");
  EXPECT_TRUE(heard_.wait_for("closed"));
}

TEST_F(WebServerTest, AnswersSeveralRequestsOnOneConnection) {
  (void)folder_.write("page/index.html", "page");
  settings_.page = folder_.path("page");
  start();
  tcp::socket socket = connect();
  beast::flat_buffer buffer;
  for (int i = 0; i < 3; ++i) {
    http::write(socket, request_for(host(), "/"));
    http::response<http::string_body> response;
    http::read(socket, buffer, response);
    EXPECT_EQ(response.body(), "page");
  }
}

TEST_F(WebServerTest, WhoAsksNothingIsClosed) {
  start();
  tcp::socket silent = connect();
  tcp::socket slow = connect();
  asio::write(slow, asio::buffer(std::string("GET / HTTP/1.1\r\nHost: ")));
  EXPECT_EQ(rest_of(silent), "");
  EXPECT_EQ(rest_of(slow), "");
}

TEST_F(WebServerTest, WhatIsNoHttpIsClosed) {
  start();
  tcp::socket socket = connect();
  asio::write(socket, asio::buffer(std::string("\x16\x03\x01 no request\r\n\r\n")));
  EXPECT_EQ(rest_of(socket), "");
}

TEST_F(WebServerTest, HundredsOfConnectionsLeaveRoomForThoseThatCameFirst) {
  settings_.request_s = 60;
  settings_.most_connections = 50;
  start();
  tcp::socket first = connect();
  std::vector<tcp::socket> many;
  for (int i = 0; i < 800; ++i) many.push_back(connect());
  EXPECT_TRUE(heard_.wait_for("refused more than 50 connections"));
  EXPECT_EQ(rest_of(many.back()), "");
  beast::flat_buffer buffer;
  http::write(first, request_for(host(), "/"));
  http::response<http::string_body> response;
  http::read(first, buffer, response);
  EXPECT_EQ(response.result_int(), 404U);
}

TEST_F(WebServerTest, EndsWithConnectionsOpen) {
  start();
  tcp::socket socket = connect();
  websocket::stream<tcp::socket> client(connect());
  client.set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
    request.set(http::field::sec_websocket_protocol, "foxglove.sdk.v1");
  }));
  client.handshake(host(), "/");
  sut_.reset();
  beast::flat_buffer buffer;
  boost::system::error_code error;
  client.read(buffer, error);
  EXPECT_TRUE(error);
}

TEST_F(WebServerTest, SpeaksTls) {
  if (!make_certificate()) GTEST_SKIP() << "there is no openssl";
  settings_.request_s = 10;
  start();
  asio::ssl::context context(asio::ssl::context::tls_client);
  beast::ssl_stream<tcp::socket> stream(connect(), context);
  stream.handshake(asio::ssl::stream_base::client);
  http::write(stream, request_for(host(), "/"));
  beast::flat_buffer buffer;
  http::response<http::string_body> response;
  http::read(stream, buffer, response);
  EXPECT_THAT(response.body(), HasSubstr("operator_page"));
  tcp::socket plain = connect();
  http::write(plain, request_for(host(), "/"));
  EXPECT_EQ(rest_of(plain).find("HTTP"), std::string::npos) << "plain HTTP is not answered";
}

TEST_F(WebServerTest, OpensASocketOverTls) {
  if (!make_certificate()) GTEST_SKIP() << "there is no openssl";
  settings_.request_s = 10;
  start();
  asio::ssl::context context(asio::ssl::context::tls_client);
  websocket::stream<beast::ssl_stream<tcp::socket>> client(connect(), context);
  client.next_layer().handshake(asio::ssl::stream_base::client);
  client.set_option(websocket::stream_base::decorator([this](websocket::request_type& request) {
    request.set(http::field::sec_websocket_protocol, "foxglove.sdk.v1");
    request.set(http::field::origin, "https://" + host());
  }));
  client.handshake(host(), "/");
  const auto id = heard_.wait_for("opened");
  ASSERT_TRUE(id);
  sut_->send(*id, {{Frame::Kind::text, "hello", nullptr}});
  beast::flat_buffer buffer;
  client.read(buffer);
  EXPECT_EQ(beast::buffers_to_string(buffer.data()), "hello");
}

TEST_F(WebServerTest, ACertificateWithoutItsKeyIsAConfigError) {
  if (!make_certificate()) GTEST_SKIP() << "there is no openssl";
  settings_.key = settings_.certificate;
  EXPECT_THROW(start(), ConfigError);
}

}  // namespace
}  // namespace tocsin::foxglove
