// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "captures.hpp"

namespace tocsin::rtps_filter {
namespace {

/// Captured with tshark on loopback; see captures/README.md.
class Traffic : public ::testing::TestWithParam<const char*> {};

TEST_P(Traffic, OfOrdinaryPeersPasses) {
  RtpsFilter sut{Limits{}};
  Time now = t0;
  for (const Captured& packet : read_captures(GetParam())) {
    now += std::chrono::milliseconds(1);
    EXPECT_EQ(drop_of(sut, packet.bytes, packet.from, now), passes);
  }
}

TEST_P(Traffic, PassesAgainUnderTheLimitsOfALink) {
  Limits limits;
  limits.participant_has_address = true;
  limits.source_has_port = false;
  limits.bytes = {8e6, 8e6};
  limits.yields_after = limits.departure_wait = std::chrono::seconds(1);
  limits.longest_lease = std::chrono::seconds(300);
  RtpsFilter sut(limits);
  for (const Captured& packet : read_captures(GetParam())) {
    EXPECT_EQ(drop_of(sut, packet.bytes, packet.from), passes);
  }
}

/// A packet that is cut short is never longer than it says: no submessage may be left open.
TEST_P(Traffic, CutShortIsDroppedOrEndsWithASubmessage) {
  std::size_t dropped = 0;
  std::size_t all = 0;
  for (const Captured& packet : read_captures(GetParam())) {
    for (std::size_t size = 0; size < packet.bytes.size(); size += 7) {
      const Bytes cut(packet.bytes.begin(),
                      packet.bytes.begin() + static_cast<std::ptrdiff_t>(size));
      dropped += drop_of(cut).has_value() ? 1U : 0U;
      ++all;
    }
  }
  EXPECT_GT(dropped, all * 9 / 10);
}

TEST(FragmentedAnnouncements, OfCycloneDdsAreShownWhole) {
  constexpr std::size_t endpoints = 6;
  RtpsFilter sut{Limits{}};
  std::size_t whole = 0;
  for (const Captured& packet : read_captures("cyclone_fragments")) {
    const Inspection inspection = inspect(sut, packet.bytes, packet.from);
    EXPECT_EQ(inspection.drop, passes);
    whole += inspection.before.empty() ? 0U : 1U;
  }
  EXPECT_GE(whole, endpoints);
}

/// Announcements and handshakes are open, all else is sealed.
TEST(SecuredTraffic, PassesWhereSealsAreOpened) {
  Limits limits;
  limits.secured = true;
  RtpsFilter sut(limits);
  for (const Captured& packet : read_captures("secured")) {
    EXPECT_EQ(drop_of(sut, packet.bytes, packet.from), passes);
  }
}

INSTANTIATE_TEST_SUITE_P(Vendors, Traffic,
                         ::testing::Values("fast_dds", "cyclone", "cyclone_fragments", "secured"));

}  // namespace
}  // namespace tocsin::rtps_filter
