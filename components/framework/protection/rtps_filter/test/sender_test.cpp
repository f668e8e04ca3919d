// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

Bytes sample() { return data_of(data_head(user_writer).raw(small_payload())); }

/// The departure of `a`, and in the same message something else of it.
Bytes goodbye_and(const Bytes& other) {
  Bytes both = departure('a', 'a');
  both.insert(both.end(), other.begin() + 20, other.end());
  return both;
}

TEST(Sender, WhatAnotherUserSaysIsDroppedWhateverItIs) {
  for (const Bytes& packet : {sample(), announcement('a'), announcement('b'), departure('a', 'a'),
                              heartbeat('a', 1, 5), Bytes{}}) {
    EXPECT_EQ(drop_of(packet, Sender::other), DropReason::other_user);
  }
}

TEST(Sender, WhatATrustedOneSaysPasses) {
  for (const Bytes& packet :
       {sample(), announcement('a'), announcement('b'), departure('a', 'a')}) {
    EXPECT_EQ(drop_of(packet, Sender::trusted), passes);
  }
}

TEST(Sender, WhoseSocketIsGoneMayOnlyHaveLeft) {
  EXPECT_EQ(drop_of(departure('a', 'a'), Sender::gone), passes);
  for (const Bytes& packet : {sample(), announcement('a'), announcement('b'), heartbeat('a', 1, 5),
                              gap('a', 1, 2), goodbye_and(sample()), goodbye_and(announcement('a')),
                              goodbye_and(heartbeat('a', 1, 5)), Message('a').bytes()}) {
    EXPECT_EQ(drop_of(packet, Sender::gone), DropReason::closed_socket);
  }
}

// An endpoint that leaves is no proof: its participant may be there.
TEST(Sender, WhoseSocketIsGoneCannotTakeAnEndpointAway) {
  const Wire qos = Wire().parameter(0x71, {0, 0, 0, 3}).parameter(0x70, guid_of('a')).sentinel();
  const Bytes packet = data_of(data_head(sedp_writer).raw(qos.bytes()), with_qos);
  EXPECT_EQ(drop_of(packet, Sender::trusted), passes);
  EXPECT_EQ(drop_of(packet, Sender::gone), DropReason::closed_socket);
}

TEST(Sender, NothingOfAnotherUserIsRemembered) {
  RtpsFilter sut{Limits{}};
  const Bytes packet = announcement('b');
  EXPECT_EQ(sut.inspect(packet.data(), packet.size(), alice, t0, Sender::other).drop,
            DropReason::other_user);
  EXPECT_EQ(sut.inspect(packet.data(), packet.size(), alice, t0, Sender::gone).drop,
            DropReason::closed_socket);
  EXPECT_EQ(sut.participants(), 0U);
}

}  // namespace
}  // namespace tocsin::rtps_filter
