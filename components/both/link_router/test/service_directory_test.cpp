// SPDX-License-Identifier: Apache-2.0
#include "link_router/service_directory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Duration patience = std::chrono::milliseconds(500);
const ServiceName dock{"dock", "std_srvs/srv/Trigger"};
const ServiceName parameters{"arm/set_parameters", "rcl_interfaces/srv/SetParameters"};
const ServiceName secret{"secret", "std_srvs/srv/Trigger"};

/// `dock` is named by the rules, `arm/...` fits a pattern of theirs.
Crossing rule(const std::string& name) {
  if (name == dock.name) return Crossing::always;
  return name.compare(0, 4, "arm/") == 0 ? Crossing::on_demand : Crossing::no;
}
Crossing nothing(const std::string&) { return Crossing::no; }

/// The directory of the host that has the servers, and of the one that calls them.
struct ServiceDirectoryTest : ::testing::Test {
  ServiceDirectory server{{rule, nothing}};
  ServiceDirectory client{{nothing, rule}};
  const Time t0{std::chrono::seconds(100)};
};

TEST_F(ServiceDirectoryTest, AServerThatTheRulesNameIsOfferedAndShownOnThePeersHost) {
  server.on_server(dock, true);
  EXPECT_THAT(server.announced(t0).offered, ElementsAre(dock));
  (void)client.on_peer(1, server.announced(t0));
  EXPECT_THAT(client.shown(t0), ElementsAre(dock));
  client.forget_peer(1);
  EXPECT_THAT(client.shown(t0), IsEmpty());
}

TEST_F(ServiceDirectoryTest, WhatNoRuleNamesIsNeitherOfferedNorWantedNorShownNorAsked) {
  server.on_server(secret, true);
  EXPECT_THAT(server.announced(t0).offered, IsEmpty());
  client.on_client(secret, true, t0);
  EXPECT_THAT(client.announced(t0 + patience).wanted, IsEmpty());
  (void)client.on_peer(1, {{secret}, {}});
  EXPECT_THAT(client.shown(t0 + patience), IsEmpty());
  (void)server.on_peer(1, {{}, {secret}});
  EXPECT_THAT(server.asked(), IsEmpty());
}

TEST_F(ServiceDirectoryTest, AClientIsWantingWhenNobodyOnItsHostHasBegunToServeForHalfASecond) {
  client.on_client(dock, true, t0);
  EXPECT_EQ(client.deadline(t0), t0 + patience);
  EXPECT_THAT(client.announced(t0 + patience - Duration(1)).wanted, IsEmpty());
  EXPECT_THAT(client.announced(t0 + patience).wanted, ElementsAre(dock));
  EXPECT_EQ(client.deadline(t0 + patience), never);
  client.on_client(dock, false, t0 + patience);
  EXPECT_THAT(client.announced(t0 + patience).wanted, IsEmpty());
}

TEST_F(ServiceDirectoryTest, WhatAPatternNamesIsOfferedAndShownToWhoWantsItOnly) {
  server.on_server(parameters, true);
  EXPECT_THAT(server.announced(t0).offered, IsEmpty());
  client.on_client(parameters, true, t0);
  (void)server.on_peer(1, client.announced(t0 + patience));
  EXPECT_THAT(server.announced(t0).offered, ElementsAre(parameters));
  (void)client.on_peer(2, server.announced(t0));
  EXPECT_THAT(client.shown(t0), IsEmpty()) << "the own host has its turn";
  EXPECT_THAT(client.shown(t0 + patience), ElementsAre(parameters));
  client.on_client(parameters, false, t0 + patience);
  EXPECT_THAT(client.shown(t0 + patience), IsEmpty());
}

TEST_F(ServiceDirectoryTest, WhatPeersOfferIsKnownBeforeSomebodyWantsItUnlessItIsServedHere) {
  (void)client.on_peer(1, {{dock, parameters, secret}, {}});
  EXPECT_THAT(client.offered_there(), ElementsAre(parameters.name, dock.name));
  client.on_server(dock, true);
  EXPECT_THAT(client.offered_there(), ElementsAre(parameters.name));
  client.forget_peer(1);
  EXPECT_THAT(client.offered_there(), IsEmpty());
}

TEST_F(ServiceDirectoryTest, AServerOnTheOwnHostGoesBeforeThoseOfThePeers) {
  client.on_client(dock, true, t0);
  (void)client.on_peer(1, {{dock}, {}});
  client.on_server(dock, true);
  EXPECT_THAT(client.shown(t0 + patience), IsEmpty());
  EXPECT_THAT(client.announced(t0 + patience).wanted, IsEmpty());
  client.on_server(dock, false);
  EXPECT_THAT(client.shown(t0 + patience), ElementsAre(dock));
}

TEST_F(ServiceDirectoryTest, OfAPeerTakesWhatTheRulesNameAndTellsWhatItRefuses) {
  EXPECT_THAT(client.on_peer(1, {{dock, secret}, {parameters}}),
              ElementsAre(parameters.name, secret.name));
  EXPECT_THAT(client.shown(t0), ElementsAre(dock));
}

TEST_F(ServiceDirectoryTest, OfAPeersNamesOnlySoManyAreTakenAndTold) {
  ServiceLists many;
  for (int i = 0; i < 700; ++i) many.wanted.insert({"arm/" + std::to_string(i), "a/srv/B"});
  EXPECT_EQ(server.on_peer(1, many).size(), 700 - ServiceDirectory::most_services);
  EXPECT_EQ(server.asked().size(), ServiceDirectory::most_services);
  for (const ServiceName& one : many.wanted) client.on_client(one, true, t0);
  EXPECT_EQ(client.announced(t0 + patience).wanted.size(), ServiceDirectory::most_services);
}

// `ros2 param` says "Node not found" before it calls anything.
TEST_F(ServiceDirectoryTest, ANodeOfWhichAPatternSpeaksIsKnownThereBeforeSomebodyCallsIt) {
  const ServiceName list{"arm/list_parameters", "rcl_interfaces/srv/ListParameters"};
  server.on_server(parameters, true);
  server.on_server(list, true);
  EXPECT_THAT(server.announced(t0).offered, ElementsAre(list));
  (void)client.on_peer(1, server.announced(t0));
  EXPECT_THAT(client.offered_there(), ElementsAre(list.name));
  EXPECT_THAT(client.shown(t0), IsEmpty());
  server.on_server(list, false);
  EXPECT_THAT(server.announced(t0).offered, IsEmpty());
}

TEST_F(ServiceDirectoryTest, HasChangedOnceAfterEachEventAndWhenAClientHasWaited) {
  EXPECT_TRUE(client.has_changed(t0));
  EXPECT_FALSE(client.has_changed(t0));
  client.on_client(dock, true, t0);
  EXPECT_TRUE(client.has_changed(t0));
  EXPECT_FALSE(client.has_changed(t0 + patience - Duration(1)));
  EXPECT_TRUE(client.has_changed(t0 + patience));
  EXPECT_FALSE(client.has_changed(t0 + patience));
  client.on_server(dock, true);
  EXPECT_TRUE(client.has_changed(t0 + patience));
  (void)client.on_peer(1, {{dock}, {}});
  EXPECT_TRUE(client.has_changed(t0 + patience));
  client.forget_peer(1);
  EXPECT_TRUE(client.has_changed(t0 + patience));
  EXPECT_FALSE(client.has_changed(t0 + 2 * patience));
}

}  // namespace
}  // namespace tocsin::router
