// SPDX-License-Identifier: Apache-2.0
// Participants with the default settings of their libraries on the domain of a host of ours.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <memory>

#include "peer_process.hpp"
#include "senders.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using std::chrono::steady_clock;
using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Not;
using Peers = std::vector<std::unique_ptr<PeerProcess>>;

void add(Peers& peers, const std::string& maker, int count, int domain) {
  static int number = 0;  // names are not used twice
  for (int i = 0; i < count; ++i) {
    peers.push_back(
        std::make_unique<PeerProcess>(maker, domain, maker + "_" + std::to_string(++number)));
  }
}

bool is_ours(const PeerProcess& peer) { return peer.name().rfind("tocsin", 0) == 0; }

/// "who does not hear whom", for each pair that is ours in part. How long others take to find each
/// other is their own affair: where Cyclone DDS cannot multicast, Fast DDS may need 9 s to find it.
std::vector<std::string> unheard(const Peers& peers) {
  std::vector<std::string> pairs;
  for (const auto& one : peers) {
    for (const auto& other : peers) {
      const bool matters = is_ours(*one) || is_ours(*other);
      if (matters && !one->has_heard(*other)) pairs.push_back(one->name() + " of " + other->name());
    }
  }
  return pairs;
}

constexpr seconds patience{10};
/// Longer than it takes those who may find each other.
constexpr seconds long_enough{2};
constexpr const char* of_fast_dds = "1.15";  // vendor ids, as the OMG lists them
constexpr const char* of_cyclone = "1.16";

/// What the machine is given: all that a busy one may need, or $TOCSIN_WITHIN_MS, 2000 on a quiet
/// one.
milliseconds limit() {
  const char* const text = std::getenv("TOCSIN_WITHIN_MS");
  return text == nullptr ? milliseconds(patience) : milliseconds(std::atoi(text));
}

/// Prints how long it took since the last of them was started.
void expect_all_hear_all(const Peers& peers) {
  const auto begin = steady_clock::now();
  (void)within(limit(), [&] { return unheard(peers).empty(); });
  EXPECT_THAT(unheard(peers), IsEmpty());
  const auto taken = (steady_clock::now() - begin) / milliseconds(1);
  std::cout << peers.size() << " heard each other after " << taken << " ms\n";
}

TEST(DefaultPeers, TwentyOnAHostWithAnInterfaceFindEachOtherAndUs) {
  const OtherComputer cable;
  if (!cable.is_there()) GTEST_SKIP() << "no right to make network namespaces";
  Peers peers;
  add(peers, "tocsin", 3, 11);
  add(peers, "cyclone", 10, 11);
  add(peers, "fast_dds", 10, 11);
  expect_all_hear_all(peers);
}

TEST(DefaultPeers, FindUsOnAHostThatHasLoopbackOnly) {
  Peers peers;
  add(peers, "tocsin", 12, 12);
  add(peers, "cyclone", 4, 12);
  add(peers, "fast_dds", 4, 12);
  expect_all_hear_all(peers);
}

TEST(ClosedHost, NeitherHearsNorIsHeardByAnotherComputerWhileDefaultPeersDoSo) {
  const OtherComputer other;
  if (!other.is_there()) GTEST_SKIP() << "no right to make network namespaces";
  const PeerProcess ours("tocsin", 13, "ours");
  const PeerProcess cyclone("cyclone", 13, "cyclone");
  const PeerProcess far_cyclone("cyclone", 13, "far_cyclone", other.pid());
  const PeerProcess far_fast_dds("fast_dds", 13, "far_fast_dds", other.pid());
  const auto unheard_here = [&] {
    std::vector<std::string> pairs;
    const auto note = [&](const PeerProcess& one, const PeerProcess& heard) {
      if (!one.has_heard(heard)) pairs.push_back(one.name() + " of " + heard.name());
    };
    note(ours, cyclone);
    note(cyclone, ours);
    note(cyclone, far_cyclone);
    note(far_cyclone, cyclone);
    note(cyclone, far_fast_dds);
    return pairs;
  };
  (void)within(patience, [&] { return unheard_here().empty(); });
  ASSERT_THAT(unheard_here(), IsEmpty());
  EXPECT_FALSE(within(long_enough, [&] {
    return ours.has_heard(far_cyclone) || ours.has_heard(far_fast_dds) ||
           far_cyclone.has_heard(ours) || far_fast_dds.has_heard(ours);
  }));
}

TEST(ClosedHost, SendsNothingToTheNetwork) {
  const OtherComputer other;
  if (!other.is_there()) GTEST_SKIP() << "no right to make network namespaces";
  const PacketTap tap(other.pid(), "eth1");
  ASSERT_TRUE(tap.ok());
  Peers peers;
  add(peers, "tocsin", 2, 14);
  expect_all_hear_all(peers);
  EXPECT_FALSE(within(long_enough, [&] { return !senders(tap).empty(); }))
      << ::testing::PrintToString(senders(tap));
}

// Default peers multicast themselves; what we say to them stays here nevertheless.
TEST(ClosedHost, SendsNothingToTheNetworkBesidePeersThatDo) {
  const OtherComputer other;
  if (!other.is_there()) GTEST_SKIP() << "no right to make network namespaces";
  const PacketTap tap(other.pid(), "eth1");
  ASSERT_TRUE(tap.ok());
  Peers peers;
  add(peers, "cyclone", 1, 15);
  add(peers, "tocsin", 2, 15);
  expect_all_hear_all(peers);
  for (int i = 0; i < 3; ++i) {  // whoever leaves the group last must not let anything out
    add(peers, "cyclone", 1, 15);
    expect_all_hear_all(peers);
    peers.pop_back();
  }
  EXPECT_THAT(senders(tap), Contains(of_cyclone));
  EXPECT_THAT(senders(tap), Not(Contains(of_fast_dds)));
}

}  // namespace
}  // namespace tocsin::interop
