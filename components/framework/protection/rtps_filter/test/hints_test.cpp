// SPDX-License-Identifier: Apache-2.0
// What strangers say of participants where that is a hint only, until traffic confirms it.
#include <gtest/gtest.h>

#include <array>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

Limits on_link() {
  Limits limits;
  limits.participants = 2;
  limits.yields_after = seconds(1);
  limits.departure_wait = seconds(1);
  limits.longest_lease = seconds(300);
  return limits;
}

constexpr std::size_t number_at = 20 + 4 + 12;
constexpr std::size_t lease_at = 20 + 4 + 20 + 4 + 20 + 8 + 4;

Bytes with_number_and_lease(Bytes bytes, std::int64_t number, double lease_s) {
  const Bytes numbers = Wire().number(number).bytes();
  std::copy(numbers.begin(), numbers.end(), bytes.begin() + number_at);
  const auto whole = static_cast<std::uint32_t>(lease_s);
  const Bytes lease = Wire().u32(whole).u32(0).bytes();
  std::copy(lease.begin(), lease.end(), bytes.begin() + lease_at);
  bytes[22] = bytes[23] = 0;  // the length of the DATA: until the end
  return bytes;
}

/// The packet as the participant is shown it.
Bytes shown(RtpsFilter& sut, const Bytes& bytes, Time now = t0) {
  return changed(bytes.data(), bytes.size(), inspect(sut, bytes, alice, now));
}

std::vector<Bytes> due_after(RtpsFilter& sut, const Bytes& bytes, Time now) {
  (void)inspect(sut, bytes, alice, now);
  return sut.take_due();
}

TEST(Lease, ThatIsTooLongIsShownAsTheLongest) {
  for (const std::uint32_t lease_s : {299U, 300U, 301U, 0x7fffffffU}) {
    RtpsFilter sut(on_link());
    const Bytes bytes = shown(sut, announced('a', lease_s));
    EXPECT_EQ(Bytes(bytes.begin() + lease_at, bytes.begin() + lease_at + 8),
              Wire().u32(std::min(lease_s, 300U)).u32(0).bytes());
  }
}

TEST(Departure, IsShownAsAShortLease) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a'));
  const Inspection inspection = inspect(sut, departure('a', 'a'));
  EXPECT_EQ(inspection.drop, passes);
  EXPECT_EQ(inspection.hide.size(), 1U);
  ASSERT_EQ(inspection.before.size(), 1U);
  EXPECT_EQ(inspection.before[0], with_number_and_lease(announced('a'), 2, 1));
}

TEST(Departure, ThatIsRepeatedChangesNothingMore) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a'));
  (void)inspect(sut, departure('a', 'a'));
  const Inspection again = inspect(sut, departure('a', 'a'), alice, t0 + milliseconds(900));
  EXPECT_EQ(again.hide.size(), 1U);
  EXPECT_TRUE(again.before.empty());
}

TEST(Departure, IsTakenBackByTrafficButNotByWhatWasOnItsWay) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a'));
  (void)inspect(sut, departure('a', 'a'));
  EXPECT_TRUE(due_after(sut, gap('a', 1, 2), t0 + milliseconds(299)).empty());
  EXPECT_TRUE(due_after(sut, departure('a', 'a'), t0 + milliseconds(300)).empty());
  const auto back = due_after(sut, gap('a', 1, 2), t0 + milliseconds(300));
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0], with_number_and_lease(announced('a'), 3, 20));
  EXPECT_TRUE(due_after(sut, gap('a', 1, 2), t0 + milliseconds(301)).empty());
}

TEST(Departure, OfWhomThereWasSilenceIsTakenBackByTheFirstPacket) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a'));
  (void)inspect(sut, departure('a', 'a'));
  EXPECT_EQ(due_after(sut, heartbeat('a', 1, 1), t0 + seconds(60)).size(), 1U);
}

TEST(Departure, OfOneParticipantIsNotTakenBackByAnother) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a'));
  (void)inspect(sut, announced('b'));
  (void)inspect(sut, departure('a', 'a'));
  EXPECT_TRUE(due_after(sut, heartbeat('b', 1, 1), t0 + seconds(1)).empty());
}

void supersede(RtpsFilter& sut, char name) {
  std::array<std::uint8_t, 12> prefix{};
  prefix.fill(static_cast<std::uint8_t>(name));
  sut.authenticate(prefix);
  sut.supersede(prefix, t0);
}

TEST(Superseded, ParticipantLeavesWhenItStaysSilent) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a'));
  supersede(sut, 'a');
  const auto due = sut.take_due();
  ASSERT_EQ(due.size(), 1U);
  EXPECT_EQ(due[0], with_number_and_lease(announced('a'), 2, 10));
  EXPECT_TRUE(sut.take_due().empty());
}

TEST(Superseded, ParticipantThatGoesOnStays) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a'));
  supersede(sut, 'a');
  (void)sut.take_due();
  const auto back = due_after(sut, heartbeat('a', 1, 1), t0 + seconds(5));
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0], with_number_and_lease(announced('a'), 3, 20));
}

TEST(Superseded, StrangerChangesNothing) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a'));
  supersede(sut, 'x');
  EXPECT_TRUE(sut.take_due().empty());
}

TEST(Announcement, ThatDiffersIsShownWithANumberThatIsNotIgnored) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a'));
  (void)inspect(sut, departure('a', 'a'));
  (void)inspect(sut, announced('a'), alice, t0 + seconds(1));  // taken back with number 3
  const Bytes other = announced('a', 30);
  const Bytes bytes = shown(sut, other, t0 + seconds(2));
  EXPECT_EQ(Bytes(bytes.begin() + number_at, bytes.begin() + number_at + 8),
            Wire().number(4).bytes());
}

/// Whether the first message that is shown before the newcomer says that `name` leaves.
bool yields(const Inspection& inspection, char name) {
  if (inspection.drop || inspection.before.size() != 1) return false;
  RtpsFilter sut{Limits{}};
  (void)inspect(sut, announced(name));
  (void)inspect(sut, inspection.before[0]);
  return sut.participants() == 0;
}

TEST(Newcomer, TakesThePlaceOfWhoWasSilentLongest) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a', 0x7fffffff));
  (void)inspect(sut, announced('b', 0x7fffffff), alice, t0 + milliseconds(1));
  EXPECT_EQ(drop_of(sut, announced('c'), alice, t0 + milliseconds(999)),
            DropReason::too_many_participants);
  EXPECT_TRUE(yields(inspect(sut, announced('c'), alice, t0 + milliseconds(1000)), 'a'));
  EXPECT_EQ(sut.participants(), 2U);
}

TEST(Newcomer, DoesNotTakeThePlaceOfWhoIsHeard) {
  RtpsFilter sut(on_link());
  (void)inspect(sut, announced('a'));
  (void)inspect(sut, announced('b'));
  (void)inspect(sut, heartbeat('a', 1, 1), alice, t0 + seconds(5));
  EXPECT_TRUE(yields(inspect(sut, announced('c'), alice, t0 + seconds(5)), 'b'));
}

TEST(Newcomer, ThatCouldNotLeaveIsDropped) {
  RtpsFilter sut(on_link());
  EXPECT_EQ(drop_of(sut, announcement('a')), DropReason::discovery_payload);
  EXPECT_EQ(drop_of(sut, announcement('a', Wire().parameter(0x58, Wire().u32(0xc3e).bytes()))),
            DropReason::discovery_payload);
}

/// A burst of strangers, whoever they are, is over for the next one after a second.
TEST(Newcomer, IsNotLockedOutByStrangersWithEndlessLeases) {
  Limits limits = on_link();
  limits.participants = 128;
  RtpsFilter sut(limits);
  for (int i = 0; i < 128; ++i) {
    (void)inspect(sut, announced(static_cast<char>(i), 0x7fffffff));
  }
  EXPECT_EQ(sut.participants(), 128U);
  EXPECT_EQ(drop_of(sut, announced('\xf0'), alice, t0 + seconds(1)), passes);
}

}  // namespace
}  // namespace tocsin::rtps_filter
