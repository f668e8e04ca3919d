// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

using std::chrono::seconds;

Wire lease(std::uint32_t lease_s) {
  return Wire().parameter(0x02, Wire().u32(lease_s).u32(0).bytes());
}

TEST(Participant, ThatSaysItselfThatItLeavesIsForgotten) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(sut.participants(), 1U);
  EXPECT_EQ(drop_of(sut, departure('a', 'a')), passes);
  EXPECT_EQ(sut.participants(), 0U);
}

TEST(Participant, IsNotDisposedByAnotherSource) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, departure('a', 'a'), mallory), DropReason::forged_disposal);
  EXPECT_EQ(sut.participants(), 1U);
}

TEST(Participant, IsNotDisposedByAnotherParticipant) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, departure('m', 'a'), mallory), DropReason::foreign_identity);
}

TEST(Participant, IsNotDisposedByASerializedKeyThatFastDdsTakesForAKeyHash) {
  const Wire qos = Wire().parameter(0x71, {0, 0, 0, 1}).sentinel();
  const Wire content = data_head(spdp_writer, 2).raw(qos.bytes()).raw(guid_of('a'));
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, data_of(content, with_qos | with_key, 'm'), mallory),
            DropReason::foreign_identity);
}

Wire user_data(const std::string& text) {
  return Wire().parameter(0x2c, Wire().text(text).bytes());
}

TEST(Participant, ThatIsNotToBeFoundIsHiddenAndNotDropped) {
  Limits limits;
  limits.finds = [](std::string_view data) { return data.find("of=b") == data.npos; };
  RtpsFilter sut{limits};
  const Inspection hidden = inspect(sut, announcement('b', user_data("of=b;")));
  EXPECT_EQ(hidden.drop, passes);
  EXPECT_EQ(hidden.hide.size(), 1U);
  EXPECT_EQ(sut.participants(), 0U);
  for (const Wire& data : {user_data("of=a;"), Wire()}) {
    const Inspection shown = inspect(sut, announcement('a', data));
    EXPECT_EQ(shown.drop, passes);
    EXPECT_TRUE(shown.hide.empty());
  }
  EXPECT_EQ(sut.participants(), 1U);
}

// What an endpoint says of itself is its own.
TEST(Participant, ItsEndsAreFoundWhateverTheirUserData) {
  Limits limits;
  limits.finds = [](std::string_view data) { return data.empty(); };
  RtpsFilter sut{limits};
  (void)inspect(sut, announcement('a'));
  const Inspection shown = inspect(sut, announcement('a', user_data("of=b;"), sedp_writer));
  EXPECT_EQ(shown.drop, passes);
  EXPECT_TRUE(shown.hide.empty());
}

TEST(Participant, NobodyKnowsMayLeave) { EXPECT_EQ(drop_of(departure('a', 'a')), passes); }

TEST(Participant, IsNotAnnouncedByAnotherSourceOnceItsSocketsAreKnown) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), mallory, t0 + seconds(61)), DropReason::forged_source);
  EXPECT_EQ(drop_of(sut, announcement('a'), alice, t0 + seconds(61)), passes);
}

TEST(Participant, MayHaveASocketForEachInterfaceAndGroup) {
  constexpr Source second{ipv4(192, 168, 7, 5), 40002};
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), second, t0 + seconds(60)), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), second, t0 + seconds(90)), passes);
  EXPECT_EQ(drop_of(sut, departure('a', 'a'), second, t0 + seconds(90)), passes);
}

TEST(Participant, MaySpeakByAnotherInterfaceWithTheSameSocketAtAnyTime) {
  constexpr Source by_other{ipv4(192, 168, 7, 5), alice.port};
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), by_other, t0 + seconds(61)), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), {by_other.address, 9}, t0 + seconds(61)),
            DropReason::forged_source);
  EXPECT_EQ(drop_of(sut, departure('a', 'a'), {by_other.address, 9}), DropReason::forged_disposal);
  EXPECT_EQ(drop_of(sut, departure('a', 'a'), by_other), passes);
  EXPECT_EQ(sut.participants(), 0U);
}

TEST(Participant, HasNotMoreThanEightSockets) {
  RtpsFilter sut{Limits{}};
  for (std::uint16_t port = 1; port <= 8; ++port) {
    EXPECT_EQ(drop_of(sut, announcement('a'), {alice.address, port}), passes);
  }
  EXPECT_EQ(drop_of(sut, announcement('a'), {alice.address, 9}), DropReason::forged_source);
}

TEST(Participant, SpeaksFromOneAddressWhereThatIsFixed) {
  constexpr Source other_port{alice.address, 40002};
  constexpr Source other_address{ipv4(10, 0, 0, 9), 40001};
  Limits limits;
  limits.participant_has_address = true;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(10))), passes);
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 5), other_port), passes);
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 5), other_address), DropReason::forged_source);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(10)), alice, t0 + seconds(61)), passes);
  // Its lease is over, and Fast DDS has forgotten it.
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 5), other_address, t0 + seconds(72)), passes);
}

TEST(Participant, IsAdmittedWhileThereIsRoom) {
  Limits limits;
  limits.participants = 2;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(10))), passes);
  EXPECT_EQ(drop_of(sut, announcement('b', lease(100))), passes);
  EXPECT_EQ(drop_of(sut, announcement('c')), DropReason::too_many_participants);
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
}

TEST(Participant, WhoseLeaseIsOverMakesRoom) {
  Limits limits;
  limits.participants = 2;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(10))), passes);
  EXPECT_EQ(drop_of(sut, announcement('b', lease(100))), passes);
  EXPECT_EQ(drop_of(sut, announcement('c'), alice, t0 + seconds(10)),
            DropReason::too_many_participants);
  EXPECT_EQ(drop_of(sut, announcement('c'), alice, t0 + seconds(11)), passes);
  EXPECT_EQ(sut.participants(), 2U);
}

TEST(Participant, ThatIsHeardKeepsItsPlace) {
  Limits limits;
  limits.participants = 1;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(10))), passes);
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 1), alice, t0 + seconds(8)), passes);
  EXPECT_EQ(drop_of(sut, announcement('b'), alice, t0 + seconds(15)),
            DropReason::too_many_participants);
}

TEST(Participant, WhoseLeaseIsForEverKeepsItsPlace) {
  Limits limits;
  limits.participants = 1;
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a', lease(0x7fffffff))), passes);
  EXPECT_EQ(drop_of(sut, announcement('b'), alice, t0 + std::chrono::hours(24)),
            DropReason::too_many_participants);
}

TEST(Participant, MayLeaveAndComeAgainFromAnotherSource) {
  RtpsFilter sut{Limits{}};
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, departure('a', 'a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a'), mallory), passes);
}

TEST(Endpoints, AreAdmittedWhileThereIsRoom) {
  Limits limits;
  limits.endpoints = 2;
  RtpsFilter sut(limits);
  const auto endpoint = [](std::uint32_t entity) {
    const Wire list = Wire().parameter(0x5a, guid_of('a', entity)).sentinel();
    return data_of(data_head(sedp_writer).raw(parameters_payload(list)));
  };
  const auto gone = [](std::uint32_t entity) {
    const Wire qos =
        Wire().parameter(0x71, {0, 0, 0, 3}).parameter(0x70, guid_of('a', entity)).sentinel();
    return data_of(data_head(sedp_writer).raw(qos.bytes()), with_qos);
  };
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, endpoint(1)), passes);
  EXPECT_EQ(drop_of(sut, endpoint(2)), passes);
  EXPECT_EQ(drop_of(sut, endpoint(2)), passes);
  EXPECT_EQ(drop_of(sut, endpoint(3)), DropReason::too_many_endpoints);
  EXPECT_EQ(drop_of(sut, gone(1)), passes);
  EXPECT_EQ(drop_of(sut, endpoint(3)), passes);
  EXPECT_EQ(drop_of(sut, departure('a', 'a')), passes);
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, endpoint(4)), passes);
}

TEST(Gaps, OfAParticipantAreLimitedBySecond) {
  Limits limits;
  limits.gap_rate = {1000, 10};
  RtpsFilter sut(limits);
  EXPECT_EQ(drop_of(sut, announcement('a')), passes);
  EXPECT_EQ(drop_of(sut, gap('a', 1, 1001)), passes);
  EXPECT_EQ(drop_of(sut, gap('a', 1, 2)), DropReason::gap_range);
  EXPECT_EQ(drop_of(sut, gap('a', 1, 11), alice, t0 + seconds(1)), passes);
}

}  // namespace
}  // namespace tocsin::rtps_filter
