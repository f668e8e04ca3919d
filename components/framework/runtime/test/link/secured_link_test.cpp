// SPDX-License-Identifier: Apache-2.0
// Two routers with identities, and those who have none, by real UDP on loopback.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>

#include "fast_dds/rtps_capture.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "keystore/keystore.hpp"
#include "link/link_bus_fixture.hpp"
#include "link/unchecked_writers.hpp"
#include "runtime/testing/forger.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SecuredLinkTest : public LinkBusFixture {
 protected:
  SecuredLinkTest() : LinkBusFixture(next_domain()) {
    make_keystore("keystore");
    keystore::add(store("keystore"), {"spy", {{}, {"rt/*"}}}, std::time(nullptr));
  }
  void make_keystore(const std::string& name) const {
    keystore::create(store(name), std::time(nullptr));
    keystore::add(store(name), {"uxv", {{"rt/location", "rt/camera/*"}, {"rt/goal"}}},
                  std::time(nullptr));
    keystore::add(store(name), {"gcs", {{"rt/goal"}, {"rt/location", "rt/camera/*"}}},
                  std::time(nullptr));
  }
  [[nodiscard]] std::string store(const std::string& name) const {
    return folder_.path() + "/" + name;
  }
  [[nodiscard]] BusOptions secured(Role role, const std::string& identity = "",
                                   const std::string& keystore = "keystore") const {
    BusOptions secured = options(role);
    secured.enclave =
        store(keystore) + "/enclaves/" + (identity.empty() ? to_string(role) : identity);
    return secured;
  }
  /// A router of the vehicle that the station must not hear: its samples do not cross, neither is
  /// it a peer, while a vehicle with a good identity is heard.
  void expect_not_heard(const BusOptions& stranger_options,
                        const std::vector<std::string>& peer_names = {}) {
    BusOptions station = secured(Role::gcs);
    station.peer_names = peer_names;
    Relay gcs(station);
    const Relay stranger(stranger_options);
    const auto vehicle = process(Role::uxv);
    const auto writer = vehicle->advertise(endpoint<topic::Location>());
    for (int i = 0; i < 100; ++i) {  // as long as it takes those who are let in, ten times
      (void)writer->write(std::make_shared<const topic::Location::Message>());
      std::this_thread::sleep_for(milliseconds(10));
    }
    EXPECT_THAT(gcs.crossed(), IsEmpty());
    EXPECT_THAT(gcs.peers(), IsEmpty());
    const Relay good(secured(Role::uxv));
    EXPECT_TRUE(eventually([&] {
      (void)writer->write(std::make_shared<const topic::Location::Message>());
      std::this_thread::sleep_for(milliseconds(5));
      return !gcs.crossed().empty();
    }));
    EXPECT_THAT(gcs.peers(), ElementsAre("uxv"));
  }

 private:
  static int next_domain() {
    constexpr int first = 200;  // three domains each, of which a keystore allows up to 230
    static int tests = 0;
    return first + 3 * (tests++ % 10);
  }
  const TemporaryFolder folder_;
};

TEST_F(SecuredLinkTest, ASampleCrossesBetweenTwoWhoAreLetIn) {
  Relay uxv(secured(Role::uxv));
  Relay gcs(secured(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::Location>(), there);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  ASSERT_TRUE(write_until_heard<topic::Location>(*writer, there));
  EXPECT_THAT(gcs.peers(), ElementsAre("uxv"));
  EXPECT_THAT(uxv.peers(), ElementsAre("gcs"));
}

TEST_F(SecuredLinkTest, APictureCrossesInPacketsOfAtMost1400BytesThatNobodyElseCanRead) {
  RtpsCapture capture;
  if (!capture.ok()) GTEST_SKIP() << "no packet socket: CAP_NET_RAW is needed";
  const Relay uxv(secured(Role::uxv));
  Relay gcs(secured(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::CameraImage>(), there);
  const auto writer = vehicle->advertise(endpoint<topic::CameraImage>());
  const auto image = std::make_shared<topic::CameraImage::Message>();
  image->data().assign(30'000, 0x5a);
  ASSERT_TRUE(eventually([&] {
    (void)writer->write(image);
    std::this_thread::sleep_for(milliseconds(20));
    return !there.all().empty();
  }));
  const auto arrived =
      std::static_pointer_cast<const topic::CameraImage::Message>(there.all().front().message);
  EXPECT_EQ(arrived->data(), image->data());
  const int port = 7400 + 250 * options(Role::uxv).link_domain;
  std::size_t large = 0;
  for (const CapturedSubmessage& one : capture.take()) {
    if (one.port < port || one.port >= port + 250) continue;
    EXPECT_LE(one.packet_bytes, 1428U);
    EXPECT_NE(one.kind, 0x16) << "a piece in fragments";
    if (one.packet_bytes > 1000) ++large;
  }
  EXPECT_GE(large, 31 * there.all().size()) << "in pieces of one packet each";
}

TEST_F(SecuredLinkTest, WhoHasNoIdentityIsNotHeard) { expect_not_heard(options(Role::uxv)); }

TEST_F(SecuredLinkTest, ALinkToOneVehicleTakesNothingOfAnotherThatHasItsName) {
  keystore::add(store("keystore"), {"uxv2", {{"rt/location", "rt/camera/*"}, {"rt/goal"}}},
                std::time(nullptr));
  expect_not_heard(secured(Role::uxv, "uxv2"), {"uxv"});
}

TEST_F(SecuredLinkTest, ALinkToOneVehicleTakesItsStopAndNotThatOfAnother) {
  keystore::add(store("keystore"), {"uxv2", {{"rt/location"}, {"rt/goal"}}}, std::time(nullptr));
  BusOptions station = secured(Role::gcs);
  station.peer_names = {"uxv"};
  const Relay gcs(station);
  StopValue value;
  value.number = 5;
  {
    Relay stranger(secured(Role::uxv, "uxv2"));
    stranger.say_stop(value);
    std::this_thread::sleep_for(milliseconds(1500));  // a tenth of it is enough for the other
    EXPECT_EQ(gcs.stop_number(), 0U);
  }
  value.number = 7;
  Relay vehicle(secured(Role::uxv));
  vehicle.say_stop(value);
  EXPECT_TRUE(eventually([&] { return gcs.stop_number() == 7; }));
}

TEST_F(SecuredLinkTest, AnIdentityOfAnotherAuthorityIsNotHeard) {
  make_keystore("other");
  expect_not_heard(secured(Role::uxv, "uxv", "other"));
}

TEST_F(SecuredLinkTest, ARevokedIdentityIsNotHeard) {
  keystore::add(store("keystore"), {"stolen", {{"rt/*"}, {"rt/*"}}}, std::time(nullptr));
  const std::string copy = store("copy/enclaves");  // of before, which knows of no revocation
  fs::create_directories(copy);
  fs::copy(store("keystore") + "/enclaves/stolen", copy + "/stolen", fs::copy_options::recursive);
  keystore::revoke(store("keystore"), "stolen", std::time(nullptr));
  expect_not_heard(secured(Role::uxv, "stolen", "copy"));
}

TEST_F(SecuredLinkTest, WhoMayOnlyListenWritesNothing) {
  Relay gcs(secured(Role::gcs));
  Relay spy(secured(Role::uxv, "spy"));
  const auto vehicle = process(Role::uxv);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  ASSERT_TRUE(eventually([&] { return !gcs.peers().empty(); })) << "it is one of ours";
  for (int i = 0; i < 50; ++i) {
    (void)writer->write(std::make_shared<const topic::Location::Message>());
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_THAT(gcs.crossed(), IsEmpty());
  EXPECT_THAT(gcs.peer_flows(), IsEmpty());
}

TEST_F(SecuredLinkTest, WhatAnIdentityMayNotWriteItsReceiverRefuses) {
  keystore::add(store("keystore"), {"second", {{"rt/location"}, {"rt/*"}}}, std::time(nullptr));
  const UncheckedWriters its_library;
  const Relay gcs(secured(Role::gcs));
  const Relay second(secured(Role::uxv, "second"));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  Samples pictures;
  const auto far = station->subscribe(endpoint<topic::Location>(), there);
  const auto far_pictures = station->subscribe(endpoint<topic::CameraImage>(), pictures);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  const auto camera = vehicle->advertise(endpoint<topic::CameraImage>());
  ASSERT_TRUE(write_until_heard<topic::Location>(*writer, there));
  for (int i = 0; i < 50; ++i) {
    (void)camera->write(std::make_shared<const topic::CameraImage::Message>());
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_THAT(pictures.all(), IsEmpty());
}

TEST_F(SecuredLinkTest, WhatIsForgedInThePeersNameChangesNothing) {
  const Forger forger(options(Role::uxv).link_domain);
  if (!forger.ok()) GTEST_SKIP() << "no raw socket: CAP_NET_RAW is needed";
  Relay uxv(secured(Role::uxv));
  Relay gcs(secured(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::Location>(), there);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  ASSERT_TRUE(write_until_heard<topic::Location>(*writer, there));
  const auto victim = forger.overhear("uxv");
  ASSERT_TRUE(victim);
  for (int i = 0; i < 10; ++i) {
    forger.send(Forger::departure_of(*victim), victim->port);
    forger.send(Forger::with_lease(*victim, 0), victim->port);
    std::this_thread::sleep_for(milliseconds(50));
  }
  EXPECT_EQ(gcs.lost_peers(), 0);
  const std::size_t before = there.all().size();
  ASSERT_TRUE(eventually([&] {
    (void)writer->write(std::make_shared<const topic::Location::Message>());
    std::this_thread::sleep_for(milliseconds(5));
    return there.all().size() > before + 10;
  }));
}

TEST_F(SecuredLinkTest, MessagesOfAuthenticationGoToTheirAddresseeOnly) {
  constexpr std::uint32_t strangers = 16;
  const Forger forger(options(Role::uxv).link_domain);
  if (!forger.ok()) GTEST_SKIP() << "no raw socket: CAP_NET_RAW is needed";
  Relay uxv(secured(Role::uxv));  // at the port that the forger sends to
  ASSERT_TRUE(eventually([&] { return uxv.packets().packets > 0; }));
  const Relay gcs(secured(Role::gcs));
  ASSERT_TRUE(eventually([&] { return !uxv.peers().empty(); }));
  const auto victim = forger.overhear("gcs");
  ASSERT_TRUE(victim);
  const auto before = uxv.packets().discovery_bytes;
  const auto sent = [&] { return uxv.packets().discovery_bytes - before; };
  for (std::uint32_t number = 1; number <= strangers; ++number) {
    forger.send(Forger::stranger_like(*victim, number), forger.port());
    std::this_thread::sleep_for(milliseconds(20));
  }
  ASSERT_TRUE(eventually([&] { return sent() > strangers * 4'000; }));
  std::this_thread::sleep_for(milliseconds(500));
  EXPECT_LT(sent(), strangers * 40'000)
      << "of 4 kB each, some repeated; to everybody they would be sixteen times as many";
}

TEST_F(SecuredLinkTest, AnIdentityThatTakesTheStationsNameDoesNotDisplaceIt) {
  Relay uxv(secured(Role::uxv));
  const Relay gcs(secured(Role::gcs));
  ASSERT_TRUE(eventually([&] { return uxv.peers().size() == 1; }));
  BusOptions impostor = secured(Role::uxv, "spy");
  impostor.host = "gcs";
  const Relay spy(impostor);
  ASSERT_TRUE(eventually([&] { return uxv.peers().size() == 2; }));
  EXPECT_THAT(uxv.peers(), ElementsAre("gcs", ::testing::StartsWith("gcs_of_")));
  EXPECT_EQ(uxv.lost_peers(), 0);
}

TEST_F(SecuredLinkTest, AnIdentityThatNobodyWouldAcceptEndsTheStartWithItsReason) {
  BusOptions broken = secured(Role::uxv);
  fs::remove(broken.enclave + "/permissions.p7s");
  try {
    (void)make_fast_dds_link_bus(broken, [] {});
    FAIL() << "nothing was thrown";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("permissions.p7s: cannot be read"));
  }
}

}  // namespace
}  // namespace tocsin
