// SPDX-License-Identifier: Apache-2.0
// What a router refuses of a peer's services, and how much of them it takes.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "call_link_fixture.hpp"
#include "runtime/middleware/refused_names.hpp"

namespace tocsin {
namespace {

using ::testing::IsEmpty;

using CallBoundsTest = CallLinkTest;

TEST_F(CallBoundsTest, WhatTheRulesDoNotNameIsCountedAsRefused) {
  begin_as(Role::uxv);
  const auto before = refused_names().total();
  CallMessage message = call(station, 1, false, question);
  message.service("self_destruct");
  hear(peer_calls, message);
  hear_of({dock}, {{"self_destruct", "std_srvs/srv/Trigger"}});  // this side has no server to call
  EXPECT_EQ(refused_names().total() - before, 3U);
  EXPECT_THAT(script_.services.served, IsEmpty());
}

TEST_F(CallBoundsTest, OfManyNamesEndsAreMadeAFewATickAndNotOfAll) {
  begin_as(Role::uxv);
  std::vector<HostService> wanted;
  for (int i = 0; i < 700; ++i) {
    wanted.push_back({"n" + std::to_string(i) + "/get_parameters", "rcl_interfaces/srv/Get"});
  }
  hear_of({}, wanted);
  EXPECT_LE(script_.services.called.size(), 8U);
  run(5);
  EXPECT_EQ(script_.services.called.size(), 256U);
  hear_of({}, {dock});
  EXPECT_EQ(script_.services.called.size(), 1U);
}

TEST_F(CallBoundsTest, HundredsOfNamesDoNotDisplaceWhatTheFileNames) {
  begin_as(Role::uxv);
  hear_of({}, {dock});
  EXPECT_EQ(script_.services.called.count("dock"), 1U);
  std::vector<HostService> wanted{dock};
  for (int i = 0; i < 700; ++i) {
    wanted.push_back({"a" + std::to_string(i) + "/get_parameters", "rcl_interfaces/srv/Get"});
  }
  hear_of({}, wanted);
  run(5);
  EXPECT_EQ(script_.services.called.count("dock"), 1U);
}

}  // namespace
}  // namespace tocsin
