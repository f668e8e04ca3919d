// SPDX-License-Identifier: Apache-2.0
#include "operator_server/access.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin::foxglove {
namespace {

using ::testing::HasSubstr;
constexpr const char* secret = "0123456789abcdef";

AccessRules open_rules() { return {"127.0.0.1"}; }
AccessRules guarded_rules() { return {"0.0.0.0", {{secret}}, true}; }

RequestFacts socket_request() {
  RequestFacts request;
  request.method = "GET";
  request.target = "/";
  request.host = "127.0.0.1:8765";
  request.protocols = "foxglove.websocket.v1";
  request.wants_socket = true;
  return request;
}

unsigned status_of(const Verdict& verdict) {
  const auto* const refusal = std::get_if<Refuse>(&verdict);
  return refusal == nullptr ? 200 : refusal->status;
}

std::string fault_of(const AccessRules& rules) {
  try {
    check_access("server", rules);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(AccessTest, BeyondLoopbackATokenAndTlsAreNeeded) {
  EXPECT_EQ(fault_of({"127.0.0.1"}), "none");
  EXPECT_EQ(fault_of({"127.3.2.1"}), "none");
  EXPECT_EQ(fault_of({"::1"}), "none");
  EXPECT_EQ(fault_of(guarded_rules()), "none");
  EXPECT_THAT(fault_of({"0.0.0.0"}), HasSubstr("server.address: 0.0.0.0 is heard beyond"));
  EXPECT_THAT(fault_of({"192.168.1.2", {{secret}}, false}), HasSubstr("certificate and key"));
  EXPECT_THAT(fault_of({"192.168.1.2", {}, true}), HasSubstr("needs token_file"));
}

TEST(AccessTest, TakesTheNewerOfTheProtocolsThatAreOffered) {
  RequestFacts request = socket_request();
  EXPECT_EQ(std::get<OpenSocket>(judge(open_rules(), request)).protocol, "foxglove.websocket.v1");
  request.protocols = "foxglove.websocket.v1, foxglove.sdk.v1";
  EXPECT_EQ(std::get<OpenSocket>(judge(open_rules(), request)).protocol, "foxglove.sdk.v1");
  for (const char* other : {"", "mqtt", "foxglove.sdk.v11", ","}) {
    request.protocols = other;
    EXPECT_EQ(status_of(judge(open_rules(), request)), 400U) << other;
  }
}

TEST(AccessTest, APageOfAnotherOriginIsRefused) {
  RequestFacts request = socket_request();
  request.origin = "http://127.0.0.1:8765";
  EXPECT_EQ(status_of(judge(open_rules(), request)), 200U);
  for (const char* other : {"https://evil.example", "null", "http://127.0.0.1:8766",
                            "https://127.0.0.1:8765", "http://localhost:8765"}) {
    request.origin = other;
    EXPECT_EQ(status_of(judge(open_rules(), request)), 403U) << other;
  }
  AccessRules rules = open_rules();
  rules.origins = {"https://app.foxglove.dev"};
  request.origin = "https://app.foxglove.dev";
  EXPECT_EQ(status_of(judge(rules, request)), 200U);
  rules.origins = {"*"};
  request.origin = "null";
  EXPECT_EQ(status_of(judge(rules, request)), 200U);
}

TEST(AccessTest, ANameThatWasMadeToLeadHereIsRefused) {
  RequestFacts request = socket_request();
  for (const char* own : {"localhost", "localhost:8765", "127.0.0.1", "[::1]:8765", "[::1]"}) {
    request.host = own;
    EXPECT_EQ(status_of(judge(open_rules(), request)), 200U) << own;
  }
  for (const char* other : {"evil.example:8765", "", "localhost.evil.example", "[::2]:8765"}) {
    request.host = other;
    request.origin = std::string("http://") + other;
    EXPECT_EQ(status_of(judge(open_rules(), request)), 403U) << other;
  }
}

TEST(AccessTest, ARoleIsThatOfTheTokenOrOfAllWhereThereIsNone) {
  AccessRules rules = guarded_rules();
  rules.tokens.push_back({"supervisor-0123456789", UserRole::supervisor});
  rules.role = UserRole::observer;  // of nobody: there are tokens
  RequestFacts request = socket_request();
  request.host = "station.example";
  request.target = std::string("/?token=") + secret;
  EXPECT_EQ(std::get<OpenSocket>(judge(rules, request)).role, UserRole::driver);
  request.target = "/?token=supervisor-0123456789";
  EXPECT_EQ(std::get<OpenSocket>(judge(rules, request)).role, UserRole::supervisor);
  rules = open_rules();
  rules.role = UserRole::observer;
  EXPECT_EQ(std::get<OpenSocket>(judge(rules, socket_request())).role, UserRole::observer);
}

TEST(AccessTest, ATokenIsTakenFromTheTargetOrTheHeader) {
  RequestFacts request = socket_request();
  request.host = "station.example";
  EXPECT_EQ(status_of(judge(guarded_rules(), request)), 401U);
  for (const char* good : {"/?token=0123456789abcdef", "/x?a=b&token=0123456789abcdef&c=d"}) {
    request.target = good;
    EXPECT_EQ(status_of(judge(guarded_rules(), request)), 200U) << good;
  }
  for (const char* bad : {"/?token=0123456789abcdeg", "/?token=0123456789abcdef0",
                          "/?token=", "/?xtoken=0123456789abcdef", "/token=0123456789abcdef"}) {
    request.target = bad;
    EXPECT_EQ(status_of(judge(guarded_rules(), request)), 401U) << bad;
  }
  request.authorization = "Bearer 0123456789abcdef";
  EXPECT_EQ(status_of(judge(guarded_rules(), request)), 200U);
  request.authorization = "Basic 0123456789abcdef";
  EXPECT_EQ(status_of(judge(guarded_rules(), request)), 401U);
}

TEST(AccessTest, FilesAreBelowThePageAndNeedNoToken) {
  RequestFacts request;
  request.method = "GET";
  const auto path_of = [&](const char* target) -> std::string {
    request.target = target;
    const Verdict verdict = judge(guarded_rules(), request);
    const auto* const file = std::get_if<ServeFile>(&verdict);
    return file == nullptr ? std::to_string(std::get<Refuse>(verdict).status) : file->path;
  };
  EXPECT_EQ(path_of("/"), "index.html");
  EXPECT_EQ(path_of("/?token=x"), "index.html");
  EXPECT_EQ(path_of("/assets/app.js?v=1"), "assets/app.js");
  for (const char* bad : {"/../secret", "/a/../../b", "/.git/config", "//etc/passwd", "/%2e%2e/a",
                          "/a\\b", "/a//b"}) {
    EXPECT_EQ(path_of(bad), "404") << bad;
  }
  EXPECT_EQ(path_of("index.html"), "400");
  request.method = "POST";
  EXPECT_EQ(path_of("/"), "405");
}

TEST(AccessTest, FilesHaveTheirTypes) {
  EXPECT_STREQ(content_type("index.html"), "text/html; charset=utf-8");
  EXPECT_STREQ(content_type("a.b.js"), "text/javascript; charset=utf-8");
  EXPECT_STREQ(content_type("noending"), "application/octet-stream");
}

RequestFacts request_for(const std::string& target) {
  RequestFacts request;
  request.method = "GET";
  request.target = target;
  request.host = "127.0.0.1:8765";
  return request;
}

TEST(AccessTest, RecordingsAndWhatIfAreOfTheRunAndNotOfThePage) {
  const AccessRules rules = open_rules();
  EXPECT_TRUE(std::holds_alternative<ListBags>(judge(rules, request_for("/bags?x=1"))));
  EXPECT_EQ(std::get<ServeBag>(judge(rules, request_for("/bags/gcs/bag/bag_0.mcap"))).path,
            "gcs/bag/bag_0.mcap");
  EXPECT_EQ(std::get<AskWhatIf>(judge(rules, request_for("/what_if?host=uxv&policy=tocp"))).query,
            "host=uxv&policy=tocp");
  for (const char* target : {"/bags/", "/bags/../x.mcap", "/bags//etc/x.mcap", "/bags/.git/x.mcap",
                             "/bags/%2e%2e/x.mcap"}) {
    EXPECT_EQ(status_of(judge(rules, request_for(target))), 404U) << target;
  }
  EXPECT_EQ(std::get<ServeTable>(judge(rules, request_for("/tables/location.csv"))).topic,
            "location");
  for (const char* target : {"/tables/", "/tables/messages.csv", "/tables/../location.csv"}) {
    EXPECT_EQ(status_of(judge(rules, request_for(target))), 404U) << target;
  }
  RequestFacts post = request_for("/bags");
  post.method = "POST";
  EXPECT_EQ(status_of(judge(rules, post)), 405U);
}

TEST(AccessTest, WhatIsOfTheRunNeedsTheTokenAndOurOwnPage) {
  for (const std::string target :
       {"/bags", "/bags/bag_0.mcap", "/tables/location.csv", "/what_if"}) {
    RequestFacts request = request_for(target);
    EXPECT_EQ(status_of(judge(guarded_rules(), request)), 401U) << target;
    request.target = target + "?token=" + secret;
    EXPECT_EQ(status_of(judge(guarded_rules(), request)), 200U) << target;
    request.target = target + "?token=0123456789abcdeX";
    EXPECT_EQ(status_of(judge(guarded_rules(), request)), 401U) << target;
    request.target = target;
    request.authorization = std::string("Bearer ") + secret;
    EXPECT_EQ(status_of(judge(guarded_rules(), request)), 200U) << target;
    request.origin = "https://evil.example";
    EXPECT_EQ(status_of(judge(guarded_rules(), request)), 403U) << target;
    RequestFacts rebound = request_for(target);
    rebound.host = "evil.example:8765";
    EXPECT_EQ(status_of(judge(open_rules(), rebound)), 403U) << target;
  }
}

TEST(AccessTest, AQueryIsReadByItsKeys) {
  const auto values = query_values("a=1&b=&=3&c&a=2&d=x=y&");
  EXPECT_EQ(values.size(), 4U);
  EXPECT_EQ(values.at("a"), "2");
  EXPECT_EQ(values.at("b"), "");
  EXPECT_EQ(values.at("c"), "");
  EXPECT_EQ(values.at("d"), "x=y");
  EXPECT_TRUE(query_values("").empty());
}

}  // namespace
}  // namespace tocsin::foxglove
