// SPDX-License-Identifier: Apache-2.0
// A recording decided again, over HTTP, by a tool of the test's own.
#include <gmock/gmock.h>

#include <utility>

#include "web_fixture.hpp"

namespace tocsin::foxglove {
namespace {

using ::testing::HasSubstr;

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
