// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

using std::chrono::seconds;

TEST(Rates, AnnouncementsOfASourceAreLimitedBySecond) {
  Limits limits;
  limits.announcements = {3, 2};
  RtpsFilter sut(limits);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a')), DropReason::too_many_announcements);
  EXPECT_EQ(drop_of(sut, announcement('b'), mallory), passes);  // another source
  EXPECT_EQ(drop_of(sut, announcement('a'), alice, t0 + seconds(1)), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), alice, t0 + seconds(1)), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), alice, t0 + seconds(1)),
            DropReason::too_many_announcements);
}

TEST(Rates, BytesOfASourceAreLimitedBySecond) {
  const Bytes message = heartbeat('a', 1, 1);
  const auto size = static_cast<double>(message.size());
  Limits limits;
  limits.bytes = {2 * size, size};
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, message), passes);
  EXPECT_EQ(drop_of(sut, message), passes);
  EXPECT_EQ(drop_of(sut, message), DropReason::too_many_bytes);
  EXPECT_EQ(drop_of(sut, message, alice, t0 + seconds(1)), passes);
}

TEST(Rates, PortsOfAnAddressAreOneSourceWhereSoWanted) {
  Limits limits;
  limits.announcements = {1, 0};
  limits.source_has_port = false;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('b'), mallory), DropReason::too_many_announcements);
}

TEST(Rates, ANewSourceTakesThePlaceOfTheOneSilentLongest) {
  Limits limits;
  limits.announcements = {1, 0};
  limits.sources = 2;
  RtpsFilter sut(limits);
  constexpr Source third{alice.address, 3};
  EXPECT_EQ(drop_of(sut, announcement('a'), alice, t0), passes);
  EXPECT_EQ(drop_of(sut, announcement('b'), mallory, t0 + seconds(1)), passes);
  EXPECT_EQ(drop_of(sut, announcement('c'), third, t0 + seconds(2)), passes);  // for alice
  EXPECT_EQ(drop_of(sut, announcement('b'), mallory, t0 + seconds(3)),
            DropReason::too_many_announcements);
}

TEST(Rates, AnAddressThatIsNotHeardIsDropped) {
  Limits limits;
  limits.hears = [](std::uint32_t address) { return address == ipv4(10, 0, 0, 2); };
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 1), {ipv4(10, 0, 0, 2), 7}), passes);
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 1), {ipv4(10, 0, 0, 3), 7}), DropReason::unknown_source);
}

}  // namespace
}  // namespace tocsin::rtps_filter
