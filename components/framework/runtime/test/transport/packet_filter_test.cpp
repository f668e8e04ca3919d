// SPDX-License-Identifier: Apache-2.0
#include "transport/packet_filter.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <thread>

#include "watch/dropped_packets.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;
using rtps_filter::ipv4;

rtps::Locator_t locator_of(const std::string& address, std::uint16_t port = 4711) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  rtps::IPLocator::setIPv4(locator, address);
  locator.port = port;
  return locator;
}

/// DATA(p) with one locator, which begins at `locator_at`.
constexpr std::size_t locator_at = 20 + 4 + 20 + 4 + 20;
std::vector<std::uint8_t> announcement(std::uint8_t last_octet) {
  std::vector<std::uint8_t> bytes{'R', 'T', 'P', 'S', 2, 1, 1, 3};
  const auto add = [&](const std::vector<std::uint8_t>& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
  };
  const std::vector<std::uint8_t> prefix(12, 7);
  add(prefix);
  add({0x15, 5, 20 + 4 + 20 + 28 + 8 + 12 + 4, 0, 0, 0, 16, 0, 0, 0, 0, 0, 0, 1, 0, 0xc2});
  add({0, 0, 0, 0, 1, 0, 0, 0, 0, 3, 0, 0});
  add({0x50, 0, 16, 0});
  add(prefix);
  add({0, 0, 1, 0xc1});
  add({0x32, 0, 24, 0, 1, 0, 0, 0, 0xf2, 0x1c, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  add({10, 77, 0, last_octet});
  add({0x58, 0, 4, 0, 0x3f, 0, 0, 0});         // its builtin endpoints
  add({2, 0, 8, 0, 20, 0, 0, 0, 0, 0, 0, 0});  // its lease
  add({1, 0, 0, 0});
  return bytes;
}

std::vector<std::uint8_t> shown(PacketFilter& sut, const std::vector<std::uint8_t>& packet,
                                const rtps::Locator_t& from) {
  std::vector<std::uint8_t> seen;
  sut.pass(packet.data(), packet.size(), from, PacketFilter::Port::discovery,
           [&](const std::uint8_t* bytes, std::size_t size) {
             seen.insert(seen.end(), bytes, bytes + size);
           });
  return seen;
}

const Surroundings radio{"10.77.0.1", {"10.77.0.2"}, true};

TEST(PacketFilter, OnTheRadioOnlyPeersAreHeard) {
  PacketFilter sut(limits_in(radio));
  const auto before = dropped_packets();
  EXPECT_EQ(shown(sut, announcement(2), locator_of("10.77.0.2")), announcement(2));
  EXPECT_TRUE(shown(sut, announcement(2), locator_of("10.77.0.3")).empty());
  const auto dropped = dropped_packets().since(before);
  EXPECT_EQ(dropped.count(rtps_filter::DropReason::unknown_source), 1U);
  EXPECT_EQ(dropped.by_source().count(ipv4(10, 77, 0, 3)), 1U);
}

TEST(PacketFilter, WhatIsSaidOfASupersededParticipantIsShownAtThePortOfDiscovery) {
  PacketFilter sut(limits_in(radio));
  const auto from = locator_of("10.77.0.2");
  (void)shown(sut, announcement(2), from);
  rtps::GuidPrefix_t participant;
  std::fill_n(participant.value, rtps::GuidPrefix_t::size, rtps::octet{7});
  sut.supersede(participant);
  std::size_t messages = 0;
  const auto pass = [&](PacketFilter::Port at) {
    const auto packet = announcement(2);
    sut.pass(packet.data(), packet.size(), from, at, [&](auto, auto) { ++messages; });
    return std::exchange(messages, 0);
  };
  EXPECT_EQ(pass(PacketFilter::Port::user_data), 1U);
  EXPECT_EQ(pass(PacketFilter::Port::discovery), 2U);
  EXPECT_EQ(pass(PacketFilter::Port::discovery), 1U);
}

TEST(PacketFilter, PortsOfDiscoveryAreEven) {
  EXPECT_EQ(PacketFilter::kind_of(7400), PacketFilter::Port::discovery);
  EXPECT_EQ(PacketFilter::kind_of(7410 + 250), PacketFilter::Port::discovery);
  EXPECT_EQ(PacketFilter::kind_of(7401), PacketFilter::Port::user_data);
  EXPECT_EQ(PacketFilter::kind_of(7411), PacketFilter::Port::user_data);
}

TEST(PacketFilter, LocatorOfAThirdIsNotShownAndNothingElseChanges) {
  PacketFilter sut(limits_in(radio));
  auto expected = announcement(9);
  expected[locator_at] = 0;
  EXPECT_EQ(shown(sut, announcement(9), locator_of("10.77.0.2")), expected);
}

/// A HEARTBEAT whose first number, 2^32, is far ahead.
std::vector<std::uint8_t> far_heartbeat() {
  std::vector<std::uint8_t> bytes{'R', 'T', 'P', 'S', 2, 1, 1, 3};
  bytes.insert(bytes.end(), 12, 7);
  for (const int byte : {7, 1, 28, 0, 0, 0, 0, 0, 0, 0, 1, 3, 1, 0, 0, 0,
                         0, 0, 0,  0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}) {
    bytes.push_back(static_cast<std::uint8_t>(byte));
  }
  return bytes;
}

TEST(PacketFilter, HeartbeatThatIsFarAheadIsShownAsAStepAndCounted) {
  PacketFilter sut(limits_in(radio));
  const auto before = dropped_packets();
  const auto seen = shown(sut, far_heartbeat(), locator_of("10.77.0.2"));
  auto expected = far_heartbeat();
  const std::vector<std::uint8_t> numbers{0, 0, 0, 0, 1, 0, 0x10, 0, 0, 0, 0, 0, 0, 0, 0x10, 0};
  std::copy(numbers.begin(), numbers.end(), expected.end() - 20);
  EXPECT_EQ(seen, expected);
  EXPECT_EQ(dropped_packets().since(before).count(rtps_filter::DropReason::sequence_jump), 1U);
}

TEST(PacketFilter, HeartbeatsThatAreFarAheadMayCostSoMuchAndNoMore) {
  rtps_filter::Limits limits = limits_in(radio);
  limits.jump_cpu_s = {0.002, 0};
  PacketFilter sut(limits);
  const auto packet = far_heartbeat();
  int count = 0;
  const auto walk = [&](const std::uint8_t*, std::size_t) {
    ++count;
    const std::clock_t begin = std::clock();
    while (std::clock() - begin < CLOCKS_PER_SEC / 1000) continue;
  };
  for (int i = 0; i < 100; ++i) {
    sut.pass(packet.data(), packet.size(), locator_of("10.77.0.2"), PacketFilter::Port::discovery,
             walk);
  }
  EXPECT_GE(count, 2);
  EXPECT_LT(count, 10);
}

TEST(PacketFilter, AnnouncementInFragmentsIsShownWholeAndTheFragmentsNot) {
  PacketFilter sut(limits_in(radio));
  auto whole = announcement(2);
  whole[22] = whole[23] = 0;  // until the end of the message
  const std::size_t payload_at = 20 + 4 + 20;
  const std::size_t bytes = whole.size() - payload_at;
  // One fragment: the DATA with another kind and, behind the number, what a DATA_FRAG has more.
  std::vector<std::uint8_t> packet = whole;
  packet[20] = 0x16;
  packet[21] = 1;
  packet[26] = 28;
  const auto size = static_cast<std::uint8_t>(bytes);
  const std::vector<std::uint8_t> more{1, 0, 0, 0, 1, 0, size, 0, size, 0, 0, 0};
  packet.insert(packet.begin() + payload_at, more.begin(), more.end());
  auto expected = whole;
  expected.insert(expected.end(), packet.begin(), packet.end());
  expected[whole.size() + 20] = 1;  // PAD
  EXPECT_EQ(shown(sut, packet, locator_of("10.77.0.2")), expected);
}

// An address that is gone, too, as its peer goes on announcing it: the transport sends to loopback.
TEST(PacketFilter, OnTheHostEveryLocatorIsShown) {
  PacketFilter sut(limits_in({"127.0.0.1", {}, false}));
  EXPECT_EQ(shown(sut, announcement(9), locator_of("127.0.0.1")), announcement(9));
}

TEST(PacketFilter, CountsWhatSeveralThreadsDrop) {
  PacketFilter sut(limits_in(radio));
  const auto before = dropped_packets();
  const auto receive = [&sut] {
    for (int i = 0; i < 1000; ++i) (void)shown(sut, announcement(2), locator_of("10.77.0.3"));
  };
  std::thread one(receive);
  std::thread other(receive);
  one.join();
  other.join();
  EXPECT_EQ(dropped_packets().since(before).total(), 2000U);
}

TEST(PacketFilter, OnTheRadioOnlyPeersAreAnswered) {
  const auto limits = limits_in(radio);
  EXPECT_TRUE(limits.answers(ipv4(10, 77, 0, 2)));
  EXPECT_FALSE(limits.answers(ipv4(127, 0, 0, 1)));
  EXPECT_FALSE(limits.answers(ipv4(239, 255, 0, 1)));
}

}  // namespace
}  // namespace tocsin
