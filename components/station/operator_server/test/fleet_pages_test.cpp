// SPDX-License-Identifier: Apache-2.0
#include "operator_server/fleet_pages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "operator_server/access.hpp"

namespace tocsin::foxglove {
namespace {

using ::testing::HasSubstr;

TEST(FleetPagesTest, AreNamesAndAddresses) {
  const auto pages =
      fleet_pages("page", {"uxv1=http://127.0.0.1:8761/", "uxv2=https://station.example:443"});
  ASSERT_EQ(pages.size(), 2u);
  EXPECT_EQ(pages[0].origin, "http://127.0.0.1:8761");
  EXPECT_EQ(pages[1].url, "https://station.example:443/");
  EXPECT_EQ(fleet_text(pages), "uxv1=http://127.0.0.1:8761/ uxv2=https://station.example:443/");
  EXPECT_EQ(fleet_text({}), "");
}

TEST(FleetPagesTest, WhatIsNoneIsNamed) {
  for (const char* item : {"", "uxv1", "=http://a/", "uxv1=", "uxv1=ftp://a/", "uxv1=http://",
                           "uxv1=http:///x", "u 1=http://a/", "uxv1=http://a/ b"}) {
    try {
      static_cast<void>(fleet_pages("page", {item}));
      ADD_FAILURE() << item;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("page.fleet: '" + std::string(item) + "'"));
    }
  }
}

/// A page of the fleet may connect to each of its servers, one of another site to none.
TEST(FleetPagesTest, TheirOriginsAreLetIn) {
  AccessRules rules{"127.0.0.1"};
  for (const auto& page : fleet_pages("page", {"uxv1=http://127.0.0.1:8761/"})) {
    rules.origins.push_back(page.origin);
  }
  RequestFacts request;
  request.method = "GET";
  request.target = "/";
  request.host = "127.0.0.1:8762";
  request.protocols = "foxglove.sdk.v1";
  request.wants_socket = true;
  request.origin = "http://127.0.0.1:8761";
  EXPECT_TRUE(std::holds_alternative<OpenSocket>(judge(rules, request)));
  request.origin = "http://127.0.0.1:8799";
  EXPECT_TRUE(std::holds_alternative<Refuse>(judge(rules, request)));
}

}  // namespace
}  // namespace tocsin::foxglove
