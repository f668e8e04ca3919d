// SPDX-License-Identifier: Apache-2.0
// HTTP, WebSocket and TLS alone, without a component behind them.
#include "web_server.hpp"

#include <gmock/gmock.h>

#include <utility>

#include "bag/bag_writer.hpp"
#include "idl_support/encode.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"
#include "web_fixture.hpp"

namespace tocsin::foxglove {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(WebServerTest, GivesTheTablesOfThisHostsRecorderWhileItRecords) {
  settings_.recorded = folder_.path();
  bag::BagWriter writer(folder_.path("bag"), {});
  using State = tocsin_msgs::msg::TransmissionState;
  const auto number = writer.add(bag::make_topic("rt/transmission_state", type_info<State>().name));
  State state;
  state.role("uxv");
  const auto bytes = encode(type_info<State>(), &state);
  (void)writer.write(number, {1, 2'000'000'000, 1'000'000'000, bytes.data(), bytes.size()});
  (void)writer.flush();
  settings_.request_s = 10;
  start();
  tcp::socket socket = connect();
  beast::flat_buffer buffer;
  const auto answer = [&](const char* target) {
    http::write(socket, request_for(host(), target));
    http::response<http::string_body> response;
    http::read(socket, buffer, response);
    return response;
  };
  EXPECT_THAT(answer("/tables/transmission_state.csv").body(),
              AllOf(StartsWith("receive_s,send_s,"), HasSubstr("\n2.000000000,1.000000000,1,")));
  EXPECT_EQ(answer("/tables/location.csv").body(), "") << "none was recorded";
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

/// A recording decided again by a tool of the test's own.
class WhatIfAnswerTest : public WebServerTest {
 protected:
  WhatIfAnswerTest() {
    (void)folder_.write("gcs/bag/bag_0.mcap", "");
    settings_.recorded = folder_.path("gcs");
  }
  /// The answer of a server whose tool is this script; status and body.
  std::pair<unsigned, std::string> ask(const std::string& script, const std::string& query) {
    settings_.decide = folder_.write_program("decide", script);
    start();
    tcp::socket client(connect());
    http::write(client, request_for(host(), ("/what_if?" + query).c_str()));
    beast::flat_buffer buffer;
    http::response<http::string_body> response;
    http::read(client, buffer, response);
    return {response.result_int(), response.body()};
  }
};

TEST_F(WhatIfAnswerTest, IsWhatTheToolPrints) {
  const auto [status, body] = ask("echo \"{\\\"rows\\\": [], \\\"said\\\": \\\"$6 $7 $8\\\"}\"",
                                  "host=uxv&policy=tocp&alpha=3");
  EXPECT_EQ(status, 200U);
  EXPECT_EQ(body, R"({"rows":[],"said":"--policy tocp --set"})");
}

TEST_F(WhatIfAnswerTest, IsTheToolsReasonWhenItRefuses) {
  const auto [status, body] = ask("echo 'tocsin decide: no such policy' >&2; exit 2", "host=uxv");
  EXPECT_EQ(status, 400U);
  EXPECT_THAT(body, HasSubstr("tocsin decide: no such policy"));
}

TEST_F(WhatIfAnswerTest, AToolThatStillRunsEndsWithTheServer) {
  settings_.decide = folder_.write_program("decide", "sleep 600");
  start();
  tcp::socket client(connect());
  http::write(client, request_for(host(), "/what_if?host=uxv"));
  tcp::socket other(connect());
  http::write(other, request_for(host(), "/"));
  EXPECT_THAT(rest_of(other), HasSubstr("404")) << "others are served meanwhile";
  sut_.reset();  // within the test's time
}

}  // namespace
}  // namespace tocsin::foxglove
