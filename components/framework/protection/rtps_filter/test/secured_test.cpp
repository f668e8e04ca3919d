// SPDX-License-Identifier: Apache-2.0
// A participant with DDS Security, and what comes without a seal.
#include <gtest/gtest.h>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

using std::chrono::seconds;

std::array<std::uint8_t, 12> prefix(char name) {
  std::array<std::uint8_t, 12> octets{};
  octets.fill(static_cast<std::uint8_t>(name));
  return octets;
}

Limits secured_limits() {
  Limits limits;
  limits.secured = true;
  limits.participants = 2;
  limits.yields_after = seconds(1);
  limits.departure_wait = seconds(1);
  limits.longest_lease = seconds(300);
  return limits;
}

class Secured : public ::testing::Test {
 protected:
  void make_known(char name) {
    EXPECT_EQ(drop_of(sut, announced(name)), passes);
    sut.authenticate(prefix(name));
  }
  RtpsFilter sut{secured_limits()};
};

TEST_F(Secured, AuthenticatedParticipantDoesNotLeaveWithoutASeal) {
  make_known('a');
  EXPECT_EQ(drop_of(sut, departure('a', 'a')), DropReason::unauthenticated);
  EXPECT_EQ(drop_of(sut, departure('a', 'a')), DropReason::unauthenticated);
  EXPECT_EQ(sut.participants(), 1U);
}

TEST_F(Secured, AuthenticatedParticipantIsAnnouncedAsBefore) {
  make_known('a');
  EXPECT_EQ(drop_of(sut, announced('a')), passes);
  EXPECT_EQ(drop_of(sut, announced('a', 21)), DropReason::unauthenticated);
  EXPECT_TRUE(inspect(sut, announced('a'), alice, t0 + seconds(100)).before.empty());
}

TEST_F(Secured, AuthenticatedParticipantYieldsToNobodyAndTakesNoStrangersPlace) {
  for (const char name : {'a', 'b', 'c', 'd', 'e', 'f'}) make_known(name);
  EXPECT_EQ(drop_of(sut, announced('v')), passes);
  EXPECT_EQ(drop_of(sut, announced('w')), passes);
  EXPECT_EQ(drop_of(sut, announced('x')), DropReason::too_many_participants);
  make_known('v');
  make_known('w');
  EXPECT_EQ(drop_of(sut, announced('x'), alice, t0 + seconds(10)),
            DropReason::too_many_participants);
}

TEST_F(Secured, ParticipantThatDdsHasForgottenIsAStranger) {
  make_known('a');
  sut.forget(prefix('a'));
  EXPECT_EQ(sut.participants(), 0U);
  EXPECT_EQ(drop_of(sut, announced('a', 21)), passes);
  EXPECT_EQ(drop_of(sut, departure('a', 'a')), passes);
}

TEST_F(Secured, StrangerIsMetAnewWhenItsAnnouncementDiffers) {
  EXPECT_TRUE(inspect(sut, announced('a', 1000)).before.empty());
  sut.forget(prefix('a'));  // it was no more than a hint
  EXPECT_EQ(sut.participants(), 1U);
  const Inspection contrary = inspect(sut, announced('a'));
  EXPECT_EQ(contrary.drop, passes);
  ASSERT_EQ(contrary.before.size(), 1U);
  RtpsFilter other{Limits{}};
  (void)inspect(other, announced('a'));
  (void)inspect(other, contrary.before[0]);
  EXPECT_EQ(other.participants(), 0U);
  EXPECT_TRUE(inspect(sut, announced('a')).before.empty());
}

TEST_F(Secured, HandshakeThatDoesNotEndBeginsAnew) {
  (void)inspect(sut, announced('a'));
  EXPECT_TRUE(inspect(sut, announced('a'), alice, t0 + seconds(10)).before.empty());
  const Time late = t0 + seconds(10) + std::chrono::milliseconds(1);
  EXPECT_EQ(inspect(sut, announced('a'), alice, late).before.size(), 1U);
  EXPECT_TRUE(inspect(sut, announced('a'), alice, late).before.empty());
}

constexpr std::uint32_t secure_sedp_writer = 0xff0003c2;
constexpr std::uint32_t stateless_writer = 0x000201c3;

Bytes data(std::uint32_t writer, std::uint32_t reader = 0) {
  const Wire list = Wire().parameter(0x5a, guid_of('a', user_writer)).sentinel();
  return data_head(writer, 1, 16, reader).raw(parameters_payload(list)).bytes();
}

TEST_F(Secured, SampleOfAProtectedEndpointNeedsASeal) {
  for (const std::uint32_t writer :
       {user_writer, secure_sedp_writer, sedp_writer, 0xff0101c2U, 0x000300c3U}) {
    EXPECT_EQ(drop_of(sut, Message('a').add(0x15, with_data, data(writer)).bytes()),
              DropReason::unsealed)
        << writer;
  }
}

TEST_F(Secured, ReaderOfAProtectedEndpointNeedsASealWhoeverWrites) {
  const Bytes content =
      Wire().entity(0xff0003c7).entity(spdp_writer).number(1).number(1).u32(1).bytes();
  EXPECT_EQ(drop_of(sut, Message('a').add(0x07, 0, content).bytes()), DropReason::unsealed);
}

TEST_F(Secured, NumbersOfAProtectedEndpointNeedASeal) {
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 1)), DropReason::unsealed);
  EXPECT_EQ(drop_of(sut, gap('a', 1, 2)), DropReason::unsealed);
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 1, secure_sedp_writer)), DropReason::unsealed);
  EXPECT_EQ(drop_of(sut, heartbeat('a', 1, 0, sedp_writer)), passes);  // of what is not protected
  const Wire acknack = Wire().entity(0x00000107).entity(user_writer).number(1).u32(0).u32(1);
  EXPECT_EQ(drop_of(sut, Message('a').add(0x06, 0, acknack.bytes()).bytes()), DropReason::unsealed);
}

TEST_F(Secured, HandshakeNeedsNoSeal) {
  const Bytes message =
      Wire().raw({0, 1, 0, 0}).zeros(24 + 24 + 48).text("dds.sec.auth").u32(0).bytes();
  const Wire content = data_head(stateless_writer, 1, 16, 0x000201c4).raw(message);
  EXPECT_EQ(drop_of(sut, data_of(content)), passes);
}

TEST_F(Secured, SealOfAPartEndsWithIt) {
  const Bytes prefix_content(20, 0);
  Message message('a');
  message.add(0x31, 0, prefix_content).add(0x15, with_data, data(user_writer));
  message.add(0x32, 0, prefix_content);
  EXPECT_EQ(drop_of(sut, message.bytes()), passes);
  message.add(0x15, with_data, data(user_writer));
  EXPECT_EQ(drop_of(sut, message.bytes()), DropReason::unsealed);
}

/// Fast DDS opens it nowhere else, and reads on.
TEST_F(Secured, SealOfAMessageIsOneAtItsBeginOnly) {
  const Bytes seal(20, 0);
  EXPECT_EQ(
      drop_of(sut, Message('a').add(0x33, 0, seal).add(0x15, with_data, data(user_writer)).bytes()),
      passes);
  EXPECT_EQ(drop_of(sut, Message('a')
                             .add(0x01, 0, {0, 0, 0, 0})
                             .add(0x33, 0, seal)
                             .add(0x15, with_data, data(user_writer))
                             .bytes()),
            DropReason::unsealed);
}

TEST(Unsecured, LinkTakesWhatHasNoSeal) { EXPECT_EQ(drop_of(heartbeat('a', 1, 1)), passes); }

}  // namespace
}  // namespace tocsin::rtps_filter
